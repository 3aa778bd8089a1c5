#include "tautline/scene/check_cables.h"

#include <string>

#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/scene_fault.h"

namespace tautline {
namespace {

std::string Nth(const std::string& what, std::size_t i) { return what + "[" + std::to_string(i + 1) + "]"; }

Expected<void> CheckLaid(const std::vector<Polyline>& laid, const std::vector<Point>& anchors, double tolerance) {
  for (std::size_t i = 0; i < laid.size(); ++i) {
    const std::string what = Nth("cables.laid", i);
    if (laid[i].size() < 2) {
      return InvalidInput(what + " has " + std::to_string(laid[i].size()) + " points: it needs 2 or more");
    }
    if (auto points = Checked(what, PointsFault(laid[i])); !points) return points;
    if (Distance(laid[i].front(), laid[0].front()) > tolerance) {
      return InvalidInput(what + " must start at the robot, at " + ToText(laid[0].front()) + ", not at " +
                          ToText(laid[i].front()));
    }
    if (Distance(laid[i].back(), anchors[i]) > tolerance) {
      return InvalidInput(what + " must end at its anchor, at " + ToText(anchors[i]) + ", not at " +
                          ToText(laid[i].back()));
    }
  }
  return {};
}

}  // namespace

Expected<void> CheckCables(const Cables& cables, const Box& world) {
  const std::size_t n = cables.anchors.size();
  if (n < 3) return InvalidInput("cables.anchors has " + std::to_string(n) + " points: it needs 3 or more");
  if (auto anchors = Checked("cables.anchors", PointsFault(cables.anchors)); !anchors) return anchors;
  if (cables.laid && cables.words) return InvalidInput("cables has both laid and words: give one of them");
  if (cables.words && cables.words->size() != n) {
    return InvalidInput("cables.words has " + std::to_string(cables.words->size()) + " words for " + std::to_string(n) +
                        " anchors: it needs one per anchor, from it to the next");
  }
  if (!cables.laid) return {};
  if (cables.laid->size() != n) {
    return InvalidInput("cables.laid has " + std::to_string(cables.laid->size()) + " cables for " + std::to_string(n) +
                        " anchors: it needs one per anchor");
  }
  return CheckLaid(*cables.laid, cables.anchors, SamePointTolerance(world));
}

Expected<void> RequireCables(const Scene& scene) {
  if (!scene.cables) return InvalidInput("the scene has no cables; add `cables: {anchors: [[x, y], ...]}`", scene.path);
  return InScene(scene, CheckCables(*scene.cables, BoundingBox(scene.world.outline)));
}

Expected<void> RequireLaidCables(const Scene& scene) {
  if (auto cables = RequireCables(scene); !cables) return cables;
  if (scene.cables->laid || scene.cables->words) return {};
  return InvalidInput(
      "the cables are not laid; add `laid`, one list of points per anchor from the robot to it, or `words`, one per "
      "anchor (`tautline workspace best` finds the best ones)",
      scene.path);
}

}  // namespace tautline
