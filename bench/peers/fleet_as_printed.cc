#include "bench/peers/fleet_as_printed.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Whether the point infinitely near `p` in the direction `d` lies inside, by the even-odd rule. Requires d.y != 0, and
/// that d is not parallel to an edge through p.
bool IsInside(const std::vector<Point>& polygon, Point p, Point d) {
  const auto above = [&](Point q) { return q.y > p.y || (q.y == p.y && d.y < 0); };
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    Point low = polygon[j], high = polygon[i];
    if (above(low) == above(high)) continue;
    if (low.y > high.y) std::swap(low, high);
    int side = Orientation(low, high, p);
    if (side == 0) side = Cross(high - low, d) > 0 ? 1 : -1;
    if (side > 0) inside = !inside;
  }
  return inside;
}

/// A crossing of two straight paths, seen by one of the robots.
struct Event {
  std::size_t robot = 0;
  double along = 0;
  bool is_first = false;
  std::size_t other = 0;        ///< The same crossing seen by the other robot, by position among all events.
  std::size_t other_robot = 0;  ///< Who that is.
};

class PrintedPlanner {
 public:
  PrintedPlanner(const FleetGround& ground, const FleetLayout& layout) : ground_(ground), layout_(layout) {
    for (const Route& route : layout) polygons_.push_back(PointsOf(ground, route));
    alive_.assign(ground.size(), true);
    chains_.resize(ground.size());
  }

  PrintedPlan Plan() {
    ComparePairs();
    DissolvePairDeadlocks();
    SortChains();
    DissolveNetworkDeadlocks();
    Schedule();
    return std::move(plan_);
  }

 private:
  Point Start(std::size_t i) const { return ground_.robots()[i].start; }
  Point Target(std::size_t i) const { return ground_.robots()[i].target; }
  double Length(std::size_t i) const { return Distance(Start(i), Target(i)); }

  /// Whether the target of robot i is in the polygon of robot j.
  bool IsTargetInside(std::size_t i, std::size_t j) const {
    const std::vector<Point>& polygon = polygons_[j];
    const Point p = Target(i);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
      if (polygon[k] != p) continue;
      const Point u = polygon[k - 1] - p, v = polygon[k + 1] - p;
      const Point middle = (1 / std::hypot(u.x, u.y)) * u + (1 / std::hypot(v.x, v.y)) * v;
      return IsInside(polygon, p, middle.y != 0 ? middle : middle + u);
    }
    return IsInside(polygon, p, {0.5, 1});
  }

  void ComparePairs() {
    const std::size_t n = ground_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        if (CrossProperly(Start(i), Target(i), Start(j), Target(j))) {
          const bool j_first = IsTargetInside(i, j);
          AddPassing(j_first ? j : i, j_first ? i : j);
        } else if (IsTargetInside(i, j) && IsTargetInside(j, i)) {
          plan_.pair_deadlocks.emplace_back(RobotId(i), RobotId(j));
        }
      }
    }
  }

  double AlongAtCrossing(std::size_t i, std::size_t j) const {
    const Point d = Target(i) - Start(i), e = Target(j) - Start(j);
    return Length(i) * Cross(Start(j) - Start(i), e) / Cross(d, e);
  }

  void AddPassing(std::size_t first, std::size_t second) {
    plan_.passings.emplace_back(RobotId(first), RobotId(second));
    const std::size_t k = events_.size();
    events_.push_back({first, AlongAtCrossing(first, second), true, k + 1, second});
    events_.push_back({second, AlongAtCrossing(second, first), false, k, first});
    chains_[first].push_back(k);
    chains_[second].push_back(k + 1);
  }

  void TakeOut(std::size_t robot) {
    alive_[robot] = false;
    plan_.detours.emplace_back(robot);
  }

  void DissolvePairDeadlocks() {
    for (;;) {
      std::vector<std::size_t> count(ground_.size());
      for (const auto& [a, b] : plan_.pair_deadlocks) {
        if (!alive_[a.index()] || !alive_[b.index()]) continue;
        ++count[a.index()];
        ++count[b.index()];
      }
      const auto most = std::max_element(count.begin(), count.end());
      if (*most == 0) return;
      TakeOut(static_cast<std::size_t>(most - count.begin()));
    }
  }

  void SortChains() {
    for (auto& chain : chains_) {
      std::sort(chain.begin(), chain.end(),
                [&](std::size_t a, std::size_t b) { return events_[a].along < events_[b].along; });
    }
  }

  bool Counts(std::size_t event) const { return alive_[events_[event].robot] && alive_[events_[event].other_robot]; }

  /// Goes through the events in an order that keeps all edges: calls visit(event) for each that it comes to. Returns
  /// how many of each robot's events were left.
  template <class Visit>
  std::vector<std::size_t> Sort(Visit visit) const {
    std::vector<std::size_t> next(ground_.size()), open(ground_.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    std::vector<bool> passed(events_.size());
    while (!open.empty()) {
      const std::size_t robot = open.back();
      open.pop_back();
      for (; next[robot] < chains_[robot].size(); ++next[robot]) {
        const std::size_t k = chains_[robot][next[robot]];
        if (!Counts(k)) continue;
        if (!events_[k].is_first && !passed[events_[k].other]) break;
        passed[k] = true;
        visit(k);
        if (events_[k].is_first) open.push_back(events_[k].other_robot);
      }
    }
    std::vector<std::size_t> left(ground_.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      for (std::size_t k = next[i]; k < chains_[i].size(); ++k) left[i] += Counts(chains_[i][k]);
    }
    return left;
  }

  void DissolveNetworkDeadlocks() {
    for (;;) {
      const auto left = Sort([](std::size_t) {});
      const auto most = std::max_element(left.begin(), left.end());
      if (*most == 0) return;
      TakeOut(static_cast<std::size_t>(most - left.begin()));
    }
  }

  void Schedule() {
    std::vector<double> at(events_.size()), time(ground_.size()), place(ground_.size());
    const auto drive = [&](std::size_t robot, double along) {
      time[robot] += (along - place[robot]) / ground_.robots()[robot].speed;
      place[robot] = along;
    };
    Sort([&](std::size_t k) {
      const Event& event = events_[k];
      drive(event.robot, event.along);
      if (!event.is_first) time[event.robot] = std::max(time[event.robot], at[event.other]);
      at[k] = time[event.robot];
    });
    for (std::size_t i = 0; i < ground_.size(); ++i) {
      if (!alive_[i]) continue;
      drive(i, Length(i));
      plan_.travel_time = std::max(plan_.travel_time, time[i]);
    }
    for (const RobotId robot : plan_.detours) {
      plan_.travel_time += LengthOf(ground_, layout_[robot.index()]) / ground_.robot(robot).speed;
    }
  }

  const FleetGround& ground_;
  const FleetLayout& layout_;
  std::vector<std::vector<Point>> polygons_;
  std::vector<bool> alive_;
  std::vector<Event> events_;
  std::vector<std::vector<std::size_t>> chains_;
  PrintedPlan plan_;
};

}  // namespace

PrintedPlan PlanAsPrinted(const FleetGround& ground, const FleetLayout& layout) {
  return PrintedPlanner(ground, layout).Plan();
}

}  // namespace tautline
