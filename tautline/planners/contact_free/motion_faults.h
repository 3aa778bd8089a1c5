// Whether a planned motion is what its plan says: it is driven again.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_MOTION_FAULTS_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_MOTION_FAULTS_H_

#include <string>
#include <vector>

#include "tautline/planners/contact_free/plan_contact_free.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What is wrong with a plan, one sentence each, found by driving its velocities in an environment made anew from the
/// scene: every step moves the robot and hits nothing, the last one reaches the goal, and contacts, penalty, length,
/// cost and bounds are those that the plan says. None for a plan without a motion. Requires the scene that was planned
/// on, and the options' costs. O(steps).
std::vector<std::string> MotionFaults(const Scene& scene, const ContactFreeResult& result, const SearchCosts& costs);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_MOTION_FAULTS_H_
