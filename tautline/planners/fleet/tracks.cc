#include "tautline/planners/fleet/tracks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "tautline/geometry/box_index.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Of the size of the fleet's ground: far above rounding, far below what anything is apart.
constexpr double kTinySpacing = 1e-7;
/// How much farther than its rank says a track keeps off the tip of a sharp turn, at most.
constexpr double kLongestMitre = 3;

Point LeftOf(Point p) { return {-p.y, p.x}; }

/// A route's passage of a node, walked in one of both directions.
struct Strand {
  std::size_t route = 0;
  std::size_t step = 0;
  int direction = 1;
};

/// Lays the routes of one ground side by side.
class Weaver {
 public:
  Weaver(const FleetGround& ground, const std::vector<Route>& routes) : ground_(ground), routes_(routes) {}

  std::vector<Polyline> Weave(const TrackOptions& options) {
    FindEnds();
    for (Route& route : routes_) {
      for (std::size_t i = 1; i + 1 < route.size(); ++i) {
        if (route[i].side == Side::kNone) route[i].side = SideBeside(route, i);
      }
    }
    FindRanks();
    const double spacing = options.spacing ? *options.spacing : TinySpacing();
    std::vector<Polyline> tracks;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      Polyline& track = tracks.emplace_back(PointsOf(ground_, routes_[r]));
      const Polyline points = track;
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        track[i] = points[i] + (spacing * ranks_[r][i]) * Outwards(points, i, routes_[r][i].side);
      }
    }
    return tracks;
  }

 private:
  Point At(const RouteStep& step) const { return ground_.point(step.node); }

  void FindEnds() {
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      if (routes_[r].size() < 2) continue;
      ends_.try_emplace(routes_[r].front().node, Strand{r, 0, 1});
      ends_.try_emplace(routes_[r].back().node, Strand{r, routes_[r].size() - 1, -1});
    }
  }

  /// Where a route passes straight over another one's end: the side from which that one comes, so that it is not
  /// crossed.
  Side SideBeside(const Route& route, std::size_t i) const {
    const auto end = ends_.find(route[i].node);
    if (end == ends_.end()) return Side::kLeft;
    const Point before = At(route[i - 1]), after = At(route[i + 1]);
    for (Strand other = end->second; HasNext(other);) {
      other = Next(other);
      const int turn = Orientation(before, after, At(StepOf(other)));
      if (turn != 0) return turn > 0 ? Side::kLeft : Side::kRight;
    }
    return Side::kLeft;
  }

  const RouteStep& StepOf(const Strand& s) const { return routes_[s.route][s.step]; }
  bool HasNext(const Strand& s) const { return s.direction > 0 ? s.step + 1 < routes_[s.route].size() : s.step > 0; }
  static Strand Next(Strand s) {
    s.step = s.direction > 0 ? s.step + 1 : s.step - 1;
    return s;
  }
  static Strand Turned(Strand s) {
    s.direction = -s.direction;
    return s;
  }
  /// The side of the node for a traveller along the strand; kNone at its end.
  Side SideOf(const Strand& s) const {
    if (s.step == 0 || s.step + 1 == routes_[s.route].size()) return Side::kNone;
    return s.direction > 0 ? StepOf(s).side : Opposite(StepOf(s).side);
  }

  /// Whether a strand that passes a node, with the node on `side`, sweeps over the direction to p.
  bool SweepsOver(const Strand& s, Side side, Point p) const {
    const Point v = At(StepOf(s)), to = At(StepOf(Next(s))), from = At(StepOf(Next(Turned(s))));
    const int sign = side == Side::kLeft ? 1 : -1;
    return sign * Orientation(v, to, p) < 0 || sign * Orientation(v, p, from) < 0;
  }

  /// Where two strands that pass one node on one side part right after it: +1 when a is to the left of b before.
  int Parting(const Strand& a, const Strand& b, Side side) const {
    // Who goes on around the node beyond where the other leaves it, is nearer to it.
    const bool a_beyond = SweepsOver(a, side, At(StepOf(Next(b))));
    const bool b_beyond = SweepsOver(b, side, At(StepOf(Next(a))));
    if (a_beyond == b_beyond) return 0;
    return a_beyond == (side == Side::kLeft) ? 1 : -1;
  }

  /// +1 when strand a, ahead of a node that both pass on the same side, turns out to be to the left of b, -1 to the
  /// right, 0 when nothing tells.
  int Ahead(Strand a, Strand b) const {
    for (;;) {
      const Side side = SideOf(a);
      const Strand after_a = Next(a), after_b = Next(b);
      const RouteStep &step_a = StepOf(after_a), &step_b = StepOf(after_b);
      if (step_a.node != step_b.node) {
        const Point v = At(StepOf(a));
        const bool one_way = Orientation(v, At(step_a), At(step_b)) == 0 && Dot(At(step_a) - v, At(step_b) - v) > 0;
        if (!one_way) return Parting(a, b, side);
        // One of them does not know of the node on its way.
        const bool a_knows = Distance(v, At(step_a)) < Distance(v, At(step_b));
        const Side known = SideOf(a_knows ? after_a : after_b);
        return known == Side::kNone ? 0 : a_knows == (known == Side::kRight) ? 1 : -1;
      }
      const Side side_a = SideOf(after_a), side_b = SideOf(after_b);
      if (side_a != side_b) {
        // The node is between them: where it is to the right of one of them, that one is on the left.
        return side_a == Side::kRight || side_b == Side::kLeft ? 1 : -1;
      }
      if (side_a == Side::kNone) return 0;
      a = after_a;
      b = after_b;
    }
  }

  /// Whether passage a is nearer to the node than b. The lower one of both says in which direction they are compared
  /// first, so that they are compared alike all along what they share.
  bool IsNearer(const Strand& a, const Strand& b) const {
    const bool a_leads = std::tie(a.route, a.step) < std::tie(b.route, b.step);
    const Strand& leader = a_leads ? a : b;
    Strand other = a_leads ? b : a;
    const Side side = SideOf(leader);
    if (SideOf(other) != side) other = Turned(other);
    int left = Ahead(leader, other);
    if (left == 0) left = -Ahead(Turned(leader), Turned(other));
    if (left == 0) return a_leads;
    return a_leads == ((left > 0) == (side == Side::kLeft));
  }

  void FindRanks() {
    std::map<FleetNodeId, std::vector<Strand>> passages;
    ranks_.resize(routes_.size());
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      ranks_[r].assign(routes_[r].size(), 1);
      for (std::size_t i = 1; i + 1 < routes_[r].size(); ++i) passages[routes_[r][i].node].push_back({r, i, 1});
    }
    for (const auto& [node, strands] : passages) {
      for (const Strand& a : strands) {
        int& rank = ranks_[a.route][a.step];
        for (const Strand& b : strands) {
          const bool same = a.route == b.route && a.step == b.step;
          if (!same && IsNearer(b, a)) ++rank;
        }
        most_ = std::max(most_, rank);
      }
    }
  }

  /// The way off the node per metre of distance from both arms.
  static Point Outwards(const Polyline& points, std::size_t i, Side side) {
    const Point in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    const Point to = (1 / Norm(in)) * in, from = (1 / Norm(out)) * out;
    const Point normal = (side == Side::kLeft ? -0.5 : 0.5) * (LeftOf(to) + LeftOf(from));
    const double cosine = Norm(normal);
    if (cosine * kLongestMitre >= 1) return (1 / (cosine * cosine)) * normal;
    const Point tip = to - from;
    return (kLongestMitre / Norm(tip)) * tip;
  }

  /// A spacing at which no track comes near a node that its route does not pass.
  double TinySpacing() const {
    std::vector<BoxIndex::Segment> nodes;
    Box box;
    for (std::size_t k = 0; k < ground_.node_count(); ++k) {
      const Point p = ground_.point(FleetNodeId(k));
      nodes.emplace_back(p, p);
      box.Add(p);
    }
    const double room = 4 * kLongestMitre * most_;
    double spacing = kTinySpacing * Norm(box.size());
    const BoxIndex index(nodes);
    for (const Route& route : routes_) {
      if (route.size() < 3) continue;
      for (std::size_t i = 1; i < route.size(); ++i) {
        const Point a = At(route[i - 1]), b = At(route[i]);
        spacing = std::min(spacing, Distance(a, b) / room);
        index.ForEachAlong(a, b, room * spacing, [&](std::size_t k) {
          const Point p = nodes[k].first;
          if (!OnSegment(a, b, p)) spacing = std::min(spacing, DistanceToSegment(p, a, b) / room);
        });
      }
    }
    return spacing;
  }

  const FleetGround& ground_;
  std::vector<Route> routes_;
  std::map<FleetNodeId, Strand> ends_;
  std::vector<std::vector<int>> ranks_;  ///< By route and step: how many tracks are not farther from the node.
  int most_ = 1;
};

}  // namespace

std::vector<Polyline> SideBySide(const FleetGround& ground, const std::vector<Route>& routes,
                                 const TrackOptions& options) {
  return Weaver(ground, routes).Weave(options);
}

}  // namespace tautline
