// The search for a motion on which cable, robot and obstacles touch as little as possible, over poses and cables.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_FREE_SEARCH_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_FREE_SEARCH_H_

#include <cstdint>
#include <limits>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/homotopy/rays.h"
#include "tautline/planners/contact_free/driven_motion.h"
#include "tautline/planners/contact_free/goal_guide.h"

namespace tautline {

/// How finely a search looks: which states it takes for one, what it tries from each, and how many it follows.
struct SearchGrain {
  double cell_m = 0.4;      ///< Side of the cells for the robot's centre.
  int headings = 24;        ///< Sectors of its heading.
  double shape_m = 0.5;     ///< Side of the cells for the cable's nodes.
  int shape_nodes = 3;      ///< So many nodes before the tail count, besides the class of the whole cable.
  int primitive_steps = 6;  ///< Steps of the environment in a motion primitive.
  int width = 300;          ///< States that are followed from each layer, and a quarter more that are near the goal.
  int crowd = 6;            ///< Of these, so many at most in one place and class;
  double crowd_m = 0.5;     ///< the side of such a place,
  int crowd_headings = 8;   ///< and into how many its headings are divided.
  int layers = 120;         ///< Primitives in a motion at most.
  int patience = 12;        ///< Layers after that of the first motion without contacts.
  double slack = 0.6;       ///< Motions that cost so much more than the best are of interest, too.
  double risk = 0.1;        ///< What a node of the cable at an obstacle counts when states are ranked, as a cost;
  double risk_m = 0.4;      ///< nothing at this distance.
};

/// What a motion costs a search.
struct SearchCosts {
  double per_metre = 0.2;       ///< For driving, besides what the environment takes.
  double cable_margin_m = 0.1;  ///< Nodes of the cable nearer than this to the robot's disc count as touching.
};

/// How a search ended.
enum class SearchEnd : std::uint8_t {
  kFound,      ///< A motion to the goal.
  kExhausted,  ///< Nothing is left to follow. A proof only where no state was given up.
  kBudget,     ///< The layers or the budget are used up, or the caller said stop.
};

/// What a search found.
struct SearchOutcome {
  SearchEnd end = SearchEnd::kExhausted;  ///< How it ended.
  /// The best motions that differ in their class or in how they begin, the best of all first, of one velocity a step
  /// each. Empty unless found.
  std::vector<std::vector<Velocity>> motions;
  double cost = 0;              ///< Of the first motion, as the search counts.
  std::int64_t expansions = 0;  ///< States expanded.
};

/// What a search needs to know.
struct SearchProblem {
  const TetherEnv* env = nullptr;  ///< In the state to set out from; what counts as touching is what its map says.
  GoalGuide* guide = nullptr;      ///< To the goal of the environment's task.
  const Rays* rays = nullptr;      ///< For the class of the cable.
  SearchCosts costs;               ///< Besides the environment's penalties.
  std::int64_t budget = std::numeric_limits<std::int64_t>::max();  ///< States that are expanded at most.
  KeepGoing keep_going = {};                                       ///< Asked now and then.
};

/// Search in layers over (pose, cable) with motion primitives: straight on, arcs, turns on the spot, each of several
/// steps of the environment, cut where the goal is reached. Two states are one when the robot's cell and heading, the
/// class of its way, and the cells of the last nodes of the cable agree; the dearer one is given up. From each layer
/// the states with the least cost so far, distance left and risk are followed, spread over the plane: what a bend costs
/// shows only when the cable has been dragged around it, and by then a best-first search would have turned over all
/// that lies before the bend. A motion never pulls the cable through an obstacle: one that touched obstacles must still
/// have the class of the robot's way. With room for all states and cells that tell all apart, it is exhaustive.
/// Deterministic. O(layers * width * primitives * steps).
SearchOutcome SearchMotion(const SearchProblem& problem, const SearchGrain& grain);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_CONTACT_FREE_SEARCH_H_
