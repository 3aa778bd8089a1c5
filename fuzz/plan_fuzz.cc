// Plans on small lattice scenes: nothing throws, every answer verifies, and the mirror image has the same answer.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/byte_source.h"
#include "fuzz/check_answer.h"
#include "fuzz/lattice_world.h"
#include "tautline/base/check.h"
#include "tautline/planners/tether/tether_planner.h"
#include "tautline/planners/tether/verify_plan.h"

namespace tautline::fuzz {
namespace {

/// Upside down: circles are symmetric that way, too.
void Mirror(Point& p) { p.y = -p.y; }

void Mirror(std::vector<Point>& points) {
  for (Point& p : points) Mirror(p);
}

Scene Mirrored(Scene scene) {
  Mirror(scene.world.outline);
  for (Obstacle& obstacle : scene.world.obstacles) {
    if (obstacle.circle) Mirror(obstacle.circle->centre);
    if (!obstacle.polygon) continue;
    Mirror(obstacle.polygon->outer);
    for (Ring& hole : obstacle.polygon->holes) Mirror(hole);
  }
  Mirror(scene.tether->base);
  if (scene.tether->laid) Mirror(*scene.tether->laid);
  Mirror(*scene.goal);
  return scene;
}

Tether AnyTether(Lattice& lattice) {
  Tether tether;
  tether.base = lattice.HalfNode();
  const int corners = lattice.bytes().Int(0, 5);
  double laid_length = 0;
  if (corners > 0) {
    tether.laid = Polyline{tether.base};
    for (int i = 1; i < corners; ++i) tether.laid->push_back(lattice.HalfNode());
    laid_length = Length(*tether.laid);
  }
  const double more = lattice.bytes().Byte() / 4.0;
  tether.length = lattice.bytes().Int(0, 3) == 0 ? laid_length : laid_length + lattice.spacing() * more;
  return tether;
}

Scene AnyScene(ByteSource& bytes, Lattice& lattice) {
  Scene scene;
  scene.tether = AnyTether(lattice);
  scene.goal = lattice.HalfNode();
  scene.world = AnyWorld(lattice);
  scene.world.clearance = lattice.spacing() * bytes.Pick({0.0, 0.0, 0.5, 0.25, 0.01, 1.0});
  return scene;
}

struct Answer {
  bool is_world = false;
  bool has_socket = false;  ///< The base lies in the clearance.
  PlanResult result;
};

/// The verified answer. Throws std::logic_error with the first fault.
Answer Ask(const Scene& scene, const PlanOptions& options) {
  const auto planner = TetherPlanner::Prepare(scene.world);
  CheckAnswer(planner);
  if (!planner) return {};
  const PlanResult result = planner->Plan(*scene.tether, *scene.goal, options);
  TAUTLINE_CHECK(result.motion.has_value() == (result.status == PlanStatus::kSolved));
  TAUTLINE_CHECK(result.status == PlanStatus::kSolved || !result.explanation.empty());
  const Verification verification = VerifyPlan(*planner, *scene.tether, *scene.goal, result, {.samples = 8});
  if (!verification.ok()) throw std::logic_error("not verified: " + verification.faults[0]);
  return {true, !planner->space().Locate(scene.tether->base), result};
}

/// Equal to rounding. A search that ran out of budget may have done so on one side only, and a base in the clearance is
/// led out by the nearest way, of which there may be two.
void CheckSame(const Answer& one, const Answer& other) {
  TAUTLINE_CHECK(one.is_world == other.is_world);
  TAUTLINE_CHECK(one.has_socket == other.has_socket);
  if (one.has_socket) return;
  if (one.result.status == PlanStatus::kBudgetExceeded || other.result.status == PlanStatus::kBudgetExceeded) return;
  TAUTLINE_CHECK(one.result.status == other.result.status);
  TAUTLINE_CHECK(one.result.obstruction == other.result.obstruction);
  if (!one.result.motion) return;
  const double a = one.result.motion->path.length, b = other.result.motion->path.length;
  TAUTLINE_CHECK(std::fabs(a - b) <= 1e-6 * std::max(a, b));
}

void Run(ByteSource bytes) {
  const double spacing = bytes.Pick({1.0, 1.0, 0.125, 1e-3, 1e3, 1e5});
  const bool far = spacing <= 1e3 && bytes.Int(0, 3) == 0;
  Lattice lattice(bytes, spacing, far ? Point{9e6, -8e6} : Point{0, 0});
  const Scene scene = AnyScene(bytes, lattice);
  const PlanOptions options{.all = bytes.Int(0, 3) == 0, .max_all = 10, .budget = 5000};
  const Answer answer = Ask(scene, options);
  CheckSame(answer, Ask(Mirrored(scene), options));
}

}  // namespace
}  // namespace tautline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tautline::fuzz::Run(tautline::fuzz::ByteSource({data, size}));
  return 0;
}
