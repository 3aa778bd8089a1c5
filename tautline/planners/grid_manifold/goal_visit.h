// What it takes to visit one goal, and what a visit must leave possible.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "tautline/planners/grid_manifold/robot_driver.h"

namespace tautline {

/// How many motions may be simulated still.
struct TrialBudget {
  std::int64_t left = std::numeric_limits<std::int64_t>::max();  ///< Motions.

  /// Takes one; false where none is left.
  bool Spend() { return left > 0 && left-- > 0; }
};

/// What a visit must leave possible.
struct VisitRules {
  bool keep_retreat = false;                            ///< The robot could drive back to its base afterwards.
  std::function<bool(const DriveState&)> accepts = {};  ///< Asked about the state after a visit; empty: all will do.
};

/// A goal of a drive, and the tests of motions that are to end there. Refers to the driver, the field and the budget.
class GoalVisit {
 public:
  /// `field` is that of the goal's cell. A visit against the rules is none.
  GoalVisit(RobotDriver& driver, Point goal, const ManifoldGoalField& field, TrialBudget& budget,
            VisitRules rules = {});

  /// The vertices of the goal's cell, and those from which it is no farther away than the robot is wide, both straight
  /// and along the manifold.
  const Destination& destination() const { return destination_; }

  /// Whether some open way leads there as the cable lies. O(FindWay).
  bool IsWayOpen(const DriveState& state) const;
  /// In how many places the cable blocks the shortest way to the goal. O(FindWay).
  int CountBlockedPlaces(const DriveState& state) const;
  /// The state after driving there, or nothing when the cable comes into the way or it is against the rules. With
  /// rules, also by ways that end at other vertices of the goal, nearest first. O(simulating it).
  std::optional<DriveState> Try(const DriveState& state) const;
  /// Whether the robot could drive back to its base from here without driving over its cable; true where the rules do
  /// not ask for it. O(simulating it).
  bool KeepsRetreat(const DriveState& state) const;
  /// Takes one motion from the budget; false where there is none.
  bool MayTry() const { return budget_.Spend(); }
  /// What is asked about the state after a visit; may be empty.
  const std::function<bool(const DriveState&)>& accepts() const { return rules_.accepts; }
  /// Whether nothing is.
  bool AcceptsAll() const { return !rules_.accepts; }

 private:
  std::optional<DriveState> TryTo(const Destination& destination, const DriveState& state) const;

  RobotDriver& driver_;
  const ManifoldGoalField& field_;
  TrialBudget& budget_;
  VisitRules rules_;
  Destination destination_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_GOAL_VISIT_H_
