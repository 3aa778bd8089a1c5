// What all pictures of fleets share: one look for each robot, starts, targets and cable lines side by side.
#ifndef TAUTLINE_DRAW_FLEET_LAYERS_H_
#define TAUTLINE_DRAW_FLEET_LAYERS_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/draw/legend.h"
#include "tautline/draw/map_drawing.h"
#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// How the lines of a robot are drawn: colour and pattern tell robots apart, of many robots those with near numbers.
LineStyle RobotLine(RobotId robot, std::size_t count);

/// The free space to draw; one without blocked ground for a fleet alone in the plane.
FreeSpace DrawnSpace(const FleetGround& ground);

/// All starts, targets and points of cable lines: what a map of the fleet should hold.
std::vector<Point> FleetPoints(const FleetGround& ground);

/// What a map of the fleet shows: its world, or, in the open plane, FleetPoints.
Box FleetBox(const FleetGround& ground);

/// How many decimals lengths have in pictures of this fleet.
int FleetDecimals(const FleetGround& ground);

/// The cable lines in pixels, beside each other where they share edges. By RobotId.
std::vector<Polyline> CableTracks(const View& view, const FleetGround& ground, const FleetLayout& layout);

/// Draws the cable lines; those of large fleets thinner.
void DrawCableLines(MapDrawing& map, const FleetGround& ground, const FleetLayout& layout);

/// Marks starts and targets in the colours of the robots, named as far as there is room.
void MarkFleet(MapDrawing& map, const FleetGround& ground);

/// What the marks are.
std::vector<LegendEntry> MarksLegend();

/// "r1", "r1 and r2", "r1, r2 and r3", "r1, r2, r3 and 5 more".
std::string NamesText(const FleetGround& ground, std::span<const RobotId> robots);

/// "14 s", with about four digits.
std::string TimeText(double seconds);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_FLEET_LAYERS_H_
