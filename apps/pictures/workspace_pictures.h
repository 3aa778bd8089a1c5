// The pictures of answers about workspaces, the same for every face.
#ifndef APPS_PICTURES_WORKSPACE_PICTURES_H_
#define APPS_PICTURES_WORKSPACE_PICTURES_H_

#include <string>

#include "apps/answers/best_answer.h"
#include "apps/answers/boundary_answer.h"
#include "apps/answers/move_answer.h"
#include "apps/answers/pose_answer.h"
#include "apps/answers/tour_answer.h"

namespace tautline {

/// The workspace, with futures side by side with what they make of it; or what is wrong with its boundary. As SVG, as
/// all of these.
std::string DrawAnswer(const Scene& scene, const BoundaryAnswer& answer);

/// The best workspaces side by side.
std::string DrawAnswer(const Scene& scene, const BestAnswer& answer);

/// The robot at its pose.
std::string DrawAnswer(const Scene& scene, const PoseAnswer& answer);

/// The motion, with lengths and rates over time.
std::string DrawAnswer(const Scene& scene, const MoveAnswer& answer);

/// The tour.
std::string DrawAnswer(const Scene& scene, const TourAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_WORKSPACE_PICTURES_H_
