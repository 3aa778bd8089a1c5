#include "tautline/planners/fleet/track_crossings.h"

#include <algorithm>
#include <utility>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The shares of the segments ab and cd at which they meet: where they cross, or where an end of one lies on the other.
std::vector<std::pair<double, double>> MeetingShares(Point a, Point b, Point c, Point d) {
  if (CrossProperly(a, b, c, d)) {
    const double at_c = Cross(b - a, c - a), at_d = Cross(b - a, d - a);
    const double at_a = Cross(d - c, a - c), at_b = Cross(d - c, b - c);
    return {{at_a / (at_a - at_b), at_c / (at_c - at_d)}};
  }
  const auto share = [](Point from, Point to, Point p) { return Distance(from, p) / Distance(from, to); };
  std::vector<std::pair<double, double>> shares;
  if (OnSegment(a, b, c)) shares.emplace_back(share(a, b, c), 0.0);
  if (OnSegment(a, b, d)) shares.emplace_back(share(a, b, d), 1.0);
  if (OnSegment(c, d, a)) shares.emplace_back(0.0, share(c, d, a));
  if (OnSegment(c, d, b)) shares.emplace_back(1.0, share(c, d, b));
  return shares;
}

double AlongAt(const Track& track, std::size_t segment, double share) {
  const double from = track.along[segment], to = track.along[segment + 1];
  return share == 1 ? to : from + share * (to - from);
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
      const auto [q, m] = owners[other];
      for (const auto& [first, second] : MeetingShares(a, b, segments[other].first, segments[other].second)) {
        crossings.push_back({{RobotId(r), RobotId(q)},
                             {AlongAt(tracks[r], k, first), AlongAt(tracks[q], m, second)},
                             Lerp(a, b, first)});
      }
    }
  }
  return crossings;
}

}  // namespace tautline
