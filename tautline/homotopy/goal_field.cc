#include "tautline/homotopy/goal_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kStepsPerCheck = 8192;

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

GoalField::GoalField(const TautSpace& space, Place goal, GoalFieldOptions options)
    : space_(&space),
      goal_(goal),
      targets_(std::move(options.targets)),
      stop_(std::move(options.keep_going), kStepsPerCheck),
      beyond_(space.graph().edges().size(), kInfinity),
      leg_at_(space.corners().size(), -1),
      open_end_(space.graph().stances()),
      open_from_(space.graph().stances(), EdgeId(-1)) {
  for (const Place& sector : space.mesh().Sectors(goal)) {
    for (const TautLeg& leg : LegsFrom(space, sector)) {
      leg_at_[leg.corner.index()] = static_cast<std::int32_t>(legs_.size());
      legs_.push_back(leg);
      Push(leg.corner, leg.length, -static_cast<std::int32_t>(legs_.size()));
    }
  }
}

double GoalField::ToTarget(CornerId corner) const {
  if (targets_.empty()) return 0;
  const Point p = space_->corners()[corner].point;
  double least = kInfinity;
  for (const Point target : targets_) least = std::min(least, Dot(target - p, target - p));
  return std::sqrt(least);
}

void GoalField::Push(CornerId from, double distance, std::int32_t source) {
  queue_.push({distance + ToTarget(from), distance, source});
}

void GoalField::GrowTo(double radius) {
  while (!queue_.empty() && queue_.top().total <= radius) {
    stop_.Step();
    const Entry entry = queue_.top();
    queue_.pop();
    Settle(entry);
  }
  radius_ = std::max(radius_, radius);
  if (queue_.empty()) radius_ = kInfinity;
}

/// Offers a way to the goal to all edges that come in at the corner where it starts and can turn into it.
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
/// a way are the last of them, so after shorter ways only a piece before the earlier pieces is left.
template <class CanTurn>
void GoalField::ReachInto(StanceId stance, double distance, CanTurn can_turn) {
  const VisibilityGraph& graph = space_->graph();
  const EdgeRange reversed = graph.OutOf(Opposite(stance));
  EdgeId& end = open_end_[stance.index()];
  if (!end.valid()) end = reversed.last;
  while (end > reversed.first) {
    const EdgeId last(end.value() - 1);
    if (!can_turn(last)) break;
    end = last;
    beyond_[last.index()] = distance;
    const TautEdge& back = graph.edge(last);
    // Useless unless an edge that comes in at the other end, and can turn into this one, has no distance yet.
    if (open_from_[StanceOf(back.to, Opposite(back.head)).index()] > back.reverse) continue;
    Push(back.to, distance + back.length, back.reverse.value());
  }
  open_from_[stance.index()] = end > reversed.first ? graph.OnwardOfReverse(EdgeId(end.value() - 1))
                                                    : EdgeId(std::numeric_limits<std::int32_t>::max());
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
