#include "tautline/scene/check_tether.h"

#include <algorithm>
#include <string>

#include "tautline/scene/number_text.h"
#include "tautline/scene/scene_fault.h"

namespace tautline {
double SamePointTolerance(const Box& world) {
  constexpr double kShare = 1e-6;
  return kShare * (world.empty() ? 1 : std::max(world.size().x, world.size().y));
}

Expected<void> CheckTether(const Tether& tether, const Box& world) {
  if (auto base = Checked("tether.base", PointFault(tether.base)); !base) return base;
  if (auto length = Checked("tether.length", NonNegativeFault(tether.length)); !length) return length;
  if (!tether.laid) return {};
  if (tether.laid->empty()) return InvalidInput("tether.laid has 0 points: it needs 1 or more");
  if (auto laid = Checked("tether.laid", PointsFault(*tether.laid)); !laid) return laid;
  const Point first = tether.laid->front();
  if (Distance(first, tether.base) <= SamePointTolerance(world)) return {};
  return InvalidInput("tether.laid must start at the base, at " + ToText(tether.base) + ", not at " + ToText(first));
}

Expected<void> CheckGoal(Point goal, const char* what) { return Checked(what, PointFault(goal)); }

Expected<void> RequireTether(const Scene& scene) {
  if (!scene.tether) {
    return InvalidInput("the scene has no tether; add `tether: {base: [x, y], length: metres}`", scene.path);
  }
  return InScene(scene, CheckTether(*scene.tether, BoundingBox(scene.world.outline)));
}

Expected<void> RequireTetherAndGoal(const Scene& scene) {
  if (auto tether = RequireTether(scene); !tether) return tether;
  if (!scene.goal) return InvalidInput("the scene has no goal; add `goal: [x, y]`", scene.path);
  return InScene(scene, CheckGoal(*scene.goal));
}

}  // namespace tautline
