// The shortest motion on which the taut tether never crosses itself. Internal to the tether planner.
#ifndef TAUTLINE_PLANNERS_TETHER_CROSSING_FREE_H_
#define TAUTLINE_PLANNERS_TETHER_CROSSING_FREE_H_

#include <cstdint>
#include <optional>

#include "tautline/homotopy/cover.h"
#include "tautline/planners/tether/plan.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {

/// Turns a plan into one without crossings. docs/plan.md has the proofs:
///
/// 1. A class of the goal can be reached without a crossing exactly when its taut tether does not cross itself: the
///    robot can drive back along the laid cable and out along the other one.
/// 2. Then the shortest such motion is the shortest path of the class, or, where on that path the tether would be
///    pulled over the base, the shortest path to the base and on from there, with the tether all the way out.
/// 3. The shortest tether of all crosses nowhere. So a goal in reach is in reach without a crossing.
class CrossingFreeSearch {
 public:
  /// `result` holds the plan that may cross: a motion, or none where the budget ran out.
  CrossingFreeSearch(const TetherPlanner& planner, const LaidCable& laid, Place goal, const PlanOptions& options,
                     PlanResult& result);

  /// Replaces the motion of the result. `shortest` is the shortest path from where the tether begins to the goal, which
  /// must be within the limit. O(n^2) per class for n corners of its curves, beside the enumeration of classes by path
  /// length; usually the first ones decide.
  void Run(const Polyline& shortest);

  /// Whether the robot, on the shortest path between two configurations whose taut tethers do not cross themselves, has
  /// its tether cross itself on the way: the two tethers, base first, and the path between their ends. Then the first
  /// part of what the two tethers share, from the base on, lies in the ground between them and leaves it across the
  /// path. Exact. O(n^2) for n points.
  static bool CrossesOnTheWay(const Polyline& start, const Polyline& path, const Polyline& end);

 private:
  struct Swept;
  /// A motion, and whether it is other than the shortest path of its class.
  struct Candidate {
    Motion motion;
    bool around_base = false;
  };

  std::optional<Candidate> Examine(const Polyline& path) const;
  Candidate AroundBase(const Motion& motion, const Swept& swept) const;
  void Offer(std::optional<Candidate> candidate);
  bool SearchClasses();
  Polyline OutAlong(const Polyline& tether) const;
  void Report(bool optimal);

  const TetherPlanner& planner_;
  const LaidCable& laid_;
  Place goal_;
  const PlanOptions& options_;
  PlanResult& result_;
  std::optional<Candidate> best_;
  double bound_ = 0;
  std::int64_t examined_ = 0;
};

/// The length of the way back along one tether and out along the other, metres.
double RetreatLength(const TautPath& start, const TautPath& end);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_CROSSING_FREE_H_
