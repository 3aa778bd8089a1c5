#include "tautline/planners/fleet/check_layout.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/tracks.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// An edge of a route, by robot and its first step.
struct LayoutEdge {
  RobotId robot;
  std::size_t step = 0;

  friend auto operator<=>(const LayoutEdge&, const LayoutEdge&) = default;
};

/// The closed curve of a cable line and, back, the robot's shortest path.
Ring CablePolygon(const FleetGround& ground, const Route& route) {
  Ring ring = PointsOf(ground, route);
  if (ground.space() == nullptr) return ring;
  const Polyline path = Shorten(*ground.space(), ring).path.points;
  TAUTLINE_CHECK(path.size() >= 2);
  for (std::size_t k = path.size() - 2; k > 0; --k) ring.push_back(path[k]);
  return ring;
}

/// Finds the crossings of all pairs, robot by robot.
class PairCheck {
 public:
  PairCheck(const FleetGround& ground, const FleetLayout& layout, const CheckLayoutOptions& options)
      : ground_(ground), layout_(layout), options_(options), passing_(ground.node_count()) {
    std::vector<BoxIndex::Segment> segments;
    for (std::size_t i = 0; i < layout.size(); ++i) {
      for (const RouteStep& step : layout[i]) passing_[step.node.index()].push_back(RobotId(i));
      for (std::size_t k = 0; k + 1 < layout[i].size(); ++k) {
        edges_.push_back({RobotId(i), k});
        segments.push_back(SegmentOf(edges_.back()));
      }
    }
    if (!segments.empty()) index_.emplace(segments);
  }

  void Run(LayoutFaults& faults) {
    for (std::size_t i = 0; i < layout_.size() && faults.all_crossings; ++i) {
      if (options_.watch &&
          !options_.watch("crossings", static_cast<double>(i) / static_cast<double>(layout_.size()))) {
        throw Stopped();
      }
      CompareAt(RobotId(i), faults);
      faults.all_crossings = faults.crossings.size() < options_.max_crossings;
    }
  }

 private:
  BoxIndex::Segment SegmentOf(const LayoutEdge& edge) const {
    const Route& route = layout_[edge.robot.index()];
    return {ground_.point(route[edge.step].node), ground_.point(route[edge.step + 1].node)};
  }

  /// Compares a robot with the later ones.
  void CompareAt(RobotId a, LayoutFaults& faults) const {
    std::set<RobotId> others;
    for (const RouteStep& step : layout_[a.index()]) {
      const auto& passing = passing_[step.node.index()];
      others.insert(std::upper_bound(passing.begin(), passing.end(), a), passing.end());
    }
    for (const RobotId b : others) {
      for (RouteCrossing& crossing : NodeCrossings(ground_, layout_[a.index()], layout_[b.index()])) {
        faults.crossings.push_back({a, b, std::move(crossing)});
      }
    }
    const auto first = static_cast<std::ptrdiff_t>(faults.crossings.size() - CountOf(a, faults));
    for (const auto& [edge_b, edge_a] : CrossingEdges(a)) {
      const auto [p, q] = SegmentOf(edge_a);
      const auto [r, s] = SegmentOf(edge_b);
      faults.crossings.push_back({a, edge_b.robot, {CrossingKind::kInterior, CrossingPoint(p, q, r, s), {}}});
    }
    std::stable_sort(faults.crossings.begin() + first, faults.crossings.end(),
                     [](const LayoutCrossing& p, const LayoutCrossing& q) { return p.b < q.b; });
  }

  static std::size_t CountOf(RobotId a, const LayoutFaults& faults) {
    std::size_t count = 0;
    for (auto fault = faults.crossings.rbegin(); fault != faults.crossings.rend() && fault->a == a; ++fault) ++count;
    return count;
  }

  /// The edges of later robots that cross edges of a robot, each with that edge.
  std::vector<std::pair<LayoutEdge, LayoutEdge>> CrossingEdges(RobotId a) const {
    std::vector<std::pair<LayoutEdge, LayoutEdge>> crossing;
    for (std::size_t k = 0; k + 1 < layout_[a.index()].size(); ++k) {
      const LayoutEdge edge{a, k};
      const auto [from, to] = SegmentOf(edge);
      index_->ForEachAlong(from, to, 0, [&, from = from, to = to](std::size_t other) {
        if (edges_[other].robot <= a) return;
        const auto [p, q] = SegmentOf(edges_[other]);
        if (CrossProperly(from, to, p, q)) crossing.emplace_back(edges_[other], edge);
      });
    }
    std::sort(crossing.begin(), crossing.end());
    crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
    return crossing;
  }

  const FleetGround& ground_;
  const FleetLayout& layout_;
  const CheckLayoutOptions& options_;
  std::vector<std::vector<RobotId>> passing_;  ///< By node; a robot once for each time that it passes.
  std::vector<LayoutEdge> edges_;
  std::optional<BoxIndex> index_;
};

std::string BothCables(const FleetGround& ground, const LayoutCrossing& fault) {
  return "the cable lines of " + ground.robot(fault.a).name + " and " + ground.robot(fault.b).name;
}

}  // namespace

namespace {

/// Whether some route passes a node straight, so that its side is to be chosen.
bool HasOpenSides(const FleetLayout& layout) {
  for (const Route& route : layout) {
    for (std::size_t i = 1; i + 1 < route.size(); ++i) {
      if (route[i].side == Side::kNone) return true;
    }
  }
  return false;
}

}  // namespace

LayoutFaults CheckLayout(const FleetGround& ground, const FleetLayout& layout, const CheckLayoutOptions& options) {
  TAUTLINE_CHECK(layout.size() == ground.size());
  LayoutFaults faults;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    const RobotId robot(i);
    for (const SelfLoop& loop : SelfLoops(ground, robot, layout[i])) faults.self_loops.push_back(loop);
    for (const EnclosedStart& start : EnclosedStarts(ground, robot, layout[i])) faults.starts_enclosed.push_back(start);
    const auto& tether = ground.robot(robot).tether;
    const double length = LengthOf(ground, layout[i]);
    if (tether && length > *tether) faults.short_tethers.push_back({robot, length, *tether});
  }
  PairCheck(ground, layout, options).Run(faults);
  if (faults.crossings.empty() && HasOpenSides(layout)) {
    // Each two lines find sides of the nodes that they pass straight; here one choice must suit all.
    PairCheck(ground, WithSides(ground, layout), options).Run(faults);
  }
  return faults;
}

std::vector<SelfLoop> SelfLoops(const FleetGround& ground, RobotId robot, const Route& route) {
  std::vector<SelfLoop> loops;
  std::set<FleetNodeId> seen;
  for (const RouteStep& step : route) {
    if (!seen.insert(step.node).second) loops.push_back({robot, ground.point(step.node), true});
  }
  const auto at = [&](std::size_t k) { return ground.point(route[k].node); };
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    for (std::size_t j = i + 2; j + 1 < route.size(); ++j) {
      if (!CrossProperly(at(i), at(i + 1), at(j), at(j + 1))) continue;
      loops.push_back({robot, CrossingPoint(at(i), at(i + 1), at(j), at(j + 1)), false});
    }
  }
  return loops;
}

std::vector<EnclosedStart> EnclosedStarts(const FleetGround& ground, RobotId robot, const Route& route) {
  const Ring ring = CablePolygon(ground, route);
  std::set<EnclosedStart, bool (*)(const EnclosedStart&, const EnclosedStart&)> found(
      [](const EnclosedStart& p, const EnclosedStart& q) { return p.robot < q.robot; });
  const auto check = [&](FleetNodeId node) {
    if (ground.kind(node) != FleetNodeKind::kStart || ground.robot_at(node) == robot) return;
    const Winding winding = WindingNumber(ring, ground.point(node));
    if (winding.on_boundary || winding.number != 0) {
      found.insert({ground.robot_at(node), robot, winding.on_boundary});
    }
  };
  ground.ForEachNodeNear(BoundingBox(ring), check);
  return {found.begin(), found.end()};
}

std::string Explain(const FleetGround& ground, const LayoutCrossing& fault) {
  const std::string cables = BothCables(ground, fault);
  const RouteCrossing& crossing = fault.crossing;
  if (crossing.kind == CrossingKind::kInterior) return cables + " cross at " + ShortText(crossing.at);
  const std::string first = NameOf(ground, crossing.shared.front());
  switch (crossing.kind) {
    case CrossingKind::kEndOutsideBend:
      return cables + " cross at " + first + ": one of them bends around it, and the other one comes from outside";
    case CrossingKind::kThroughNode:
      return cables + " cross at " + first + ", which both pass";
    case CrossingKind::kBendAgainstBend:
      return cables + " cross at " + first + ", around which they bend in opposite ways";
    default:
      return cables + " share the way from " + first + " to " + NameOf(ground, crossing.shared.back()) +
             (crossing.kind == CrossingKind::kEndOfShared ? " and cross there, since one of them ends on it"
                                                          : " and cross there: they leave it to the other side");
  }
}

std::string Explain(const FleetGround& ground, const SelfLoop& fault) {
  return "the cable line of " + ground.robot(fault.robot).name +
         (fault.node_twice ? " passes " + ShortText(fault.at) + " twice" : " crosses itself at " + ShortText(fault.at));
}

std::string Explain(const FleetGround& ground, const EnclosedStart& fault) {
  const FleetRobot& by = ground.robot(fault.by);
  return "the start of " + ground.robot(fault.robot).name + " lies " + (fault.on_boundary ? "on" : "inside of") +
         " the polygon of " + by.name + ", which its cable line and its shortest path bound";
}

std::string Explain(const FleetGround& ground, const ShortTether& fault) {
  return "the cable of " + ground.robot(fault.robot).name + " is " + Metres(fault.limit) + " long and its cable line " +
         Metres(fault.length);
}

}  // namespace tautline
