// Contact-free motions on small lattice scenes: nothing throws, what is found can be driven again to the same costs,
// and the reference path's tether fits.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "fuzz/byte_source.h"
#include "fuzz/check_answer.h"
#include "fuzz/lattice_world.h"
#include "tautline/base/check.h"
#include "tautline/planners/contact_free/imitation.h"
#include "tautline/planners/contact_free/plan_contact_free.h"
#include "tautline/planners/contact_free/track_path.h"

namespace tautline::fuzz {
namespace {

Scene AnyScene(ByteSource& bytes) {
  const double spacings[] = {1, 0.7, 0.25, 3};
  const Point origins[] = {{0, 0}, {-7, 3}, {1e5, -1e5}};
  Lattice lattice(bytes, bytes.Pick(spacings), bytes.Pick(origins));
  Scene scene;
  scene.tether = Tether{lattice.HalfNode(), lattice.spacing() * 0.5 * bytes.Int(0, 90), std::nullopt};
  scene.goal = lattice.HalfNode();
  if (bytes.Int(0, 1) == 1) {
    Polyline laid{scene.tether->base};
    for (int bends = bytes.Int(0, 4); bends > 0; --bends) laid.push_back(lattice.HalfNode());
    scene.tether->laid = laid;
  }
  if (bytes.Int(0, 2) == 2) scene.robot.heading = 0.1 * bytes.Int(0, 63);
  scene.robot.radius = lattice.spacing() * 0.1 * bytes.Int(1, 12);
  scene.world = AnyWorld(lattice);
  return scene;
}

void CheckPlan(const Scene& scene) {
  ContactFreeOptions options{.last_search = 300, .budget = 600};
  options.env.speed_m_per_s = 2 * *scene.robot.radius;
  options.env.goal_radius_m = *scene.robot.radius;
  const auto plan = PlanContactFree(scene, options);
  CheckAnswer(plan);
  if (!plan) return;
  if (plan->status != ContactFreeStatus::kSolved) {
    TAUTLINE_CHECK(!plan->reason.empty() && !plan->explanation.empty());
    return;
  }
  TAUTLINE_CHECK(plan->motion.at_goal && plan->bound <= plan->cost * (1 + 1e-9));
  const auto space = BuildFreeSpace(scene.world);
  TAUTLINE_CHECK(space.has_value());
  const ContactMap map(*space, 0.1);
  auto task = TaskOf(scene);
  TAUTLINE_CHECK(task.has_value());
  task->heading_rad = plan->motion.poses.front().heading_rad;
  const auto env = TetherEnv::Create(map, *task, plan->env);
  TAUTLINE_CHECK(env.has_value());
  const DrivenMotion again = DriveMotion(*env, plan->motion.velocities);
  TAUTLINE_CHECK(again.at_goal && again.costs.cable_obstacle_steps == plan->motion.costs.cable_obstacle_steps);
  TAUTLINE_CHECK(again.costs.cable_robot_steps == plan->motion.costs.cable_robot_steps);
}

void CheckCourse(const Scene& scene) {
  const auto course = MakeCourse(scene, {.max_steps = 200});
  if (!course) return;
  const Mlp nothing({kViewSize, 4, kIntentSize});
  const DrivenMotion motion = DriverPolicy(nothing, PortableKernels()).Drive(course->env);
  TAUTLINE_CHECK(!motion.outcomes.empty());
  Polyline path{course->env.pose().at};
  const Polyline& waypoints = course->env.task().waypoints;
  path.insert(path.end(), waypoints.begin(), waypoints.end());
  static_cast<void>(TrackPath(course->env, path));
}

}  // namespace
}  // namespace tautline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tautline::fuzz::ByteSource bytes({data, size});
  const tautline::Scene scene = tautline::fuzz::AnyScene(bytes);
  tautline::fuzz::CheckPlan(scene);
  tautline::fuzz::CheckCourse(scene);
  return 0;
}
