#include "tautline/draw/fleet_schedule.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "tautline/draw/fleet_layers.h"

namespace tautline {
namespace {

/// All times of a robot that are not spent driving, from 0 to its arrival.
double WaitOf(const RobotSchedule& schedule) {
  double wait = 0;
  for (const FleetEvent& event : schedule.events) wait += event.departure - event.arrival;
  return wait;
}

std::vector<std::size_t> Shown(const FleetPlan& plan) {
  std::vector<std::size_t> robots(plan.schedule.size());
  std::iota(robots.begin(), robots.end(), 0);
  if (robots.size() <= kMostScheduleRows) return robots;
  const auto rank = [&](std::size_t i) {
    return std::tuple(-WaitOf(plan.schedule[i]), -plan.schedule[i].events.back().arrival, i);
  };
  std::sort(robots.begin(), robots.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  robots.resize(kMostScheduleRows);
  std::sort(robots.begin(), robots.end());
  return robots;
}

/// The labels of the crossings that are passed at an event.
std::string LabelOf(const FleetPlan& plan, const FleetEvent& event) {
  std::string label;
  const std::size_t straight = plan.passings.size();
  // A motion that was not planned here has events and no labels.
  if (straight + plan.detour_passings.size() == 0) return label;
  for (const std::size_t k : event.passings) {
    const Passing& passing = k < straight ? plan.passings[k] : plan.detour_passings[k - straight];
    label += (label.empty() ? "" : ",") + passing.label;
  }
  return label;
}

}  // namespace

std::vector<GanttRow> ScheduleRows(const FleetGround& ground, const FleetPlan& plan) {
  std::vector<GanttRow> rows;
  for (const std::size_t i : Shown(plan)) {
    const auto& events = plan.schedule[i].events;
    GanttRow row{.name = ground.robots()[i].name, .colour = RobotLine(RobotId(i), ground.size()).colour};
    for (std::size_t k = 0; k < events.size(); ++k) {
      if (k > 0) row.bars.push_back({events[k - 1].departure, events[k].arrival, false});
      if (events[k].departure > events[k].arrival) row.bars.push_back({events[k].arrival, events[k].departure, true});
      if (events[k].kind == FleetEventKind::kPassing) {
        row.marks.push_back({events[k].departure, LabelOf(plan, events[k])});
      }
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tautline
