#include "tautline/planners/fleet/track_crossings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The shares of the segments ab and cd at which they meet.
std::optional<std::pair<double, double>> MeetingShares(Point a, Point b, Point c, Point d) {
  if (CrossProperly(a, b, c, d)) {
    const double at_c = Cross(b - a, c - a), at_d = Cross(b - a, d - a);
    const double at_a = Cross(d - c, a - c), at_b = Cross(d - c, b - c);
    return std::pair{at_a / (at_a - at_b), at_c / (at_c - at_d)};
  }
  const auto share = [](Point from, Point to, Point p) { return Distance(from, p) / Distance(from, to); };
  if (OnSegment(a, b, c)) return std::pair{share(a, b, c), 0.0};
  if (OnSegment(a, b, d)) return std::pair{share(a, b, d), 1.0};
  if (OnSegment(c, d, a)) return std::pair{0.0, share(c, d, a)};
  if (OnSegment(c, d, b)) return std::pair{1.0, share(c, d, b)};
  return std::nullopt;
}

}  // namespace

std::vector<TrackCrossing> FindTrackCrossings(const std::vector<Track>& tracks) {
  std::vector<BoxIndex::Segment> segments;
  std::vector<std::pair<std::size_t, std::size_t>> owners;
  for (std::size_t r = 0; r < tracks.size(); ++r) {
    for (std::size_t k = 0; k + 1 < tracks[r].points.size(); ++k) {
      segments.emplace_back(tracks[r].points[k], tracks[r].points[k + 1]);
      owners.emplace_back(r, k);
    }
  }
  const BoxIndex index(segments);
  std::vector<TrackCrossing> crossings;
  std::vector<std::size_t> near;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const auto [r, k] = owners[s];
    const auto [a, b] = segments[s];
    near.clear();
    index.ForEachAlong(a, b, 0, [&near, &owners, r = r](std::size_t other) {
      if (owners[other].first > r) near.push_back(other);
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::size_t other : near) {
      const auto shares = MeetingShares(a, b, segments[other].first, segments[other].second);
      if (!shares) continue;
      const auto [q, m] = owners[other];
      const auto at_share = [&tracks](std::size_t robot, std::size_t segment, double share) {
        const auto along = tracks[robot].along;
        return share == 1 ? along[segment + 1] : along[segment] + share * (along[segment + 1] - along[segment]);
      };
      crossings.push_back({{RobotId(r), RobotId(q)},
                           {at_share(r, k, shares->first), at_share(q, m, shares->second)},
                           Lerp(a, b, shares->first)});
    }
  }
  return crossings;
}

}  // namespace tautline
