// What a robot on a tether can see around it, as numbers for a small network: the same for all maps.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_VIEW_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_VIEW_H_

#include <array>
#include <cstddef>

#include "tautline/planners/contact_free/tether_env.h"

namespace tautline {

/// Rays around the robot, evenly from its heading on.
inline constexpr int kViewRays = 24;
/// Nodes of the cable before the tail.
inline constexpr int kViewNodes = 6;
/// Points of the reference ahead, each twice as far along it as the one before.
inline constexpr int kViewAhead = 5;
/// How many numbers a view has: for each ray the free ground and the cable, for each node its place and its distance
/// from blocked ground, for each point ahead its place, and four of the whole: the distance to the goal and that from
/// the base in shares of the cable, the cable on the reel, and how far the robot is from the reference.
inline constexpr int kViewSize = 2 * kViewRays + 3 * kViewNodes + 2 * kViewAhead + 4;

/// Lengths in robot radii, cut off at kViewReach and divided by it, the nodes' distances from blocked ground at a
/// quarter of that; places in the robot's frame. All within [-1, 1].
using DriverView = std::array<float, kViewSize>;
/// How far the robot sees, robot radii.
inline constexpr double kViewReach = 10;

/// Where the robot is along its reference: the nearest of the next few way-points, never back. Start with 0. O(1).
std::size_t AdvanceAlong(const TetherEnv& env, std::size_t waypoint);

/// The view from where the robot stands, `waypoint` being the last value of AdvanceAlong. Without way-points the goal
/// stands for them. O(rays * steps of a ray + nodes).
DriverView LookAround(const TetherEnv& env, std::size_t waypoint);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_VIEW_H_
