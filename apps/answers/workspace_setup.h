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
Json BoundaryJson(const WorkspaceSetup& setup, const WorkspaceBoundary& boundary, const JsonValues& values);

/// Adds `reason`, `explanation`, and, where they are known, `at_fault` and `at`.
void AddFault(const WorkspaceSetup& setup, const BoundaryFault& fault, const JsonValues& values, Json& json);

/// Where the robot starts: `from`, or where the cables are laid. Errors: neither is known; CheckGoal refuses it.
[[nodiscard]] Expected<Point> StartInWorkspace(const Scene& scene, const std::optional<Point>& from);

/// Adds `reason`, `explanation` and, where tasks are outside, `tasks`.
void AddOutside(const OutsideFault& fault, Json& json);

/// Every fault of the sides as taut curves, and of their product.
std::vector<std::string> BoundaryFaults(const CableGround& ground, const WorkspaceBoundary& boundary);
inline std::vector<std::string> BoundaryFaults(const WorkspaceSetup& setup, const WorkspaceBoundary& boundary) {
  return BoundaryFaults(setup.ground, boundary);
}

}  // namespace tautline

#endif  // APPS_ANSWERS_WORKSPACE_SETUP_H_
