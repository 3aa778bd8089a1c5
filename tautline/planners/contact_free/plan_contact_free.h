// A path to the goal on which cable, robot and obstacles touch as little as possible: the search on a scene.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_PLAN_CONTACT_FREE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_PLAN_CONTACT_FREE_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/contact_free/contact_free_search.h"
#include "tautline/planners/contact_free/driven_motion.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What is asked besides the scene.
struct ContactFreeOptions {
  /// The robot, the cable, what contacts cost. No noise; the scene's radius replaces this one.
  TetherEnvOptions env = {.max_steps = 5000};
  SearchCosts costs;                  ///< What else counts.
  double margin_m = 0.1;              ///< Kept from obstacles by robot and cable, as far as that goes.
  std::int64_t last_search = 60'000;  ///< No wider search begins after so many states; one that has begun goes on.
  std::int64_t budget = std::numeric_limits<std::int64_t>::max();  ///< States that are expanded at most.
  Watcher watch = {};  ///< Told how far the search has come; it can stop it.
};

/// How the planning ended.
enum class ContactFreeStatus : std::uint8_t { kSolved, kInfeasible, kBudgetExceeded };

/// The plan, or why there is none.
struct ContactFreeResult {
  ContactFreeStatus status = ContactFreeStatus::kInfeasible;  ///< kInfeasible is a proof.
  std::string reason;           ///< The slug of formats.md, "goal_blocked", ...; empty when solved.
  std::string explanation;      ///< One sentence with the numbers when there is no plan.
  TetherEnvOptions env;         ///< The environment that was planned in: the scene's radius, no goal reward.
  Polyline path;                ///< For the robot to track.
  DrivenMotion motion;          ///< As the environment drives it, contacts and costs included.
  double cost = 0;              ///< Of the motion: its penalty and what its length counts.
  double bound = 0;             ///< No motion to the goal costs less.
  double shortest_m = 0;        ///< No motion to the goal is shorter, metres.
  TautPath tether;              ///< The cable at the end pulled taut, base first.
  std::int64_t expansions = 0;  ///< States that were expanded.
  /// No motion has fewer contacts: there is none of either kind.
  bool contacts_proved() const { return motion.costs.cable_obstacle_steps == 0 && motion.costs.cable_robot_steps == 0; }
};

/// Plans on the scene's world, tether and goal. Infeasible: robot or goal have no room, no way leads to the goal, the
/// laid cable crosses an obstacle or is longer than all of it, or even the shortest tether to the goal is too long.
/// Searches grow wider until one finds a motion without contacts, or as the options end it; the motion with the fewest
/// contacts is the answer, those with the robot counting half, and of these the one that costs least. Errors: those of
/// RequireTetherAndGoal and BuildFreeSpace, or a number of the options makes no sense. Deterministic.
[[nodiscard]] Expected<ContactFreeResult> PlanContactFree(const Scene& scene, const ContactFreeOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_PLAN_CONTACT_FREE_H_
