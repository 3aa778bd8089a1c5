#include "tautline/planners/contact_free/driver_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace tautline {
namespace {

/// So many way-points ahead are looked at for progress.
constexpr std::size_t kNextWaypoints = 6;

/// The frame of the robot, in which a length of kViewReach radii is 1.
class Frame {
 public:
  explicit Frame(const TetherEnv& env)
      : origin_(env.pose().at),
        ahead_{std::cos(env.pose().heading_rad), std::sin(env.pose().heading_rad)},
        reach_m_(kViewReach * env.options().robot_radius_m) {}

  double reach_m() const { return reach_m_; }
  double Scale(double length_m) const { return std::clamp(length_m / reach_m_, -1.0, 1.0); }
  /// The place of p, moved straight towards the robot where it is too far away.
  Point Place(Point p) const {
    const Point off = p - origin_;
    const double share = 1 / std::max(reach_m_, Norm(off));
    return share * Point{Dot(ahead_, off), Cross(ahead_, off)};
  }
  /// The direction of a ray in the plane.
  Point Ray(int ray) const {
    const double angle = 2 * std::numbers::pi * ray / kViewRays;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * ahead_.x - s * ahead_.y, s * ahead_.x + c * ahead_.y};
  }
  /// The ray nearest to a place of this frame.
  static int RayOf(Point place) {
    const double turns = std::atan2(place.y, place.x) / (2 * std::numbers::pi);
    return static_cast<int>(std::lround(turns * kViewRays) + kViewRays) % kViewRays;
  }

 private:
  Point origin_, ahead_;
  double reach_m_;
};

/// Where the ground around a ray is free for less than this share of its length, the ray ends: it would never get
/// through a cell of the map that is all but blocked.
constexpr double kLeastStep = 1e-6;

/// How far the ground is surely free along a ray: steps as long as the ground around is free.
double FreeAlong(const ContactMap& map, Point from, Point direction, double reach_m) {
  double along_m = 0;
  while (along_m < reach_m) {
    const double clear_m = map.ClearAround(from + along_m * direction);
    if (clear_m <= kLeastStep * reach_m) return along_m;
    along_m += clear_m;
  }
  return reach_m;
}

/// Writes numbers one after the other.
class Writer {
 public:
  explicit Writer(DriverView& view) : view_(&view) {}
  void Add(double value) { (*view_)[at_++] = static_cast<float>(value); }
  void Add(Point place) {
    Add(place.x);
    Add(place.y);
  }

 private:
  DriverView* view_;
  std::size_t at_ = 0;
};

/// By ray: how near the cable comes, of nodes and middles of links that are a robot radius of cable from the tail.
std::array<double, kViewRays> CableAround(const TetherEnv& env, const Frame& frame) {
  std::array<double, kViewRays> nearest;
  nearest.fill(1);
  const std::span<const Point> nodes = env.cable().nodes();
  const auto see = [&](Point p) {
    const Point place = frame.Place(p);
    double& there = nearest[static_cast<std::size_t>(Frame::RayOf(place))];
    there = std::min(there, Norm(place));
  };
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    see(nodes[i]);
    if (i + 2 < nodes.size()) see(0.5 * (nodes[i] + nodes[i + 1]));
  }
  return nearest;
}

}  // namespace

std::size_t AdvanceAlong(const TetherEnv& env, std::size_t waypoint) {
  const Polyline& waypoints = env.task().waypoints;
  std::size_t best = waypoint;
  for (std::size_t i = waypoint; i < std::min(waypoint + kNextWaypoints, waypoints.size()); ++i) {
    if (Distance(waypoints[i], env.pose().at) <= Distance(waypoints[best], env.pose().at)) best = i;
  }
  return best;
}

DriverView LookAround(const TetherEnv& env, std::size_t waypoint) {
  DriverView view{};
  Writer writer(view);
  const Frame frame(env);
  const Point robot = env.pose().at;
  for (int ray = 0; ray < kViewRays; ++ray) {
    writer.Add(frame.Scale(FreeAlong(env.map(), robot, frame.Ray(ray), frame.reach_m())));
  }
  for (const double near : CableAround(env, frame)) writer.Add(near);
  const std::span<const Point> nodes = env.cable().nodes();
  for (std::size_t k = 1; k <= kViewNodes; ++k) {
    const Point node = nodes[nodes.size() - 1 - std::min(k, nodes.size() - 1)];
    writer.Add(frame.Place(node));
    writer.Add(frame.Scale(4 * env.map().ClearAround(node)));
  }
  const Polyline& waypoints = env.task().waypoints;
  for (std::size_t ahead = 1; ahead < (1U << kViewAhead); ahead *= 2) {
    writer.Add(frame.Place(waypoint + ahead < waypoints.size() ? waypoints[waypoint + ahead] : env.task().goal));
  }
  const double cable_m = env.task().cable_length_m;
  writer.Add(frame.Scale(Distance(robot, env.task().goal)));
  writer.Add(std::min(1.0, Distance(env.cable().base(), env.cable().tail()) / cable_m));
  writer.Add(std::clamp(1 - env.cable().paid_out_m() / cable_m, 0.0, 1.0));
  writer.Add(frame.Scale(waypoints.empty() ? 0 : Distance(robot, waypoints[waypoint])));
  return view;
}

}  // namespace tautline
