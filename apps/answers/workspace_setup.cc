#include "apps/answers/workspace_setup.h"

#include <utility>

#include "tautline/homotopy/curve_faults.h"
#include "tautline/homotopy/ring_ground.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"
#include "tautline/scene/check_cables.h"
#include "tautline/scene/check_tether.h"

namespace tautline {

Expected<WorkspaceSetup> SetUpWorkspace(const Scene& scene, const Watcher& watch) {
  if (const auto checked = RequireCables(scene); !checked) return tl::unexpected(checked.error());
  auto ground = CableGround::Prepare(scene.world, watch);
  if (!ground) return tl::unexpected(ground.error());
  auto anchors = PlaceAnchors(*ground, scene.cables->anchors);
  if (!anchors) {
    const AnchorFault& fault = anchors.error();
    return InvalidInput("cables.anchors[" + std::to_string(fault.anchor + 1) + "] at " + fault.text, scene.path);
  }
  return WorkspaceSetup{std::move(*ground), std::move(*anchors)};
}

Expected<tl::expected<WorkspaceBoundary, BoundaryFault>> LayCables(const Scene& scene, const WorkspaceSetup& setup) {
  if (const auto checked = RequireLaidCables(scene); !checked) return tl::unexpected(checked.error());
  const Cables& cables = *scene.cables;
  if (cables.laid) return BoundaryOfCables(setup.ground, setup.anchors, *cables.laid);
  std::vector<Word> words;
  for (std::size_t i = 0; i < cables.words->size(); ++i) {
    auto word = ParseWord((*cables.words)[i], setup.ground.space().rays().names());
    if (!word) {
      return InvalidInput("cables.words[" + std::to_string(i + 1) + "]: " + word.error().message, scene.path);
    }
    words.push_back(*std::move(word));
  }
  return BoundaryOfWords(setup.ground, setup.anchors, words);
}

Json BoundaryJson(const WorkspaceSetup& setup, const WorkspaceBoundary& boundary, std::span<const LongestCable> longest,
                  const JsonValues& values) {
  Json json;
  json["boundary"] = values.Of(boundary.ring);
  json["area"] = boundary.area;
  json["length"] = boundary.length;
  json["words"] = Json::array();
  for (const BoundarySide& side : boundary.sides) json["words"].push_back(values.Of(side.path.word));
  json["sides"] = Json::array();
  for (const BoundarySide& side : boundary.sides) json["sides"].push_back(values.Of(side.path, "path"));
  json["touches"] = Json::array();
  for (const ObstacleId id : TouchedIslands(setup.ground, boundary)) {
    json["touches"].push_back(setup.ground.space().free_space().name(id));
  }
  json["max_cable_lengths"] = Json::array();
  json["max_cable_at"] = Json::array();
  for (const LongestCable& cable : longest) {
    json["max_cable_lengths"].push_back(cable.length);
    json["max_cable_at"].push_back(values.Of(setup.anchors[cable.farthest].exit.point));
  }
  return json;
}

void AddFault(const WorkspaceSetup& setup, const BoundaryFault& fault, const JsonValues& values, Json& json) {
  json["reason"] = ToString(fault.obstruction);
  json["explanation"] = fault.explanation;
  for (const std::size_t side : fault.sides) {
    const bool is_side = fault.obstruction != WorkspaceObstruction::kLaidCableBlocked &&
                         fault.obstruction != WorkspaceObstruction::kRobotBlocked;
    Json at_fault = {{"anchor", side}, {"from", values.Of(setup.anchors[side].base)}};
    if (is_side) at_fault["to"] = values.Of(setup.anchors[NextAnchor(side, setup.anchors.size())].base);
    json["at_fault"].push_back(std::move(at_fault));
  }
  if (fault.at) json["at"] = values.Of(*fault.at);
}

Expected<Point> RobotInWorkspace(const Scene& scene, const std::optional<Point>& given, const RobotPlace& place) {
  if (!given && !scene.cables->laid) {
    return InvalidInput(std::string("words do not say where the robot is; ") + place.hint, scene.path);
  }
  const Point robot = given ? *given : scene.cables->laid->front().front();
  if (const auto checked = CheckGoal(robot, place.what); !checked) return tl::unexpected(checked.error());
  return robot;
}

void AddOutside(const OutsideFault& fault, Json& json) {
  json["reason"] = ToString(fault.obstruction);
  json["explanation"] = fault.explanation;
  if (!fault.tasks.empty()) json["tasks"] = fault.tasks;
}

std::vector<std::string> BoundaryFaults(const CableGround& ground, const WorkspaceBoundary& boundary) {
  std::vector<std::string> faults;
  const FreeSpace& space = ground.space().free_space();
  Word product;
  for (std::size_t i = 0; i < boundary.sides.size(); ++i) {
    for (const std::string& fault : CurveFaults(space, boundary.sides[i].path)) {
      faults.push_back(SideName(i, boundary.sides.size()) + " " + fault);
    }
    product.Append(RingGround(space).WordOf(boundary.sides[i].path.points));
  }
  if (!product.empty()) faults.emplace_back("the words of the sides do not multiply to the empty word");
  for (const Island& island : space.islands) {
    if (WindingNumber(boundary.ring, island.representative).number != 0) {
      faults.push_back("the obstacle " + island.name + " is inside of the boundary");
    }
  }
  return faults;
}

}  // namespace tautline
