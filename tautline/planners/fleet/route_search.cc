#include "tautline/planners/fleet/route_search.h"

#include <algorithm>
#include <limits>

#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/check_layout.h"

namespace tautline {

const std::vector<FleetSight::Leg>& FleetSight::From(FleetNodeId node) {
  auto& legs = legs_[node.index()];
  if (legs) return *legs;
  legs.emplace();
  // Starts come first, and no cable may pass them.
  for (std::size_t k = ground_.size(); k < ground_.node_count(); ++k) {
    const FleetNodeId to(k);
    if (to != node && IsLeg(node, to)) legs->push_back({to, Distance(ground_.point(node), ground_.point(to))});
  }
  return *legs;
}

bool FleetSight::IsTangent(FleetNodeId at, FleetNodeId from) const {
  const CornerId corner = ground_.corner_at(at);
  return !corner.valid() || ground_.space()->corners()[corner].TangentFrom(ground_.point(from)) != Side::kNone;
}

bool FleetSight::IsLeg(FleetNodeId from, FleetNodeId to) const {
  const Point a = ground_.point(from), b = ground_.point(to);
  if (a == b || !IsTangent(from, to) || !IsTangent(to, from)) return false;
  for (const FleetNodeId node : ground_.NodesBetween(a, b)) {
    if (ground_.kind(node) != FleetNodeKind::kCorner) return false;
  }
  if (ground_.space() == nullptr) return true;
  std::optional<Walk> walk;
  return !ground_.space()->Follow(Polyline{a, b}, walk);
}

RouteSearch::RouteSearch(const FleetGround& ground, FleetSight& sight, RobotId robot, double limit)
    : ground_(ground), sight_(sight), robot_(robot), limit_(limit) {
  partials_.push_back({ground.start(robot)});
  if (BoundOf(partials_[0]) <= limit_) open_.emplace(BoundOf(partials_[0]), 0);
}

double RouteSearch::next_bound() const {
  return open_.empty() ? std::numeric_limits<double>::infinity() : open_.top().first;
}

double RouteSearch::BoundOf(const Partial& partial) const {
  return partial.length + Distance(ground_.point(partial.node), ground_.point(ground_.target(robot_)));
}

std::int64_t RouteSearch::Extend(double length, std::int64_t steps) {
  std::int64_t done = 0;
  while (done < steps && !open_.empty() && open_.top().first <= length) {
    const std::int64_t partial = open_.top().second;
    open_.pop();
    if (partials_[static_cast<std::size_t>(partial)].node == ground_.target(robot_)) {
      Finish(partial);
      ++done;
    } else {
      done += Expand(partial);
    }
  }
  return done;
}

std::vector<FleetNodeId> RouteSearch::NodesOf(std::int64_t partial) const {
  std::vector<FleetNodeId> nodes;
  for (; partial >= 0; partial = partials_[static_cast<std::size_t>(partial)].parent) {
    nodes.push_back(partials_[static_cast<std::size_t>(partial)].node);
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

std::int64_t RouteSearch::Expand(std::int64_t partial) {
  const std::vector<FleetNodeId> nodes = NodesOf(partial);
  const double length = partials_[static_cast<std::size_t>(partial)].length;
  for (const FleetSight::Leg& leg : sight_.From(nodes.back())) {
    const Partial next{leg.to, partial, length + leg.length};
    if (BoundOf(next) > limit_ || !CanGoOn(nodes, leg.to)) continue;
    open_.emplace(BoundOf(next), static_cast<std::int64_t>(partials_.size()));
    partials_.push_back(next);
  }
  return static_cast<std::int64_t>(1 + sight_.From(nodes.back()).size());
}

bool RouteSearch::CanGoOn(const std::vector<FleetNodeId>& nodes, FleetNodeId to) const {
  if (std::find(nodes.begin(), nodes.end(), to) != nodes.end()) return false;
  if (nodes.size() < 2) return true;
  const auto at = [&](std::size_t k) { return ground_.point(nodes[k]); };
  const std::size_t last = nodes.size() - 1;
  const Point next = ground_.point(to);
  const int turn = Orientation(at(last - 1), at(last), next);
  if (turn == 0) return false;
  const CornerId corner = ground_.corner_at(nodes[last]);
  const Side side = turn > 0 ? Side::kLeft : Side::kRight;
  if (corner.valid() && ground_.space()->corners()[corner].TangentFrom(at(last - 1)) != side) return false;
  for (std::size_t k = 0; k + 1 < last; ++k) {
    if (CrossProperly(at(k), at(k + 1), at(last), next)) return false;
  }
  return true;
}

void RouteSearch::Finish(std::int64_t partial) {
  Polyline line;
  for (const FleetNodeId node : NodesOf(partial)) line.push_back(ground_.point(node));
  auto route = ReadRoute(ground_, robot_, line);
  if (!route || !SelfLoops(ground_, robot_, *route).empty()) return;
  if (!EnclosedStarts(ground_, robot_, *route).empty()) return;
  candidates_.push_back({*std::move(route), partials_[static_cast<std::size_t>(partial)].length});
}

}  // namespace tautline
