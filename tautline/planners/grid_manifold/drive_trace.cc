#include "tautline/planners/grid_manifold/drive_trace.h"

#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Keeps the ends, and of what lies between the point farthest from their line while it is too far [Douglas1973].
void KeepFarthest(const Polyline& line, std::size_t first, std::size_t last, double tolerance_m,
                  std::vector<bool>& kept) {
  double farthest = tolerance_m;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = Distance(line[i], NearestOnSegment(line[i], line[first], line[last]));
    if (distance > farthest) {
      farthest = distance;
      at = i;
    }
  }
  if (at == first) return;
  kept[at] = true;
  KeepFarthest(line, first, at, tolerance_m, kept);
  KeepFarthest(line, at, last, tolerance_m, kept);
}

Polyline Thinned(const Polyline& line, double tolerance_m) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size(), false);
  kept.front() = kept.back() = true;
  KeepFarthest(line, 0, line.size() - 1, tolerance_m, kept);
  Polyline thinned;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (kept[i]) thinned.push_back(line[i]);
  }
  return thinned;
}

}  // namespace

std::vector<DriveFrame> TraceDrive(const GridManifold& manifold, const DriveState& start, const DriveResult& result,
                                   const RobotOptions& robot, const TraceOptions& options) {
  TAUTLINE_CHECK(options.sample_s > 0);
  std::vector<DriveFrame> frames;
  const auto take = [&](const Cable& cable) {
    frames.push_back({cable.time_s(), cable.robot(), Thinned(cable.Shape(), options.tolerance_m)});
  };
  take(start.cable);
  const DriveState end = Replay(manifold, start, result.end.way, robot, [&](const Cable& cable) {
    if (cable.time_s() >= frames.back().t_s + options.sample_s) take(cable);
  });
  TAUTLINE_CHECK(end.at == result.end.at && end.cable.robot() == result.end.cable.robot() &&
                 end.cable.contacts().size() == result.end.cable.contacts().size());
  if (end.cable.time_s() > frames.back().t_s) take(end.cable);
  return frames;
}

}  // namespace tautline
