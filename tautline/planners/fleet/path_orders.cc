#include "tautline/planners/fleet/path_orders.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"
#include "tautline/planners/fleet/plan_fleet.h"

namespace tautline {
namespace {

/// Crossings of one path that are no farther apart than this share of its length are one place: rounding moves a
/// crossing of two lines by less unless they are all but parallel.
constexpr double kSamePlace = 1e-12;

Point PointAlong(const RobotPath& path, double along) {
  const auto next = std::upper_bound(path.along.begin(), path.along.end(), along);
  if (next == path.along.begin()) return path.points.front();
  if (next == path.along.end()) return path.points.back();
  const auto i = static_cast<std::size_t>(next - path.along.begin());
  return Lerp(path.points[i - 1], path.points[i], (along - path.along[i - 1]) / (path.along[i] - path.along[i - 1]));
}

}  // namespace

PathOrders::PathOrders(const FleetGround& ground, std::vector<RobotPath> paths) : paths_(std::move(paths)) {
  for (const FleetRobot& robot : ground.robots()) speeds_.push_back(robot.speed);
  for (const PathContact& contact : FindContacts(paths_)) AddContact(contact);
  AddEvents();
}

void PathOrders::AddContact(const PathContact& contact) {
  PathCrossing crossing{contact.a,
                        contact.b,
                        {contact.of_a.in.along, contact.of_a.out.along},
                        {contact.of_b.in.along, contact.of_b.out.along},
                        contact.at};
  if (contact.against) std::swap(crossing.b_along[0], crossing.b_along[1]);
  if (contact.crosses()) crossings_.push_back(crossing);
  crossing.is_given = true;
  // The other one must be past the place where a robot stops.
  if (contact.of_b.ends) crossings_.push_back(crossing);
  if (!contact.of_a.ends) return;
  std::swap(crossing.a, crossing.b);
  std::swap(crossing.a_along, crossing.b_along);
  crossings_.push_back(crossing);
}

void PathOrders::AddEvents() {
  struct Mark {
    double along;
    std::size_t crossing;
    int end;
  };
  std::vector<std::vector<Mark>> marks(paths_.size());
  for (std::size_t k = 0; k < crossings_.size(); ++k) {
    for (int end = 0; end < 2; ++end) {
      const auto e = static_cast<std::size_t>(end);
      marks[crossings_[k].a.index()].push_back({crossings_[k].a_along[e], k, end});
      marks[crossings_[k].b.index()].push_back({crossings_[k].b_along[e], k, end});
    }
  }
  event_at_.resize(crossings_.size());
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const RobotId robot(i);
    first_.push_back(events_.size());
    events_.push_back({robot, 0, {}});
    std::stable_sort(marks[i].begin(), marks[i].end(), [](const Mark& m, const Mark& n) { return m.along < n.along; });
    const double length = paths_[i].length();
    for (const Mark& mark : marks[i]) {
      if (mark.along > events_.back().along + kSamePlace * length) events_.push_back({robot, mark.along, {}});
      events_.back().ends.emplace_back(mark.crossing, mark.end);
      event_at_[mark.crossing][crossings_[mark.crossing].a == robot ? 0 : 1][static_cast<std::size_t>(mark.end)] =
          events_.size() - 1;
    }
    if (events_.back().along < length * (1 - kSamePlace)) events_.push_back({robot, length, {}});
  }
  first_.push_back(events_.size());
}

bool PathOrders::IsFirst(RobotId robot, std::size_t crossing, PassingOrder order) const {
  return order == (crossings_[crossing].a == robot ? PassingOrder::kA : PassingOrder::kB);
}

PassingOrders PathOrders::FirstCome() const {
  PassingOrders orders;
  for (const PathCrossing& crossing : crossings_) {
    const double a = crossing.a_along[0] / speeds_[crossing.a.index()];
    const double b = crossing.b_along[0] / speeds_[crossing.b.index()];
    orders.push_back(crossing.is_given || a <= b ? PassingOrder::kA : PassingOrder::kB);
  }
  return orders;
}

std::vector<double> PathOrders::Times(const PassingOrders& orders) const {
  std::vector<int> waits(events_.size());
  std::vector<double> times(events_.size());
  std::vector<std::size_t> open;
  for (std::size_t e = 0; e < events_.size(); ++e) {
    waits[e] = e != first_[events_[e].robot.index()];
    for (const auto& [crossing, end] : events_[e].ends) {
      waits[e] += orders[crossing] != PassingOrder::kOpen && !IsFirst(events_[e].robot, crossing, orders[crossing]);
    }
    if (waits[e] == 0) open.push_back(e);
  }
  std::size_t done = 0;
  const auto release = [&](std::size_t e, double time) {
    times[e] = std::max(times[e], time);
    if (--waits[e] == 0) open.push_back(e);
  };
  for (; !open.empty(); ++done) {
    const std::size_t e = open.back();
    open.pop_back();
    const Event& event = events_[e];
    const std::size_t robot = event.robot.index();
    if (e + 1 < first_[robot + 1]) release(e + 1, times[e] + (events_[e + 1].along - event.along) / speeds_[robot]);
    for (const auto& [crossing, end] : event.ends) {
      if (!IsFirst(event.robot, crossing, orders[crossing])) continue;
      const std::size_t other = crossings_[crossing].a == event.robot ? 1 : 0;
      release(event_at_[crossing][other][static_cast<std::size_t>(end)], times[e]);
    }
  }
  if (done < events_.size()) times.clear();
  return times;
}

std::optional<double> PathOrders::TravelTime(const PassingOrders& orders) const {
  const std::vector<double> times = Times(orders);
  if (times.empty()) return std::nullopt;
  double latest = 0;
  for (std::size_t i = 0; i < paths_.size(); ++i) latest = std::max(latest, times[first_[i + 1] - 1]);
  return latest;
}

std::pair<std::vector<RobotSchedule>, std::vector<Passing>> PathOrders::Schedule(const PassingOrders& orders) const {
  const std::vector<double> times = Times(orders);
  TAUTLINE_CHECK(!times.empty());
  std::vector<Passing> passings;
  for (std::size_t k = 0; k < crossings_.size(); ++k) {
    const PathCrossing& c = crossings_[k];
    const bool a_first = orders[k] == PassingOrder::kA;
    // The second comes to a shared part at one of its ends, and the first leaves it at one of them.
    passings.push_back({a_first ? c.a : c.b, a_first ? c.b : c.a, c.at, CrossingLabel(k),
                        std::max(a_first ? c.a_along[0] : c.b_along[0], a_first ? c.a_along[1] : c.b_along[1]),
                        std::min(a_first ? c.b_along[0] : c.a_along[0], a_first ? c.b_along[1] : c.a_along[1])});
  }
  std::vector<RobotSchedule> schedules;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    RobotSchedule schedule{paths_[i], {}};
    for (std::size_t e = first_[i]; e < first_[i + 1]; ++e) {
      FleetEvent event{FleetEventKind::kPassing, {}, events_[e].along, {}, times[e], times[e]};
      if (e == first_[i]) event.kind = FleetEventKind::kStart;
      if (e + 1 == first_[i + 1]) event.kind = FleetEventKind::kTarget;
      event.at = PointAlong(paths_[i], event.along);
      for (const auto& [crossing, end] : events_[e].ends) event.passings.push_back(crossing);
      if (e > first_[i]) {
        const FleetEvent& before = schedule.events.back();
        event.arrival = std::min(times[e], before.departure + (event.along - before.along) / speeds_[i]);
      }
      schedule.events.push_back(std::move(event));
    }
    schedules.push_back(std::move(schedule));
  }
  return {std::move(schedules), std::move(passings)};
}

}  // namespace tautline
