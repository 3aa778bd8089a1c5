#include "tautline/planners/cable_workspace/region_path.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Where the segment ab meets the ring, as fractions of ab in ascending order, with both ends.
std::vector<double> Cuts(const Ring& ring, Point a, Point b) {
  std::vector<double> cuts{0, 1};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point c = ring[i], d = ring[(i + 1) % ring.size()];
    if (Orientation(a, b, c) == Orientation(a, b, d)) continue;
    const double from_c = Cross(b - a, c - a), from_d = Cross(b - a, d - a);
    if (from_c == from_d) continue;
    const Point at = Lerp(c, d, from_c / (from_c - from_d));
    const double along = Dot(at - a, b - a) / Dot(b - a, b - a);
    if (along > 0 && along < 1) cuts.push_back(along);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

RegionPath ShortestPath(const WorkspaceRegion& region, std::span<const Walk> from_ways, std::span<const Walk> to_ways) {
  TAUTLINE_CHECK(!from_ways.empty() && !to_ways.empty());
  std::optional<RegionPath> best;
  for (std::size_t i = 0; i < from_ways.size(); ++i) {
    for (std::size_t k = 0; k < to_ways.size(); ++k) {
      TautPath path = region.ground().space().Pull(region.Between(from_ways[i], to_ways[k]));
      if (!best || path.length < best->path.length) best = RegionPath{std::move(path), i, k};
    }
  }
  return *std::move(best);
}

std::optional<Point> FirstOutside(const WorkspaceRegion& region, std::span<const Point> path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const std::vector<double> cuts = Cuts(region.boundary().ring, path[i], path[i + 1]);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Point middle = Lerp(path[i], path[i + 1], 0.5 * (cuts[k] + cuts[k + 1]));
      if (region.Classify(middle) == Containment::kOutside) return Lerp(path[i], path[i + 1], cuts[k]);
    }
  }
  return std::nullopt;
}

}  // namespace tautline
