// The shortest tethered motion by Dijkstra over (vertex, word): a slow oracle, for tests only.
#ifndef TAUTLINE_PLANNERS_TETHER_PLAN_ORACLE_H_
#define TAUTLINE_PLANNERS_TETHER_PLAN_ORACLE_H_

#include <optional>
#include <vector>

#include "tautline/homotopy/class_oracle.h"

namespace tautline {

struct OracleQuery {
  Polyline laid;  ///< Base first, robot last; base, robot and goal are points of the oracle.
  Point goal;
  double limit = 0;  ///< The tether's length, metres.
  /// Where the cable starts and ends; empty: in any sector of the point.
  std::vector<std::size_t> base_nodes, robot_nodes;
};

/// What the oracle found; lengths are infinite where there is no motion.
struct OracleMotion {
  bool too_many_states = false;
  double laid_length = 0;      ///< Of the laid cable pulled taut; infinite when that is longer than the limit.
  double shortest_tether = 0;  ///< Of all tethers within the limit that reach the goal.
  double checked = 0;          ///< The shortest motion whose tether fits at every vertex on the way.
  double unchecked = 0;        ///< The shortest motion whose tether fits at the goal.
  double unlimited = 0;        ///< The shortest motion with a tether of any length.
};

OracleMotion OraclePlan(ClassOracle& oracle, const OracleQuery& query);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_PLAN_ORACLE_H_
