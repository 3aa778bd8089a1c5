// A layout for a fleet that only has targets: the one that takes the least time to make.
#ifndef TAUTLINE_PLANNERS_FLEET_CHOOSE_LAYOUT_H_
#define TAUTLINE_PLANNERS_FLEET_CHOOSE_LAYOUT_H_

#include <cstdint>
#include <string>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// How the choice of a layout ended.
enum class ChooseStatus {
  kSolved,          ///< A layout was found; see ChosenLayout::optimal.
  kInfeasible,      ///< No order of passing makes a layout: proved.
  kBudgetExceeded,  ///< None was found.
};

/// A layout that robots on their shortest paths make when they all drive at once.
struct ChosenLayout {
  ChooseStatus status = ChooseStatus::kBudgetExceeded;  ///< How the search ended.
  FleetLayout layout;                                   ///< If solved.
  double travel_time = 0;     ///< Until the last robot arrives, if solved; what the planner of the motion finds, s.
  double length = 0;          ///< Of all cables, if solved, metres.
  bool optimal = false;       ///< Whether no layout takes less time, nor as much time with less cable.
  std::int64_t played = 0;    ///< How many orders of passing were played.
  std::size_t crossings = 0;  ///< Where two shortest paths cross.
  std::string explanation;    ///< Unless solved: one sentence.
};

/// How long the search is.
struct ChooseOptions {
  std::int64_t budget = 20'000;  ///< At most this many orders of passing are played, and listed.
  Watcher watch;                 ///< Told how far the search has come; at a no, the best so far is the answer.
};

/// Of the layouts that come out when all robots drive at once along their shortest paths and wait for each other as
/// little as the orders allow, the one with the least travel time, then the least total length of the cables. Each has
/// passed CheckLayout, has no near miss (FindNearMiss) that PlanFleet would refuse, and no cable is longer than its
/// tether at any time on the way.
///
/// Which layouts these are is decided by who passes first where two paths cross, and by nothing else: so the search is
/// one over orders of passing, each of which is played. Where the orders that are not later than the best one fit into
/// the budget all of them are played, and the answer is optimal. Otherwise orders are turned round one by one, and two
/// by two, as long as that helps. Where a robot has several shortest paths one of them is taken.
///
/// Cost: as PathOrders, and as Play and CheckLayout for each order played.
ChosenLayout ChooseLayout(const FleetGround& ground, const ChooseOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_CHOOSE_LAYOUT_H_
