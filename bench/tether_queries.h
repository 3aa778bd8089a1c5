// Random questions to the tether planner.
#ifndef TAUTLINE_BENCH_TETHER_QUERIES_H_
#define TAUTLINE_BENCH_TETHER_QUERIES_H_

#include <vector>

#include "tautline/base/rng.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// One question: a laid cable, a tether's length, a goal.
struct TetherQuery {
  Tether tether;
  Point goal;
};

struct RandomQueryOptions {
  Point base;
  double length = 0;         ///< Of the tether, metres.
  std::size_t places = 30;   ///< So many random robots and as many random goals.
  std::size_t count = 1000;  ///< Questions.
};

/// Robots and goals at random free points; the cable to the robot lies taut in one of all the classes that the tether
/// allows, each equally likely. Points beyond the tether are not taken.
std::vector<TetherQuery> RandomTetherQueries(Rng& rng, const TautSpace& space, const RandomQueryOptions& options);

struct BindingQueryOptions {
  std::size_t places = 40;   ///< Base, robot, goal and one way-point of each question are drawn from so many points.
  std::size_t count = 1000;  ///< Questions; fewer when a thousand draws for each do not suffice.
};

/// Questions whose tether binds: after the shortest motion of all to the goal the taut tether would be longer than it
/// is, but there is a motion. The cable lies taut from the base to the robot in the class of the shortest way over a
/// third place, so it need not be the shortest. The tether's length is drawn between what the laid cable and the goal
/// need and what the shortest motion would need. Costs one shortest path for each pair of places.
std::vector<TetherQuery> BindingTetherQueries(Rng& rng, const TautSpace& space, const BindingQueryOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_TETHER_QUERIES_H_
