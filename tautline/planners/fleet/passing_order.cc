#include "tautline/planners/fleet/passing_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

namespace tautline {
namespace {

/// Who goes first where, by the two robots.
using Orders = std::map<std::pair<RobotId, RobotId>, std::vector<const Passing*>>;

Orders OrdersOf(const std::vector<Passing>& passings) {
  Orders orders;
  for (const Passing& passing : passings) {
    orders[{std::min(passing.first, passing.second), std::max(passing.first, passing.second)}].push_back(&passing);
  }
  return orders;
}

/// The order that is meant for a crossing, if one is.
const Passing* OrderAt(const Orders& orders, const TrackCrossing& crossing) {
  const auto found = orders.find({crossing.robots[0], crossing.robots[1]});
  if (found == orders.end()) return nullptr;
  const auto distance = [&](const Passing* p) {
    const bool in_order = p->first == crossing.robots[0];
    return std::fabs(crossing.along[in_order ? 0 : 1] - p->first_along) +
           std::fabs(crossing.along[in_order ? 1 : 0] - p->second_along);
  };
  return *std::min_element(found->second.begin(), found->second.end(),
                           [&](const Passing* a, const Passing* b) { return distance(a) < distance(b); });
}

/// The order in which crossings are passed. Its moments are those of the schedule; two that are one moment are as the
/// orders say.
class PassingOrder {
 public:
  PassingOrder(const std::vector<RobotSchedule>& schedule, const std::vector<Passing>& passings, const Closeness& close)
      : schedule_(schedule), orders_(OrdersOf(passings)), close_(close) {}

  /// All meetings, each after those that it waits for.
  tl::expected<std::vector<Meeting>, PlaybackCollision> Sort(const std::vector<Track>& tracks) {
    const std::vector<TrackCrossing> crossings = FindTrackCrossings(tracks);
    Gather(crossings);
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      if (const auto collision = Relate(crossings[c], c, tracks)) return tl::unexpected(*collision);
    }
    return Arrange();
  }

 private:
  /// Crossings of one robot at one place are one meeting.
  void Gather(const std::vector<TrackCrossing>& crossings) {
    std::vector<std::tuple<RobotId, double, std::size_t, std::size_t>> places;
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      for (std::size_t k = 0; k < 2; ++k) {
        places.emplace_back(crossings[c].robots[k], crossings[c].along[k], c, k);
      }
    }
    std::sort(places.begin(), places.end());
    meeting_of_.resize(crossings.size());
    for (const auto& [robot, along, c, k] : places) {
      const bool own = !meetings_.empty() && meetings_.back().robot == robot;
      if (!own || along > meetings_.back().last + close_.place) {
        meetings_.push_back({robot, along, along, 0, {}, own ? 1u : 0u});
        if (own) meetings_[meetings_.size() - 2].after.push_back(meetings_.size() - 1);
      }
      meetings_.back().last = along;
      meeting_of_[c][k] = meetings_.size() - 1;
    }
  }

  std::optional<PlaybackCollision> Relate(const TrackCrossing& crossing, std::size_t c,
                                          const std::vector<Track>& tracks) {
    const Passing* order = OrderAt(orders_, crossing);
    std::array<double, 2> t{};
    for (std::size_t k = 0; k < 2; ++k) {
      const RobotId robot = crossing.robots[k];
      const RobotSchedule& schedule = schedule_[robot.index()];
      const bool first = order != nullptr && order->first == robot;
      const double along = order == nullptr ? crossing.along[k] : first ? order->first_along : order->second_along;
      t[k] = PassingTime(schedule, along, close_);
      Meeting& meeting = meetings_[meeting_of_[c][k]];
      meeting.t = std::max(meeting.t, t[k]);
    }
    const bool tie = std::fabs(t[0] - t[1]) <= close_.moment;
    const bool second_leads = tie ? order != nullptr && order->first == crossing.robots[1] : t[1] < t[0];
    const std::size_t early = second_leads ? 1 : 0;
    const PlaybackCollision collision{crossing.robots[0], crossing.robots[1], crossing.at, t[early]};
    if (tie && order == nullptr) return collision;
    // Nobody drives over a base, nor over a robot that has come to stay.
    for (std::size_t k = 0; k < 2; ++k) {
      const Track& own = tracks[crossing.robots[k].index()];
      if (crossing.along[k] <= own.along.front()) return collision;
      if (k == early && crossing.along[k] >= own.along.back()) return collision;
    }
    meetings_[meeting_of_[c][early]].after.push_back(meeting_of_[c][1 - early]);
    ++meetings_[meeting_of_[c][1 - early]].waits_for;
    return std::nullopt;
  }

  tl::expected<std::vector<Meeting>, PlaybackCollision> Arrange() {
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> ready;
    for (std::size_t m = 0; m < meetings_.size(); ++m) {
      if (meetings_[m].waits_for == 0) ready.emplace(meetings_[m].t, m);
    }
    std::vector<Meeting> sorted;
    while (!ready.empty()) {
      const auto [t, m] = ready.top();
      ready.pop();
      for (const std::size_t after : meetings_[m].after) {
        if (--meetings_[after].waits_for == 0) ready.emplace(meetings_[after].t, after);
      }
      sorted.push_back(meetings_[m]);
      // What waits for something is not before it.
      if (sorted.size() > 1) sorted.back().t = std::max(t, sorted[sorted.size() - 2].t);
    }
    if (sorted.size() == meetings_.size()) return sorted;
    // Robots that wait for each other in a circle, all at one moment.
    const auto stuck =
        std::find_if(meetings_.begin(), meetings_.end(), [](const Meeting& m) { return m.waits_for > 0; });
    const RobotSchedule& schedule = schedule_[stuck->robot.index()];
    return tl::unexpected(PlaybackCollision{stuck->robot, stuck->robot, PositionAt(schedule, stuck->t), stuck->t});
  }

  const std::vector<RobotSchedule>& schedule_;
  Orders orders_;
  Closeness close_;
  std::vector<Meeting> meetings_;  ///< By robot and along.
  std::vector<std::array<std::size_t, 2>> meeting_of_;
};

}  // namespace

double PassingTime(const RobotSchedule& schedule, double along, const Closeness& close) {
  const auto& events = schedule.events;
  const auto next = std::partition_point(events.begin(), events.end(),
                                         [&](const FleetEvent& event) { return event.along < along - close.event; });
  if (next == events.end() || next + 1 == events.end()) {
    if (next == events.end() || next->along <= along + close.event) return events.back().arrival;
  }
  if (next->along <= along + close.event || next == events.begin()) return next->departure;
  const FleetEvent& before = *(next - 1);
  const double share = (along - before.along) / (next->along - before.along);
  return before.departure + share * (next->arrival - before.departure);
}

double AlongAt(const RobotSchedule& schedule, double t) {
  const auto& events = schedule.events;
  const auto next =
      std::partition_point(events.begin(), events.end(), [&](const FleetEvent& event) { return event.arrival <= t; });
  if (next == events.begin()) return events.front().along;
  const FleetEvent& last = *(next - 1);
  if (next == events.end() || t <= last.departure) return last.along;
  return last.along + (t - last.departure) / (next->arrival - last.departure) * (next->along - last.along);
}

tl::expected<std::vector<Meeting>, PlaybackCollision> SortMeetings(const std::vector<Track>& tracks,
                                                                   const std::vector<RobotSchedule>& schedule,
                                                                   const std::vector<Passing>& passings,
                                                                   const Closeness& close) {
  return PassingOrder(schedule, passings, close).Sort(tracks);
}

}  // namespace tautline
