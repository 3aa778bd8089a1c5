#include "tautline/planners/contact_free/refine_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tautline/planners/contact_free/reference_path.h"

namespace tautline {
namespace {

/// Gains below this are no gains.
constexpr double kLeastGain = 1e-9;

/// So many points at the beginning, and directions in which they are moved far.
constexpr std::size_t kBeginning = 4;
constexpr int kDirections = 12;

bool TouchesAnything(const TrackResult& track) { return track.cable_obstacle_steps + track.cable_robot_steps > 0; }

class Refining {
 public:
  Refining(const TetherEnv& env, const RefinePathOptions& options) : env_(env), options_(options) {}

  RefinedPath Run(const Polyline& path) {
    // As it is, and with fewer points.
    best_.cost = std::numeric_limits<double>::infinity();
    Try(path);
    Polyline sparse = {path.front()};
    double along = 0;
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      along += Distance(path[i - 1], path[i]);
      if (along < options_.spacing_m) continue;
      sparse.push_back(path[i]);
      along = 0;
    }
    sparse.push_back(path.back());
    const RefinedPath dense = best_;
    best_.cost = std::numeric_limits<double>::infinity();
    Try(std::move(sparse));
    if (std::isfinite(best_.cost)) Descend();
    if (std::isfinite(best_.cost) && !TouchesAnything(best_.track)) LeaveOut();
    if (dense.cost < best_.cost) best_ = dense;
    return std::move(best_);
  }

 private:
  /// Other beginnings: whether the robot turns left or right, wide or on the spot, decides where its tail sweeps.
  void BeginOtherwise() {
    for (std::size_t i = 1; i < std::min(kBeginning, best_.path.size()); ++i) {
      for (const double far_m : {0.6, 1.2}) {
        for (int k = 0; k < kDirections; ++k) {
          const double angle = 2 * std::numbers::pi * k / kDirections;
          Shift(i, far_m * Point{std::cos(angle), std::sin(angle)}, 0.5);
        }
      }
    }
  }

  /// Leaves out runs of points, long ones first: loops that the path can do without.
  void LeaveOut() {
    for (const std::size_t count : {12, 8, 6, 4, 3}) {
      for (std::size_t i = 1; i + count < best_.path.size();) {
        Polyline path = best_.path;
        const auto from = path.begin() + static_cast<std::ptrdiff_t>(i);
        path.erase(from, from + static_cast<std::ptrdiff_t>(count));
        if (!Try(std::move(path))) ++i;
      }
    }
  }

  void Descend() {
    if (TouchesAnything(best_.track)) BeginOtherwise();
    for (const double step_m : options_.steps_m) {
      for (int round = 0; round < options_.rounds; ++round) {
        const double before = best_.cost;
        for (std::size_t i = 1; i < best_.path.size(); ++i) {
          Move(i, step_m);
        }
        if (before - best_.cost < 0.01 * options_.per_metre) break;
      }
    }
  }

  /// Tries other places for a point; its neighbours follow half the way.
  void Move(std::size_t i, double step_m) {
    const Polyline& path = best_.path;
    const bool last = i + 1 == path.size();
    const Point way = (last ? path[i] : path[i + 1]) - path[i - 1];
    const double norm = Norm(way);
    if (norm == 0) return;
    const Point along = (step_m / norm) * way, aside{-along.y, along.x};
    if (!last && Shift(i, 0.5 * (path[i - 1] + path[i + 1]) - path[i], 0)) return;
    for (const Point by : std::array<Point, 4>{aside, -1 * aside, along, -1 * along}) {
      for (const double follow : {0.5, 0.0}) {
        if (Shift(i, by, follow)) return;
      }
    }
  }

  bool Shift(std::size_t i, Point by, double follow) {
    Polyline path = best_.path;
    path[i] = path[i] + by;
    if (i > 1) path[i - 1] = path[i - 1] + follow * by;
    if (i + 1 < path.size()) path[i + 1] = path[i + 1] + follow * by;
    return Try(std::move(path));
  }

  bool Try(Polyline path) {
    stopped_ = stopped_ || (options_.keep_going && !options_.keep_going());
    if (stopped_) return false;
    TrackResult track = TrackPath(env_, path);
    if (!track.success()) return false;
    const double cost = options_.per_metre * track.driven_m - track.reward;
    if (cost >= best_.cost - kLeastGain) return false;
    best_.path = std::move(path);
    best_.track = std::move(track);
    best_.cost = cost;
    return true;
  }

  const TetherEnv& env_;
  const RefinePathOptions& options_;
  RefinedPath best_;
  bool stopped_ = false;
};

}  // namespace

RefinedPath RefinePath(const TetherEnv& env, const Polyline& path, const RefinePathOptions& options) {
  return Refining(env, options).Run(path);
}

}  // namespace tautline
