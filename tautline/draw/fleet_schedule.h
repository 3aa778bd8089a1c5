// A fleet's schedule as the rows of a Gantt chart.
#ifndef TAUTLINE_DRAW_FLEET_SCHEDULE_H_
#define TAUTLINE_DRAW_FLEET_SCHEDULE_H_

#include <vector>

#include "tautline/draw/gantt_chart.h"
#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

inline constexpr std::size_t kMostScheduleRows = 40;  ///< Robots in one chart.

/// One row per robot with its drives, waits and crossings. Of more robots than kMostScheduleRows, those that wait
/// longest, and of these those that arrive last, in the order of the robots.
std::vector<GanttRow> ScheduleRows(const FleetGround& ground, const FleetPlan& plan);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_FLEET_SCHEDULE_H_
