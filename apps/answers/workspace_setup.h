// What all questions about the workspace of cables start from.
#ifndef APPS_ANSWERS_WORKSPACE_SETUP_H_
#define APPS_ANSWERS_WORKSPACE_SETUP_H_

#include <optional>
#include <string>
#include <vector>

#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/region_path.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene's world and winches, prepared.
struct WorkspaceSetup {
  CableGround ground;
  Anchors anchors;
};

/// Errors: the scene has no cables, an anchor cannot be one, and those of CableGround::Prepare.
[[nodiscard]] Expected<WorkspaceSetup> SetUpWorkspace(const Scene& scene, const Watcher& watch = {});

/// The boundary of the cables as the scene lays them, or what is wrong with it. Errors: they are not laid, or a word
/// names no obstacle.
[[nodiscard]] Expected<tl::expected<WorkspaceBoundary, BoundaryFault>> LayCables(const Scene& scene,
                                                                                 const WorkspaceSetup& setup);

/// `boundary`, `area`, `length`, `words`, `sides`, `touches`, `max_cable_lengths` and `max_cable_at`.
Json BoundaryJson(const WorkspaceSetup& setup, const WorkspaceBoundary& boundary, std::span<const LongestCable> longest,
                  const JsonValues& values);

/// Adds `reason`, `explanation`, and, where they are known, `at_fault` and `at`.
void AddFault(const WorkspaceSetup& setup, const BoundaryFault& fault, const JsonValues& values, Json& json);

/// How a question asks for a place of the robot.
struct RobotPlace {
  const char* what = "the start";                     ///< For errors of CheckGoal.
  const char* hint = "give its start as --from X,Y";  ///< How to say where it is.
};

/// Where the robot is: as given, or where the cables are laid. Errors: neither is known; CheckGoal refuses it.
[[nodiscard]] Expected<Point> RobotInWorkspace(const Scene& scene, const std::optional<Point>& given,
                                               const RobotPlace& place = {});

/// Adds `reason`, `explanation` and, where tasks are outside, `tasks`.
void AddOutside(const OutsideFault& fault, Json& json);

/// Every fault of the sides as taut curves, and of their product.
std::vector<std::string> BoundaryFaults(const CableGround& ground, const WorkspaceBoundary& boundary);
inline std::vector<std::string> BoundaryFaults(const WorkspaceSetup& setup, const WorkspaceBoundary& boundary) {
  return BoundaryFaults(setup.ground, boundary);
}

}  // namespace tautline

#endif  // APPS_ANSWERS_WORKSPACE_SETUP_H_
