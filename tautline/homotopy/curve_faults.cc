#include "tautline/homotopy/curve_faults.h"

#include <algorithm>
#include <cmath>

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/ring_ground.h"

namespace tautline {
namespace {

bool SameLength(double a, double b) { return std::fabs(a - b) <= kLengthTolerance * std::max({1.0, std::fabs(a)}); }

}  // namespace

std::vector<std::string> CurveFaults(const FreeSpace& space, const TautPath& path, const FreeSpace* stub_space) {
  std::vector<std::string> faults;
  const RingGround ground(space);
  const Polyline& points = path.points;
  if (points.empty()) return {"has no points"};
  const std::size_t first = stub_space != nullptr ? 1 : 0;
  if (stub_space != nullptr && points.size() > 1) {
    // The base may lie as far inside of a wall as the grown ground tells boundaries.
    const double depth = std::max(BoundaryTolerance(space), BoundaryTolerance(*stub_space));
    if (!RingGround(*stub_space).HoldsSegment(points[0], points[1], depth)) faults.emplace_back("leaves its socket");
  }
  for (std::size_t i = first; i + 1 < points.size(); ++i) {
    if (points[i] == points[i + 1]) {
      faults.emplace_back("repeats a point");
    } else if (!ground.HoldsSegment(points[i], points[i + 1])) {
      faults.emplace_back("leaves the free space");
    }
  }
  for (std::size_t i = first + 1; i + 1 < points.size(); ++i) {
    if (!ground.BendsAroundObstacle(points[i - 1], points[i], points[i + 1])) {
      faults.emplace_back("is not taut at bend " + std::to_string(i));
    }
  }
  if (!SameLength(Length(points), path.length)) faults.emplace_back("has another length than it claims");
  if (ground.WordOf(points) != path.word) faults.emplace_back("has another word than it claims");
  return faults;
}

}  // namespace tautline
