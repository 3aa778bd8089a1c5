#include "tautline/planners/contact_free/pure_pursuit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Nearer than this the robot is at a point, metres: far below a step, far above rounding.
constexpr double kAtPoint = 1e-6;
/// A robot that looks this well at a point need not turn, radians.
constexpr double kAligned = 1e-6;

}  // namespace

PurePursuit::PurePursuit(Polyline path, const PurePursuitOptions& options) : path_(std::move(path)), options_(options) {
  TAUTLINE_CHECK(!path_.empty());
  reached_m_.push_back(0);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    reached_m_.push_back(reached_m_.back() + Distance(path_[i - 1], path_[i]));
  }
}

Point PurePursuit::PointAt(double along_m) const {
  const auto after = std::upper_bound(reached_m_.begin(), reached_m_.end(), along_m);
  if (after == reached_m_.end()) return path_.back();
  const auto i = static_cast<std::size_t>(after - reached_m_.begin());
  return Lerp(path_[i - 1], path_[i], (along_m - reached_m_[i - 1]) / (reached_m_[i] - reached_m_[i - 1]));
}

double PurePursuit::AngleTo(const RobotPose& pose, Point target) {
  const Point way = target - pose.at;
  return std::remainder(std::atan2(way.y, way.x) - pose.heading_rad, 2 * std::numbers::pi);
}

void PurePursuit::MoveOn(Point robot, double reach_m) {
  const double from = along_m_, to = std::min(along_m_ + reach_m, reached_m_.back());
  double least = Distance(robot, PointAt(from));
  for (std::size_t i = 1; i < path_.size() && reached_m_[i - 1] <= to; ++i) {
    if (reached_m_[i] <= from || reached_m_[i] == reached_m_[i - 1]) continue;
    const Point a = path_[i - 1], way = path_[i] - a;
    const double length = reached_m_[i] - reached_m_[i - 1];
    const double at = std::clamp(reached_m_[i - 1] + Dot(robot - a, way) / length, std::max(from, reached_m_[i - 1]),
                                 std::min(to, reached_m_[i]));
    const double distance = Distance(robot, PointAt(at));
    if (distance >= least) continue;
    least = distance;
    along_m_ = at;
  }
}

Velocity PurePursuit::Steer(const RobotPose& pose, double lookahead_m) const {
  TAUTLINE_CHECK(lookahead_m > 0);
  const Point target = PointAt(along_m_ + lookahead_m);
  const double distance = Distance(pose.at, target);
  if (distance <= kAtPoint) return {};
  const double angle = AngleTo(pose, target);
  if (std::abs(angle) > std::numbers::pi / 2) return TurnTowards(pose, lookahead_m);
  // The arc through robot and target, tangent to the heading, has this curvature.
  const double curvature = 2 * std::sin(angle) / distance;
  double speed = std::min(options_.speed_m_per_s, distance / options_.dt_s);
  if (std::abs(curvature) * speed > options_.turn_rad_per_s) speed = options_.turn_rad_per_s / std::abs(curvature);
  return {speed, curvature * speed};
}

Velocity PurePursuit::TurnTowards(const RobotPose& pose, double lookahead_m) const {
  const Point target = PointAt(along_m_ + lookahead_m);
  const double angle = AngleTo(pose, target), most = options_.turn_rad_per_s;
  if (Distance(pose.at, target) <= kAtPoint || std::abs(angle) <= kAligned) return {};
  return {0, std::clamp(angle / options_.dt_s, -most, most)};
}

}  // namespace tautline
