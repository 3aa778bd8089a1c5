// What it takes to visit one goal, and what a visit must leave possible.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_

#include <optional>

#include "tautline/planners/grid_manifold/robot_driver.h"

namespace tautline {

/// A goal of a drive, and the tests of motions that are to end there. Refers to the driver and the field.
class GoalVisit {
 public:
  /// `field` is that of the goal's cell. With `keep_retreat`, a visit after which the robot could not drive back to the
  /// base is none.
  GoalVisit(RobotDriver& driver, Point goal, const ManifoldGoalField& field, bool keep_retreat);

  /// The vertices of the goal's cell, and those from which it is no farther away than the robot is wide, both straight
  /// and along the manifold.
  const Destination& destination() const { return destination_; }

  /// Whether some open way leads there as the cable lies. O(FindWay).
  bool IsWayOpen(const DriveState& state) const;
  /// In how many places the cable blocks the shortest way to the goal. O(FindWay).
  int CountBlockedPlaces(const DriveState& state) const;
  /// The state after driving there, or nothing when the cable comes into the way or the retreat is lost. With
  /// retreats, also by ways that end at other vertices of the goal, nearest first. O(simulating it).
  std::optional<DriveState> Try(const DriveState& state) const;
  /// Whether the robot could drive back to its base from here without driving over its cable; true without
  /// `keep_retreat`. O(simulating it).
  bool KeepsRetreat(const DriveState& state) const;

 private:
  std::optional<DriveState> TryTo(const Destination& destination, const DriveState& state) const;

  RobotDriver& driver_;
  const ManifoldGoalField& field_;
  bool keep_retreat_;
  Destination destination_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_
