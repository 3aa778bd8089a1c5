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
/// Share of the coordinates that counts as size where a ground is far from the origin: shares of it that are told apart
/// from each other, of 1e-12 and more, are above the rounding of coordinates then.
constexpr double kFarAway = 1e-2;
/// The least spacing that can be told from rounding, as a share of the ground's size.
constexpr double kLeastSpacing = 2e-11;
/// Places on a segment are rounded by less than this share of the ground's size: some units in the last place of
/// coordinates, even far away.
constexpr double kRounding = 1e-13;
/// How many spacings farther off a track keeps from the tip of a sharp turn, at most.
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

  std::vector<Route> Settle() {
    FindEnds();
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      for (std::size_t i = 1; i + 1 < routes_[r].size(); ++i) passages_[routes_[r][i].node].push_back({r, i, 1});
    }
    TakeSides();
    return routes_;
  }

  std::optional<NearMiss> FindNearMiss() {
    Settle();
    FindReaches();
    const double size = SizeOfGround(ground_), least = Room() * kLeastSpacing * size;
    std::optional<NearMiss> found;
    ForEachBeside([&] { return least; },
                  [&](const Beside& beside) {
                    const double reach = beside.is_laid_off ? least : beside.is_rounded ? kRounding * size : 0;
                    if (!found && beside.distance < reach) found = {beside.route, beside.node};
                  });
    return found;
  }

  std::vector<Polyline> Weave(const TrackOptions& options) {
    Settle();
    FindReaches();
    const double spacing = options.spacing ? *options.spacing : TinySpacing();
    std::vector<Polyline> tracks;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      Polyline& track = tracks.emplace_back(PointsOf(ground_, routes_[r]));
      for (std::size_t i = 1; i + 1 < track.size(); ++i) {
        track[i] = track[i] + (spacing * reaches_[r][i]) * BendOf({r, i, 1}).out;
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

  /// Routes that pass straight over a node may be on either side of it: on that from which they do not cross the route
  /// that ends there. Where that depends on other such nodes, the ones that are clear come first.
  void TakeSides() {
    std::vector<Strand> open;
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      for (std::size_t i = 1; i + 1 < routes_[r].size(); ++i) {
        if (routes_[r][i].side == Side::kNone) open.push_back({r, i, 1});
      }
    }
    while (!open.empty()) {
      std::vector<Strand> unclear;
      for (const Strand& s : open) {
        Side& side = routes_[s.route][s.step].side;
        side = SideBeside(s);
        if (side == Side::kNone) unclear.push_back(s);
      }
      if (unclear.size() == open.size()) {
        const auto held = std::find_if(unclear.begin(), unclear.end(),
                                       [this](const Strand& s) { return SideOfBends(s) != Side::kNone; });
        const auto next = held != unclear.end() ? held : unclear.end() - 1;
        routes_[next->route][next->step].side = held != unclear.end() ? SideOfBends(*next) : Side::kLeft;
        unclear.erase(next);
      }
      open = std::move(unclear);
    }
  }

  /// The side on which the route that ends at a node lies, where a strand passes straight over it.
  Side SideBeside(const Strand& strand) const {
    const auto end = ends_.find(StepOf(strand).node);
    if (end == ends_.end() || end->second.route == strand.route) return Side::kLeft;
    const Strand back = Turned(strand);
    const Point before = At(StepOf(Next(back))), after = At(StepOf(Next(strand)));
    for (Strand other = end->second; HasNext(other);) {
      const FleetNodeId next = StepOf(Next(other)).node;
      if (next == StepOf(Next(strand)).node) return SideOfSign(Along(other, strand));
      if (next == StepOf(Next(back)).node) return SideOfSign(-Along(other, back));
      other = Next(other);
      const int turn = Orientation(before, after, At(StepOf(other)));
      if (turn != 0) return SideOfSign(turn);
    }
    return Side::kLeft;
  }

  /// The side to which routes bend that bend around the node.
  Side SideOfBends(const Strand& strand) const {
    const Point before = At(StepOf(Next(Turned(strand)))), after = At(StepOf(Next(strand)));
    for (const Strand& other : passages_.at(StepOf(strand).node)) {
      const int arrival = Orientation(before, after, At(StepOf(Next(Turned(other)))));
      const int departure = Orientation(before, after, At(StepOf(Next(other))));
      if (arrival * departure >= 0 && arrival + departure != 0) return SideOfSign(arrival + departure);
    }
    return Side::kNone;
  }

  static Side SideOfSign(int sign) { return sign > 0 ? Side::kLeft : sign < 0 ? Side::kRight : Side::kNone; }

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

  /// +1 when strand a, ahead of a node that both pass on one side, turns out to be to the left of b, -1 to the right,
  /// 0 when nothing tells.
  int Ahead(const Strand& a, const Strand& b) const {
    const RouteStep &step_a = StepOf(Next(a)), &step_b = StepOf(Next(b));
    if (step_a.node == step_b.node) return Along(a, b);
    const Point v = At(StepOf(a));
    const bool one_way = Orientation(v, At(step_a), At(step_b)) == 0 && Dot(At(step_a) - v, At(step_b) - v) > 0;
    if (!one_way) return Parting(a, b, SideOf(a));
    // One of them does not know of the node on its way.
    const bool a_knows = Distance(v, At(step_a)) < Distance(v, At(step_b));
    const Side known = SideOf(a_knows ? Next(a) : Next(b));
    return known == Side::kNone ? 0 : a_knows == (known == Side::kRight) ? 1 : -1;
  }

  /// The same for strands that take the same edge next.
  int Along(Strand a, Strand b) const {
    do {
      a = Next(a);
      b = Next(b);
      const bool open = IsOpen(a) || IsOpen(b);
      if (open && !(IsOpen(a) && IsOpen(b))) return 0;
      const Side side_a = SideOf(a), side_b = SideOf(b);
      // The node is between them: where it is to the right of one of them, that one is on the left.
      if (side_a != side_b) return side_a == Side::kRight || side_b == Side::kLeft ? 1 : -1;
      if (side_a == Side::kNone && !open) return 0;
    } while (StepOf(Next(a)).node == StepOf(Next(b)).node);
    return Ahead(a, b);
  }

  /// Whether a strand passes a node straight, on a side that is not known yet.
  bool IsOpen(const Strand& s) const {
    return s.step > 0 && s.step + 1 < routes_[s.route].size() && StepOf(s).side == Side::kNone;
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

  /// A bend: which way is off the node, and which ways are off its two arms.
  struct Bend {
    Point out, off_arrival, off_departure;
    double cosine = 1;  ///< Of half the turn: the share of a distance from the tip that is distance from the arms.
  };

  Bend BendOf(const Strand& s) const {
    const Route& route = routes_[s.route];
    const Point at = At(route[s.step]), in = at - At(route[s.step - 1]), out = At(route[s.step + 1]) - at;
    const Point to = (1 / Norm(in)) * in, from = (1 / Norm(out)) * out;
    const double sign = route[s.step].side == Side::kLeft ? -1 : 1;
    Bend bend{{}, sign * LeftOf(to), sign * LeftOf(from)};
    const Point normal = 0.5 * (bend.off_arrival + bend.off_departure), tip = to - from;
    bend.cosine = Norm(normal);
    bend.out = bend.cosine > 0.5 ? (1 / bend.cosine) * normal : (1 / Norm(tip)) * tip;
    return bend;
  }

  /// How far from its node each track turns, in spacings: so far that what is nearer to the node stays inside of it.
  void FindReaches() {
    for (const Route& route : routes_) reaches_.emplace_back(route.size(), 0.0);
    for (const auto& [node, strands] : passages_) Nest(strands);
  }

  /// The same for the strands that pass one node.
  void Nest(const std::vector<Strand>& strands) {
    const std::size_t count = strands.size();
    std::vector<std::vector<std::size_t>> nearer(count);
    std::vector<std::size_t> order(count);
    for (std::size_t b = 0; b < count; ++b) {
      order[b] = b;
      for (std::size_t a = 0; a < count; ++a) {
        if (a != b && IsNearer(strands[a], strands[b])) nearer[b].push_back(a);
      }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return nearer[a].size() < nearer[b].size(); });
    std::vector<double> reach(count, 0);  // 0 as well for those that are not placed yet.
    for (const std::size_t b : order) {
      const Bend bend = BendOf(strands[b]);
      const double step = 1 / std::max(bend.cosine, 1 / kLongestMitre);
      reach[b] = step;
      for (const std::size_t a : nearer[b]) {
        const Point out = BendOf(strands[a]).out;
        const double off_arms = std::max({Dot(out, bend.off_arrival), Dot(out, bend.off_departure), 0.0});
        reach[b] = std::max(reach[b], reach[a] * off_arms / bend.cosine + step);
      }
      reaches_[strands[b].route][strands[b].step] = reach[b];
      most_ = std::max(most_, reach[b]);
    }
  }

  /// How far off a leg a node may be, in spacings, without being in the way.
  double Room() const { return 4 * most_; }

  /// A node beside a leg of a route.
  struct Beside {
    std::size_t route = 0;
    FleetNodeId node;
    double distance = 0;  ///< Metres.
    /// Whether tracks are laid off one of the two: off the ends of the leg, or off the node.
    bool is_laid_off = false;
    /// Whether a robot that stops on the leg, or on its way from or to the node, may stand off its line by rounding.
    bool is_rounded = false;
  };

  /// Calls `visit(beside)` for every leg of a route and every node nearer to it than `reach()` but not on it.
  template <class Reach, class Visit>
  void ForEachBeside(Reach reach, Visit visit) const {
    std::vector<BoxIndex::Segment> nodes;
    for (std::size_t k = 0; k < ground_.node_count(); ++k) {
      const Point p = ground_.point(FleetNodeId(k));
      nodes.emplace_back(p, p);
    }
    const BoxIndex index(nodes);
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      for (std::size_t i = 1; i < routes_[r].size(); ++i) {
        const Point a = At(routes_[r][i - 1]), b = At(routes_[r][i]);
        const bool is_moved = reaches_[r][i - 1] > 0 || reaches_[r][i] > 0;
        const bool is_slanting = a.x != b.x && a.y != b.y;
        index.ForEachAlong(a, b, reach(), [&](std::size_t k) {
          const Point p = nodes[k].first;
          const FleetNodeId node(k);
          if (OnSegment(a, b, p)) return;
          visit(Beside{r, node, DistanceToSegment(p, a, b), is_moved || passages_.count(node) > 0,
                       is_slanting || ground_.kind(node) != FleetNodeKind::kCorner});
        });
      }
    }
  }

  /// A spacing at which no track comes near a node that its route does not pass.
  double TinySpacing() const {
    double spacing = kTinySpacing * SizeOfGround(ground_);
    for (std::size_t r = 0; r < routes_.size(); ++r) {
      for (std::size_t i = 1; i < routes_[r].size(); ++i) {
        if (reaches_[r][i - 1] <= 0 && reaches_[r][i] <= 0) continue;
        spacing = std::min(spacing, Distance(At(routes_[r][i - 1]), At(routes_[r][i])) / Room());
      }
    }
    ForEachBeside([&] { return Room() * spacing; },
                  [&](const Beside& beside) {
                    if (beside.is_laid_off) spacing = std::min(spacing, beside.distance / Room());
                  });
    return spacing;
  }

  const FleetGround& ground_;
  std::vector<Route> routes_;
  std::map<FleetNodeId, Strand> ends_;
  std::map<FleetNodeId, std::vector<Strand>> passages_;
  std::vector<std::vector<double>> reaches_;  ///< By route and step, in spacings; 0 at the ends.
  double most_ = 1;                           ///< Of all reaches.
};

}  // namespace

double SizeOfGround(const FleetGround& ground) {
  Box box;
  double farthest = 0;
  for (std::size_t k = 0; k < ground.node_count(); ++k) {
    const Point p = ground.point(FleetNodeId(k));
    box.Add(p);
    farthest = std::max({farthest, std::fabs(p.x), std::fabs(p.y)});
  }
  return std::max(Norm(box.size()), kFarAway * farthest);
}

std::optional<NearMiss> FindNearMiss(const FleetGround& ground, const std::vector<Route>& routes) {
  return Weaver(ground, routes).FindNearMiss();
}

std::vector<Route> WithSides(const FleetGround& ground, const std::vector<Route>& routes) {
  return Weaver(ground, routes).Settle();
}

std::vector<Polyline> SideBySide(const FleetGround& ground, const std::vector<Route>& routes,
                                 const TrackOptions& options) {
  return Weaver(ground, routes).Weave(options);
}

}  // namespace tautline
