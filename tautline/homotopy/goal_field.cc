#include "tautline/homotopy/goal_field.h"

#include <algorithm>

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

std::vector<FirstLeg> FirstLegsFrom(const TautSpace& space, const Walk& walk) {
  const Place here{walk.at, walk.sleeve.back()};
  std::vector<FirstLeg> first;
  const auto add_sector = [&](const Place& sector) {
    for (const TautLeg& leg : LegsFrom(space, sector)) {
      first.push_back({leg, space.graph().Onward(walk.at, leg.corner, leg.side, space.corners())});
    }
  };
  if (walk.is_free_to_turn()) {
    for (const Place& sector : space.mesh().Sectors(here)) add_sector(sector);
  } else {
    add_sector(here);
  }
  return first;
}

GoalField::GoalField(const TautSpace& space, Place goal)
    : space_(&space),
      goal_(goal),
      beyond_(space.graph().edges().size(), kInfinity),
      leg_at_(space.corners().size(), -1) {
  const VisibilityGraph& graph = space.graph();
  open_end_.reserve(graph.stances());
  for (std::size_t s = 0; s < graph.stances(); ++s) open_end_.push_back(graph.OutOf(Opposite(StanceId(s))).last);
  for (const Place& sector : space.mesh().Sectors(goal)) {
    for (const TautLeg& leg : LegsFrom(space, sector)) {
      leg_at_[leg.corner.index()] = static_cast<std::int32_t>(legs_.size());
      legs_.push_back(leg);
      queue_.push({leg.length, -static_cast<std::int32_t>(legs_.size())});
    }
  }
}

void GoalField::GrowTo(double radius) {
  while (!queue_.empty() && queue_.top().distance <= radius) {
    const Entry entry = queue_.top();
    queue_.pop();
    Settle(entry);
  }
  radius_ = queue_.empty() ? kInfinity : std::max(radius_, radius);
}

/// Offers the distance from the tail of an edge, or of the leg, to all edges that come in there and can turn into it.
void GoalField::Settle(const Entry& entry) {
  const VisibilityGraph& graph = space_->graph();
  if (entry.source >= 0) {
    const EdgeId way(entry.source);
    const TautEdge& edge = graph.edge(way);
    ReachInto(StanceOf(edge.from, edge.tail), entry.distance,
              [&](EdgeId reversed) { return graph.OnwardOfReverse(reversed) <= way; });
    return;
  }
  // The leg was looked at from the goal; walked from the corner, left and right change places.
  const TautLeg& leg = legs_[static_cast<std::size_t>(-1 - entry.source)];
  const Side side = Opposite(leg.side);
  const Point here = space_->corners()[leg.corner].point;
  ReachInto(StanceOf(leg.corner, side), entry.distance, [&](EdgeId reversed) {
    return IsTautTurn(space_->corners()[graph.edge(reversed).to].point, here, side, goal_.point);
  });
}

/// The edges that come in at a stance are the reverses of those that leave the opposite one. Those that can turn into
/// a way are the last of them, so after ways of smaller distance only a piece before the earlier pieces is left.
template <class CanTurn>
void GoalField::ReachInto(StanceId stance, double distance, CanTurn can_turn) {
  const VisibilityGraph& graph = space_->graph();
  const EdgeId first = graph.OutOf(Opposite(stance)).first;
  EdgeId end = open_end_[stance.index()];
  while (end > first) {
    const EdgeId reversed(end.value() - 1);
    if (!can_turn(reversed)) break;
    end = reversed;
    const TautEdge& back = graph.edge(reversed);
    beyond_[back.reverse.index()] = distance;
    if (CanGain(back.reverse)) queue_.push({distance + back.length, back.reverse.value()});
  }
  open_end_[stance.index()] = end;
}

/// Whether an edge that comes in at the tail of this one, and can turn into it, has no distance yet.
bool GoalField::CanGain(EdgeId id) const {
  const VisibilityGraph& graph = space_->graph();
  const TautEdge& edge = graph.edge(id);
  const StanceId stance = StanceOf(edge.from, edge.tail);
  const EdgeId end = open_end_[stance.index()];
  return end > graph.OutOf(Opposite(stance)).first && graph.OnwardOfReverse(EdgeId(end.value() - 1)) <= id;
}

std::optional<double> GoalField::LastLeg(CornerId corner, Side head, Point from) const {
  const std::int32_t position = leg_at_[corner.index()];
  if (position < 0) return std::nullopt;
  const TautLeg& leg = legs_[static_cast<std::size_t>(position)];
  if (Opposite(leg.side) != head) return std::nullopt;
  if (!IsTautTurn(from, space_->corners()[corner].point, head, goal_.point)) return std::nullopt;
  return leg.length;
}

}  // namespace tautline
