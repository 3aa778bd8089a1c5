#include "tautline/homotopy/goal_field.h"

#include <limits>
#include <queue>
#include <utility>

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::vector<TautLeg> LegsFrom(const TautSpace& space, Place place) {
  std::vector<TautLeg> legs;
  for (const Sighting& sighting : SeeFromPoint(space.mesh(), space.corners(), place)) {
    legs.push_back({sighting.corner, sighting.head, Distance(place.point, space.corners()[sighting.corner].point)});
  }
  return legs;
}

GoalField::GoalField(const TautSpace& space, Place goal, double limit)
    : space_(&space), goal_(goal), beyond_(space.graph().edges().size(), kInfinity), leg_(space.corners().size()) {
  const VisibilityGraph& graph = space.graph();
  const auto point = [&space](CornerId id) { return space.corners()[id].point; };
  using Entry = std::pair<double, EdgeId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  // Offers `distance` from `corner` on to every edge into it from which the walk to `next` is a taut turn. `tail` is
  // the side of the corner's obstacle for the walk that leaves it.
  const auto relax_into = [&](CornerId corner, Side tail, Point next, double distance) {
    if (distance > limit) return;
    const EdgeId first = graph.First(corner);
    for (std::size_t k = 0; k < graph.OutOf(corner).size(); ++k) {
      const EdgeId into = graph.Reverse(EdgeId(first.index() + k));
      const TautEdge& edge = graph.edge(into);
      if (edge.head != tail || beyond_[into.index()] <= distance) continue;
      if (!IsTautTurn(point(edge.from), point(corner), edge.head, next)) continue;
      beyond_[into.index()] = distance;
      queue.emplace(distance, into);
    }
  };
  for (const Place& sector : space.mesh().Sectors(goal)) {
    for (const TautLeg& leg : LegsFrom(space, sector)) {
      leg_[leg.corner.index()] = leg;
      // The leg was looked at from the goal; walked from the corner, left and right change places.
      relax_into(leg.corner, Opposite(leg.side), goal.point, leg.length);
    }
  }
  while (!queue.empty()) {
    const auto [distance, id] = queue.top();
    queue.pop();
    if (distance > beyond_[id.index()]) continue;
    const TautEdge& edge = graph.edge(id);
    relax_into(edge.from, edge.tail, point(edge.to), distance + edge.length);
  }
}

std::optional<double> GoalField::LastLeg(CornerId corner, Side head, Point from) const {
  const TautLeg& leg = leg_[corner.index()];
  if (leg.side == Side::kNone || Opposite(leg.side) != head) return std::nullopt;
  if (!IsTautTurn(from, space_->corners()[corner].point, head, goal_.point)) return std::nullopt;
  return leg.length;
}

}  // namespace tautline
