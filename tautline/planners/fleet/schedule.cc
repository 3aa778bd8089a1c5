#include "tautline/planners/fleet/schedule.h"

#include <algorithm>
#include <cmath>

namespace tautline {
namespace {

/// A robot's position on a polyline in time: corners of it, in order of time.
class Track {
 public:
  explicit Track(const RobotSchedule& schedule) {
    for (const FleetEvent& event : schedule.events) {
      Add(event.arrival, event.at);
      Add(event.departure, event.at);
    }
  }

  const std::vector<double>& times() const { return times_; }

  /// Where the robot is; `hint` grows with t.
  Point At(double t, std::size_t& hint) const {
    while (hint + 1 < times_.size() && times_[hint + 1] <= t) ++hint;
    if (hint + 1 == times_.size() || t <= times_[hint]) return points_[hint];
    return Lerp(points_[hint], points_[hint + 1], (t - times_[hint]) / (times_[hint + 1] - times_[hint]));
  }

 private:
  void Add(double t, Point p) {
    if (!times_.empty() && times_.back() == t && points_.back() == p) return;
    times_.push_back(t);
    points_.push_back(p);
  }

  std::vector<double> times_;
  std::vector<Point> points_;
};

}  // namespace

std::optional<std::vector<RobotSchedule>> EarliestSchedule(const FleetGround& ground,
                                                           const std::vector<RobotPath>& paths,
                                                           const EventGraph& graph) {
  const OrderGraph flat = graph.Flat();
  const auto order = TopologicalOrder(flat);
  if (!order) return std::nullopt;
  const std::vector<std::size_t> offsets = graph.Offsets();
  std::vector<RobotSchedule> schedule;
  for (std::size_t i = 0; i < paths.size(); ++i) schedule.push_back({paths[i], graph.chains[i]});
  std::vector<double> not_before(flat.size(), 0);
  for (const std::uint32_t v : *order) {
    const RobotId robot = flat.robot_of[v];
    auto& events = schedule[robot.index()].events;
    const std::size_t e = v - offsets[robot.index()];
    FleetEvent& event = events[e];
    if (e > 0) {
      const double way = event.along - events[e - 1].along;
      event.arrival = events[e - 1].departure + way / ground.robot(robot).speed;
    }
    event.departure = std::max(event.arrival, not_before[v]);
    if (event.kind == FleetEventKind::kTarget && event.departure > event.arrival) {
      // It waits at the event before, which is there for that and holds up nobody else.
      events[e - 1].departure += event.departure - event.arrival;
      event.arrival = event.departure;
    }
    for (const std::uint32_t next : flat.after[v]) {
      if (flat.robot_of[next] != robot) not_before[next] = std::max(not_before[next], event.departure);
    }
  }
  return schedule;
}

std::vector<RobotSchedule> SequentialSchedule(const FleetGround& ground, const std::vector<RobotPath>& paths,
                                              const EventGraph& graph, const std::vector<RobotId>& order) {
  std::vector<RobotSchedule> schedule;
  for (std::size_t i = 0; i < paths.size(); ++i) schedule.push_back({paths[i], graph.chains[i]});
  double begin = 0;
  for (const RobotId robot : order) {
    auto& events = schedule[robot.index()].events;
    for (FleetEvent& event : events) {
      event.arrival = event.departure = begin + event.along / ground.robot(robot).speed;
    }
    events.front().arrival = 0;
    begin = events.back().departure;
  }
  return schedule;
}

void SlowDownInsteadOfWaiting(std::vector<RobotSchedule>& schedule) {
  for (RobotSchedule& robot : schedule) {
    for (std::size_t e = 1; e < robot.events.size(); ++e) robot.events[e].arrival = robot.events[e].departure;
  }
}

TravelCost CostOf(const std::vector<RobotSchedule>& schedule) {
  TravelCost cost;
  for (const RobotSchedule& robot : schedule) {
    cost.time = std::max(cost.time, robot.events.back().departure);
    cost.distance += robot.path.length();
  }
  return cost;
}

double LeastDistance(const RobotSchedule& a, const RobotSchedule& b) {
  const Track of_a(a), of_b(b);
  std::vector<double> times(of_a.times().size() + of_b.times().size());
  std::merge(of_a.times().begin(), of_a.times().end(), of_b.times().begin(), of_b.times().end(), times.begin());
  std::size_t in_a = 0, in_b = 0;
  Point before = of_b.At(times[0], in_b) - of_a.At(times[0], in_a);
  double least = Norm(before);
  for (const double t : times) {
    const Point now = of_b.At(t, in_b) - of_a.At(t, in_a);
    // Between two moments, one robot goes straight as seen from the other.
    const Point way = now - before;
    const double square = Dot(way, way);
    const double share = square > 0 ? std::clamp(-Dot(before, way) / square, 0.0, 1.0) : 0.0;
    least = std::min({least, Norm(before + share * way), Norm(now)});
    before = now;
  }
  return least;
}

}  // namespace tautline
