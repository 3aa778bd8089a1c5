#include "tautline/planners/fleet/pair_rule.h"

#include <algorithm>
#include <set>
#include <span>
#include <tuple>

#include "tautline/geometry/box_index.h"
#include "tautline/planners/fleet/lifted_winding.h"

namespace tautline {
namespace {

bool Holds(const Box& box, Point p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

/// The cable polygons of all robots.
class CablePolygons {
 public:
  CablePolygons(const FleetGround& ground, const FleetLayout& layout, const std::vector<RobotPath>& paths)
      : ground_(ground), layout_(layout), paths_(paths) {
    for (std::size_t i = 0; i < ground.size(); ++i) {
      cables_.push_back(PointsOf(ground, layout[i]));
      boxes_.push_back(BoundingBox(cables_.back()));
      for (const Point p : paths[i].points) boxes_.back().Add(p);
      flat_.push_back(PointsOf(ground, BendsOf(ground, layout[i])) ==
                      PointsOf(ground, BendsOf(ground, paths[i].route)));
    }
  }

  const Box& box(RobotId robot) const { return boxes_[robot.index()]; }
  /// Whether cable line and path are the same.
  bool is_flat(RobotId robot) const { return flat_[robot.index()]; }

  /// How the polygon of a robot winds about a point. Where its path passes the point, that lies to the side `on_path`;
  /// where its cable line leads straight over it, to the side `on_cable`.
  LiftedWinding WindingAbout(RobotId robot, Point p, Side on_path, Side on_cable) const {
    LiftedWinding winding(ground_.space(), p);
    if (is_flat(robot) || !Holds(box(robot), p)) return winding;
    std::vector<Side> sides;
    for (const RouteStep& step : layout_[robot.index()]) {
      sides.push_back(step.side == Side::kNone ? on_cable : step.side);
    }
    winding.Walk(cables_[robot.index()], sides, on_cable);
    Polyline back = paths_[robot.index()].points;
    std::reverse(back.begin(), back.end());
    winding.Walk(back, std::vector<Side>(back.size(), Opposite(on_path)), Opposite(on_path));
    return winding;
  }

 private:
  const FleetGround& ground_;
  const FleetLayout& layout_;
  const std::vector<RobotPath>& paths_;
  std::vector<Polyline> cables_;
  std::vector<Box> boxes_;
  std::vector<bool> flat_;
};

/// The word of the way along one path to a place of a contact, and from there along another one to its end.
Word WordOverContact(const TautSpace& space, const RobotPath& to, const PathSpot& to_spot, const RobotPath& from,
                     const PathSpot& from_spot, Point at) {
  const auto last = static_cast<std::ptrdiff_t>(to_spot.segment);
  Polyline way(to.points.begin(), to.points.begin() + last + 1);
  way.push_back(at);
  way.insert(way.end(), from.points.begin() + std::min<std::ptrdiff_t>(from_spot.segment + 1, std::ssize(from.points)),
             from.points.end());
  return space.rays().WordOf(way);
}

/// Decides about one pair of robots whose paths meet.
class PairJudge {
 public:
  PairJudge(const FleetGround& ground, const std::vector<RobotPath>& paths, const CablePolygons& polygons,
            std::span<const PathContact> contacts)
      : ground_(ground),
        paths_(paths),
        polygons_(polygons),
        contacts_(contacts),
        a_(contacts[0].a),
        b_(contacts[0].b) {}

  void Judge(PairInteractions& out) {
    for (const PathContact& contact : contacts_) {
      if (!contact.of_a.starts && !contact.of_b.starts) continue;
      const bool a_starts = contact.of_a.starts;
      const RobotId starter = a_starts ? a_ : b_;
      out.faults.push_back({a_starts ? b_ : a_, starter, true, ground_.robot(starter).start});
      return;
    }
    // Where cable lines lead straight over targets, either side will do; take what can be realised.
    for (const Side free_a : {TouchSide(true), Opposite(TouchSide(true))}) {
      for (const Side free_b : {TouchSide(false), Opposite(TouchSide(false))}) {
        if (Try(free_a, free_b)) {
          out.orders.insert(out.orders.end(), orders_.begin(), orders_.end());
          return;
        }
      }
    }
    if (fault_) {
      out.faults.push_back({a_, b_, false, *fault_});
    } else {
      out.deadlocks.push_back({std::min(a_, b_), std::max(a_, b_)});
    }
  }

 private:
  /// The side of one path from which the other robot comes to its target on it; anything where it does not.
  Side TouchSide(bool on_a) const {
    for (const PathContact& contact : contacts_) {
      const PathVisit& visit = on_a ? contact.of_b : contact.of_a;
      if (visit.ends && visit.from != Side::kNone) return visit.from;
    }
    return Side::kLeft;
  }

  Word Lift(const PathContact& contact, bool of_b) const {
    if (ground_.space() == nullptr) return {};
    const RobotPath &a = paths_[a_.index()], &b = paths_[b_.index()];
    // b comes to `at`, which is where a leaves where they run against each other.
    const PathSpot& on_a = contact.against ? contact.of_a.out : contact.of_a.in;
    const PathSpot& on_b = contact.of_b.in;
    return of_b ? WordOverContact(*ground_.space(), a, on_a, b, on_b, contact.at)
                : WordOverContact(*ground_.space(), b, on_b, a, on_a, contact.at);
  }

  bool Try(Side free_a, Side free_b) {
    orders_.clear();
    const auto of_a = polygons_.WindingAbout(a_, ground_.robot(b_).target, TouchSide(true), free_a);
    const auto of_b = polygons_.WindingAbout(b_, ground_.robot(a_).target, TouchSide(false), free_b);
    std::vector<Word> used_a, used_b;
    for (const PathContact& contact : contacts_) {
      if (contact.crosses()) {
        used_a.push_back(Lift(contact, true));
        used_b.push_back(Lift(contact, false));
        if (!Order(contact, of_a.About(used_a.back()), of_b.About(used_b.back()))) return false;
      } else if (contact.of_a.ends || contact.of_b.ends) {
        if (contact.of_a.ends && contact.of_b.ends) return false;
        orders_.push_back({contact, contact.of_b.ends});
      }
    }
    return NothingElse(of_a, used_a) && NothingElse(of_b, used_b);
  }

  /// Orders a crossing by the winding numbers of the polygons of a about the target of b and the other way round.
  bool Order(const PathContact& contact, int in_a, int in_b) {
    // The polygon of a runs counter-clockwise around what was pushed to the right of its path.
    const int push_by_b = contact.of_b.from == Side::kLeft ? 1 : -1;
    const int push_by_a = contact.of_a.from == Side::kLeft ? 1 : -1;
    if ((in_a != 0) == (in_b != 0)) fault_ = contact.at;
    if (!(in_a == push_by_b && in_b == 0) && !(in_b == push_by_a && in_a == 0)) return false;
    orders_.push_back({contact, in_a != 0});
    return true;
  }

  static bool NothingElse(const LiftedWinding& winding, const std::vector<Word>& used) {
    for (const auto& [lift, number] : winding.NonZero()) {
      if (std::find(used.begin(), used.end(), lift) == used.end()) return false;
    }
    return true;
  }

  const FleetGround& ground_;
  const std::vector<RobotPath>& paths_;
  const CablePolygons& polygons_;
  std::span<const PathContact> contacts_;
  RobotId a_, b_;
  std::vector<OrderedContact> orders_;
  std::optional<Point> fault_;
};

bool InOrder(const PathContact& contact, std::pair<RobotId, RobotId> pair) {
  return std::pair(contact.a, contact.b) < pair;
}

/// Targets and starts inside of cable polygons of robots whose paths they do not meet.
class InsideFinder {
 public:
  InsideFinder(const FleetGround& ground, const CablePolygons& polygons, const std::vector<PathContact>& contacts)
      : ground_(ground), polygons_(polygons), contacts_(contacts) {}

  void Find(PairInteractions& out) const {
    std::vector<BoxIndex::Segment> points;
    for (const FleetRobot& robot : ground_.robots()) points.emplace_back(robot.start, robot.start);
    for (const FleetRobot& robot : ground_.robots()) points.emplace_back(robot.target, robot.target);
    const BoxIndex index(points);
    std::set<std::pair<RobotId, RobotId>> deadlocks;
    for (std::size_t i = 0; i < ground_.size(); ++i) {
      const RobotId robot(i);
      if (polygons_.is_flat(robot)) continue;
      index.ForEachNear(polygons_.box(robot), [&](std::size_t k) {
        const RobotId other(k % ground_.size());
        const bool is_start = k < ground_.size();
        if (other == robot || !Holds(polygons_.box(robot), points[k].first)) return;
        if (!is_start && Meet(robot, other)) return;
        if (!IsInside(robot, points[k].first)) return;
        if (is_start) {
          out.faults.push_back({robot, other, true, points[k].first});
        } else {
          deadlocks.emplace(std::min(robot, other), std::max(robot, other));
        }
      });
    }
    for (const auto& [a, b] : deadlocks) out.deadlocks.push_back({a, b});
  }

 private:
  bool Meet(RobotId a, RobotId b) const {
    const auto pair = std::pair(std::min(a, b), std::max(a, b));
    const auto found = std::lower_bound(contacts_.begin(), contacts_.end(), pair, InOrder);
    return found != contacts_.end() && std::pair(found->a, found->b) == pair;
  }

  bool IsInside(RobotId robot, Point p) const {
    for (const Side free : {Side::kLeft, Side::kRight}) {
      if (polygons_.WindingAbout(robot, p, Side::kLeft, free).NonZero().empty()) return false;
    }
    return true;
  }

  const FleetGround& ground_;
  const CablePolygons& polygons_;
  const std::vector<PathContact>& contacts_;
};

}  // namespace

PairInteractions FindInteractions(const FleetGround& ground, const FleetLayout& layout,
                                  const std::vector<RobotPath>& paths, const std::vector<PathContact>& contacts) {
  const CablePolygons polygons(ground, layout, paths);
  PairInteractions interactions;
  for (std::size_t begin = 0, end = 0; begin < contacts.size(); begin = end) {
    while (end < contacts.size() && contacts[end].a == contacts[begin].a && contacts[end].b == contacts[begin].b) ++end;
    PairJudge(ground, paths, polygons, std::span(&contacts[begin], end - begin)).Judge(interactions);
  }
  InsideFinder(ground, polygons, contacts).Find(interactions);
  const auto by_pair = [](const auto& p, const auto& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); };
  std::sort(interactions.deadlocks.begin(), interactions.deadlocks.end(), by_pair);
  std::stable_sort(interactions.faults.begin(), interactions.faults.end(), by_pair);
  const auto same = [](const auto& p, const auto& q) { return p.a == q.a && p.b == q.b; };
  interactions.faults.erase(std::unique(interactions.faults.begin(), interactions.faults.end(), same),
                            interactions.faults.end());
  return interactions;
}

}  // namespace tautline
