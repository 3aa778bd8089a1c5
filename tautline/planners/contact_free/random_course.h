// Random maps with a robot on a tether in them: what the policy for all maps is taught on, and tested on.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_COURSE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_COURSE_H_

#include "tautline/base/rng.h"
#include "tautline/planners/contact_free/tether_env.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene in the style of dots, two bars or rooms, by chance, 12 to 15 m wide for a robot of 0.5 m: rectangles that
/// leave passages of at least 1.6 m, the base and the goal where the robot has room, some way apart, and a cable that
/// is long enough for most ways. The robot stands at its base.
Scene RandomCourse(Rng& rng);

/// The scene in which the robot stands where the environment has it, with the cable as it lies.
Scene SceneAfter(const Scene& scene, const TetherEnv& driven);

/// The same course with the cable as a motion left it, and another goal: scenario 2 of [Shimada2024, Sec. 6.2].
Scene NextCourse(const Scene& course, const TetherEnv& driven, Rng& rng);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_RANDOM_COURSE_H_
