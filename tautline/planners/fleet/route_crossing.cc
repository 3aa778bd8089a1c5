#include "tautline/planners/fleet/route_crossing.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Routes with no more pairs of steps than this are compared without an index, which would cost more than it saves.
constexpr std::size_t kFewPairs = 4096;

/// The side of the way from `before` over `at` to `after` on which `p` lies, as seen from `at`; kNone on the way.
Side SideOfWay(Point before, Point at, Point after, Point p) {
  const int turn = Orientation(before, at, after);
  const int to_first = Orientation(before, at, p), to_second = Orientation(at, after, p);
  if (turn == 0) return to_second > 0 ? Side::kLeft : to_second < 0 ? Side::kRight : Side::kNone;
  // The sector that the way turns to is convex: inside of it are the points beyond neither leg.
  if (to_first == turn && to_second == turn) return turn > 0 ? Side::kLeft : Side::kRight;
  const bool on_first = to_first == 0 && Dot(before - at, p - at) > 0;
  const bool on_second = to_second == 0 && Dot(after - at, p - at) > 0;
  if (on_first || on_second) return Side::kNone;
  return turn > 0 ? Side::kRight : Side::kLeft;
}

/// A route as a traveller sees it who stands on a step and looks forwards, or backwards.
struct Strand {
  const FleetGround& ground;
  const Route& route;
  std::ptrdiff_t step;
  std::ptrdiff_t direction;  ///< 1 or -1.

  std::optional<FleetNodeId> Node(int ahead) const {
    const std::ptrdiff_t at = step + ahead * direction;
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(route.size())) return std::nullopt;
    return route[static_cast<std::size_t>(at)].node;
  }
  std::optional<Point> At(int ahead) const {
    const auto node = Node(ahead);
    return node ? std::optional(ground.point(*node)) : std::nullopt;
  }
  Side side() const {
    const Side side = route[static_cast<std::size_t>(step)].side;
    return direction > 0 ? side : Opposite(side);
  }
  Strand Forth(int steps) const { return {ground, route, step + steps * direction, direction}; }
  Strand Turned() const { return {ground, route, step, -direction}; }
};

/// What the end of a shared part says of the order of two strands along it.
struct Order {
  bool possible = true;     ///< Whether there is an order that suits.
  Side side = Side::kNone;  ///< On which side of the second strand the first one lies; kNone: either.
};

/// Both strands come to a node along one edge, and part or end there.
Order OrderAtEnd(const Strand& a, const Strand& b) {
  const auto after_a = a.At(1), after_b = b.At(1);
  // An end lies at the node, that is, on the side of the other strand's bend on which that has the node.
  if (!after_a) return {.side = b.side()};
  if (!after_b) return {.side = Opposite(a.side())};
  const Side side = SideOfWay(*b.At(-1), *b.At(0), *after_b, *after_a);
  // With a on the left, a node on the right of a has b on the right of a as well, and must be on its right too.
  const bool apart = a.side() != Side::kNone && b.side() != Side::kNone && a.side() != b.side();
  return {.possible = !(apart && a.side() == side), .side = side};
}

/// Both strands pass a node, or one ends there, and they share no edge at it.
std::optional<CrossingKind> CrossAtNode(const Strand& a, const Strand& b) {
  const auto before_a = a.At(-1), after_a = a.At(1), before_b = b.At(-1), after_b = b.At(1);
  const bool a_ends = !before_a || !after_a, b_ends = !before_b || !after_b;
  if (a_ends && b_ends) return std::nullopt;
  if (a_ends || b_ends) {
    const Strand& passing = a_ends ? b : a;
    const Strand& ending = a_ends ? a : b;
    const Point from = ending.At(-1) ? *ending.At(-1) : *ending.At(1);
    const Side side = SideOfWay(*passing.At(-1), *passing.At(0), *passing.At(1), from);
    if (passing.side() == Side::kNone || passing.side() == side) return std::nullopt;
    return CrossingKind::kEndOutsideBend;
  }
  const Side side = SideOfWay(*before_b, *b.At(0), *after_b, *before_a);
  if (side != SideOfWay(*before_b, *b.At(0), *after_b, *after_a)) return CrossingKind::kThroughNode;
  const Side side_of_b = SideOfWay(*before_a, *a.At(0), *after_a, *before_b);
  // Neither strand lies between the node and the other one, and the node cannot lie between both.
  const bool b_bends_away = b.side() == Opposite(side), a_bends_away = a.side() == Opposite(side_of_b);
  if (a_bends_away && b_bends_away) return CrossingKind::kBendAgainstBend;
  return std::nullopt;
}

/// Finds what two routes share, and whether they cross there.
class SharedParts {
 public:
  SharedParts(const FleetGround& ground, const Route& a, const Route& b) : ground_(ground), a_(a), b_(b) {}

  std::vector<RouteCrossing> Cross() {
    for (const auto& [i, j] : CommonSteps()) AddAt(i, j);
    return std::move(crossings_);
  }

 private:
  using Steps = std::vector<std::pair<FleetNodeId, std::ptrdiff_t>>;

  static Steps Sorted(const Route& route) {
    Steps steps;
    for (std::size_t i = 0; i < route.size(); ++i) steps.emplace_back(route[i].node, i);
    std::sort(steps.begin(), steps.end());
    return steps;
  }

  /// The positions in both routes of each node that is in both, in the order of the first.
  std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> CommonSteps() const {
    std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>> common;
    if (a_.size() * b_.size() <= kFewPairs) {
      for (std::size_t i = 0; i < a_.size(); ++i) {
        for (std::size_t j = 0; j < b_.size(); ++j) {
          if (a_[i].node == b_[j].node) common.emplace_back(i, j);
        }
      }
      return common;
    }
    const Steps in_b = Sorted(b_);
    for (std::size_t i = 0; i < a_.size(); ++i) {
      auto found = std::lower_bound(in_b.begin(), in_b.end(), std::pair(a_[i].node, std::ptrdiff_t{0}));
      for (; found != in_b.end() && found->first == a_[i].node; ++found) common.emplace_back(i, found->second);
    }
    return common;
  }

  void AddAt(std::ptrdiff_t i, std::ptrdiff_t j) {
    const Strand a{ground_, a_, i, 1}, b{ground_, b_, j, 1};
    const auto same = [](const auto& p, const auto& q) { return p && q && *p == *q; };
    for (const Strand& along : {b, b.Turned()}) {
      if (same(a.Node(-1), along.Node(-1))) return;  // Told of where the shared part begins.
      if (same(a.Node(1), along.Node(1))) return AddShared(a, along);
    }
    if (const auto kind = CrossAtNode(a, b)) crossings_.push_back({*kind, *a.At(0), {*a.Node(0)}});
  }

  /// Both strands stand where a shared part begins and look along it.
  void AddShared(const Strand& a, const Strand& b) {
    int length = 0;
    std::vector<FleetNodeId> shared{*a.Node(0)};
    for (; a.Node(length + 1) && a.Node(length + 1) == b.Node(length + 1); ++length) {
      shared.push_back(*a.Node(length + 1));
    }
    const Strand a_last = a.Forth(length), b_last = b.Forth(length);
    const Order first = OrderAtEnd(a.Turned(), b.Turned()), last = OrderAtEnd(a_last, b_last);
    const bool suits = first.side == Side::kNone || last.side == Side::kNone || Opposite(first.side) == last.side;
    if (first.possible && last.possible && suits) return;
    const bool ends = !a.At(-1) || !b.At(-1) || !a_last.At(1) || !b_last.At(1);
    crossings_.push_back({ends ? CrossingKind::kEndOfShared : CrossingKind::kSharedPart,
                          first.possible ? *a_last.At(0) : *a.At(0), std::move(shared)});
  }

  const FleetGround& ground_;
  const Route& a_;
  const Route& b_;
  std::vector<RouteCrossing> crossings_;
};

/// The edge of a route that begins at a step.
BoxIndex::Segment EdgeAt(const FleetGround& ground, const Route& route, std::size_t step) {
  return {ground.point(route[step].node), ground.point(route[step + 1].node)};
}

bool BoxesMeet(const BoxIndex::Segment& a, const BoxIndex::Segment& b) {
  const auto [p, q] = a;
  const auto [r, s] = b;
  return std::max(p.x, q.x) >= std::min(r.x, s.x) && std::max(r.x, s.x) >= std::min(p.x, q.x) &&
         std::max(p.y, q.y) >= std::min(r.y, s.y) && std::max(r.y, s.y) >= std::min(p.y, q.y);
}

bool EdgesCross(const FleetGround& ground, const Route& a, std::size_t i, const Route& b, std::size_t j) {
  const auto [p, q] = EdgeAt(ground, a, i);
  const auto [r, s] = EdgeAt(ground, b, j);
  return BoxesMeet({p, q}, {r, s}) && CrossProperly(p, q, r, s);
}

/// The pairs of edges that cross, by their first steps; only the first pair found when that is enough.
std::vector<std::pair<std::size_t, std::size_t>> CrossingEdges(const FleetGround& ground, const Route& a,
                                                               const Route& b, bool one_is_enough) {
  std::vector<std::pair<std::size_t, std::size_t>> crossing;
  if (a.size() < 2 || b.size() < 2) return crossing;
  if (a.size() * b.size() <= kFewPairs) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      for (std::size_t j = 0; j + 1 < b.size(); ++j) {
        if (EdgesCross(ground, a, i, b, j)) crossing.emplace_back(i, j);
        if (one_is_enough && !crossing.empty()) return crossing;
      }
    }
    return crossing;
  }
  std::vector<BoxIndex::Segment> edges;
  for (std::size_t j = 0; j + 1 < b.size(); ++j) edges.push_back(EdgeAt(ground, b, j));
  const BoxIndex index(edges);
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    const auto [from, to] = EdgeAt(ground, a, i);
    index.ForEachAlong(from, to, 0, [&](std::size_t j) {
      if (EdgesCross(ground, a, i, b, j)) crossing.emplace_back(i, j);
    });
    if (one_is_enough && !crossing.empty()) return crossing;
  }
  std::sort(crossing.begin(), crossing.end());
  crossing.erase(std::unique(crossing.begin(), crossing.end()), crossing.end());
  return crossing;
}

}  // namespace

std::string ToString(CrossingKind kind) {
  switch (kind) {
    case CrossingKind::kInterior:
      return "interior";
    case CrossingKind::kEndOutsideBend:
      return "end_outside_bend";
    case CrossingKind::kEndOfShared:
      return "end_of_shared";
    case CrossingKind::kThroughNode:
      return "through_node";
    case CrossingKind::kBendAgainstBend:
      return "bend_against_bend";
    case CrossingKind::kSharedPart:
      return "shared_part";
  }
  return "";
}

std::vector<RouteCrossing> RouteCrossings(const FleetGround& ground, const Route& a, const Route& b) {
  std::vector<RouteCrossing> crossings = NodeCrossings(ground, a, b);
  for (const auto& [i, j] : CrossingEdges(ground, a, b, false)) {
    const auto [p, q] = EdgeAt(ground, a, i);
    const auto [r, s] = EdgeAt(ground, b, j);
    crossings.push_back({CrossingKind::kInterior, CrossingPoint(p, q, r, s), {}});
  }
  return crossings;
}

bool RoutesCross(const FleetGround& ground, const Route& a, const Route& b) {
  return !CrossingEdges(ground, a, b, true).empty() || !NodeCrossings(ground, a, b).empty();
}

std::vector<RouteCrossing> NodeCrossings(const FleetGround& ground, const Route& a, const Route& b) {
  return SharedParts(ground, a, b).Cross();
}

Point CrossingPoint(Point a, Point b, Point c, Point d) {
  const Point along = b - a, across = d - c;
  return Lerp(a, b, Cross(c - a, across) / Cross(along, across));
}

}  // namespace tautline
