#include "tautline/planners/contact_free/imitation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/network/adam.h"
#include "tautline/network/loss.h"
#include "tautline/planners/contact_free/random_course.h"
#include "tautline/planners/contact_free/reference_path.h"
#include "tautline/planners/contact_free/select_reference.h"

namespace tautline {
namespace {

/// The side of a cell of a map, of the robot's radius; gradients are clipped to this norm.
constexpr double kCellOfRadius = 0.2, kClip = 10;

std::optional<DrivenMotion> SearchOn(const Scene& scene, const CollectOptions& options) {
  ContactFreeOptions search;
  search.env = options.env;
  search.env.max_steps = 5000;
  search.last_search = options.last_search;
  auto plan = PlanContactFree(scene, search);
  if (!plan || plan->status != ContactFreeStatus::kSolved) return std::nullopt;
  return std::move(plan->motion);
}

/// The environment after a motion.
TetherEnv After(TetherEnv env, std::span<const Velocity> motion) {
  for (const Velocity& velocity : motion) {
    if (env.StepWith(velocity.speed_m_per_s, velocity.turn_rad_per_s).ends()) break;
  }
  return env;
}

/// Drives the motion and notes views and choices. The reference is that of the motion itself, pulled tight, so that
/// what is ahead of the robot is what the search went for.
void Note(const Scene& scene, const DrivenMotion& motion, const CollectOptions& options, Demonstrations& notes) {
  const auto ground = PrepareRobotGround(scene.world, options.env.robot_radius_m);
  if (!ground) return;
  const Shortened taut = Shorten(ground->space(), motion.Path());
  auto course = MakeCourse(scene, options.env);
  if (!course) return;
  TetherTask task = course->env.task();
  if (!taut.departure) task.waypoints = Waypoints(taut.path.points, options.env.robot_radius_m);
  auto created = TetherEnv::Create(*course->map, task, course->env.options());
  if (!created) return;
  TetherEnv env = *std::move(created);
  std::size_t waypoint = 0;
  Polyline way;
  for (const RobotPose& pose : motion.poses) way.push_back(pose.at);
  for (std::size_t k = 0; k < motion.velocities.size(); ++k) {
    waypoint = AdvanceAlong(env, waypoint);
    const DriverView view = LookAround(env, waypoint);
    const DriverIntent intent = IntentOf(env.pose(), std::span(way).subspan(k), env.options().robot_radius_m);
    notes.views.insert(notes.views.end(), view.begin(), view.end());
    notes.intents.insert(notes.intents.end(), intent.begin(), intent.end());
    if (env.StepWith(motion.velocities[k].speed_m_per_s, motion.velocities[k].turn_rad_per_s).ends()) break;
  }
}

/// Puts a demonstration, or its mirror image, at the end of a batch.
void AddSample(const Demonstrations& from, std::size_t which, Rng& rng, std::vector<float>& views,
               std::vector<float>& intents) {
  DriverView view;
  DriverIntent intent;
  std::copy_n(from.views.begin() + static_cast<std::ptrdiff_t>(which * kViewSize), kViewSize, view.begin());
  std::copy_n(from.intents.begin() + static_cast<std::ptrdiff_t>(which * kIntentSize), kIntentSize, intent.begin());
  if (rng.Next() % 2 == 1) {
    view = Mirrored(view);
    intent = Mirrored(intent);
  }
  views.insert(views.end(), view.begin(), view.end());
  intents.insert(intents.end(), intent.begin(), intent.end());
}

}  // namespace

void Demonstrations::Append(const Demonstrations& others) {
  views.insert(views.end(), others.views.begin(), others.views.end());
  intents.insert(intents.end(), others.intents.begin(), others.intents.end());
}

std::optional<Course> MakeCourse(const Scene& scene, const TetherEnvOptions& options) {
  const TetherEnvOptions with = OptionsFor(scene, options);
  auto task = TaskOf(scene);
  const auto free = BuildFreeSpace(scene.world);
  const auto ground = PrepareRobotGround(scene.world, with.robot_radius_m);
  if (!task || !free || !ground) return std::nullopt;
  const ReferenceSelection selection = SelectReference(
      *ground, {.laid = task->laid, .cable_length_m = task->cable_length_m, .goal = task->goal}, {.budget = 200'000});
  if (!selection.reference) return std::nullopt;
  task->waypoints = Waypoints(selection.reference->path, with.robot_radius_m);
  auto map = std::make_shared<const ContactMap>(*free, kCellOfRadius * with.robot_radius_m);
  auto env = TetherEnv::Create(*map, *task, with);
  if (!env) return std::nullopt;
  return Course{scene, std::move(map), *std::move(env)};
}

std::optional<Course> CourseOf(std::uint64_t seed, const TetherEnvOptions& options) {
  Rng rng(seed);
  const Scene scene = RandomCourse(rng);
  auto course = MakeCourse(scene, options);
  if (!course || seed % 2 == 0) return course;
  const auto motion = SearchOn(scene, {.env = options});
  if (!motion) return course;
  return MakeCourse(NextCourse(scene, After(course->env, motion->velocities), rng), options);
}

Demonstrations CollectDemonstrations(std::uint64_t seed, const CollectOptions& options) {
  Demonstrations notes;
  const auto course = CourseOf(seed, options.env);
  if (!course) return notes;
  if (options.policy == nullptr) {
    if (const auto motion = SearchOn(course->scene, options)) Note(course->scene, *motion, options, notes);
    return notes;
  }
  DriverPolicy policy = *options.policy;
  const std::vector<Velocity> driven = policy.Drive(course->env).velocities;
  Rng rng(seed + 1);
  for (int k = 0; k < options.recoveries && !driven.empty(); ++k) {
    const auto steps = static_cast<std::size_t>(rng.Uniform() * static_cast<double>(driven.size()));
    const Scene now = SceneAfter(course->scene, After(course->env, std::span(driven).first(steps)));
    if (const auto motion = SearchOn(now, options)) Note(now, *motion, options, notes);
  }
  return notes;
}

DriverView Mirrored(const DriverView& view) {
  DriverView mirrored = view;
  for (std::size_t part = 0; part < 2; ++part) {
    const auto from = view.begin() + static_cast<std::ptrdiff_t>(part * kViewRays);
    const auto to = mirrored.begin() + static_cast<std::ptrdiff_t>(part * kViewRays);
    std::reverse_copy(from + 1, from + kViewRays, to + 1);
  }
  std::size_t at = std::size_t{2} * kViewRays;
  for (int node = 0; node < kViewNodes; ++node, at += 3) mirrored[at + 1] = -view[at + 1];
  for (int ahead = 0; ahead < kViewAhead; ++ahead, at += 2) mirrored[at + 1] = -view[at + 1];
  return mirrored;
}

DriverIntent Mirrored(const DriverIntent& intent) { return {intent[0], -intent[1], intent[2], -intent[3]}; }

Mlp Imitate(const Demonstrations& demonstrations, const ImitationOptions& options, const Kernels& kernels) {
  TAUTLINE_CHECK(demonstrations.size() > 0 && options.batch > 0);
  Rng rng(options.seed);
  std::vector<int> widths = {kViewSize};
  widths.insert(widths.end(), options.hidden.begin(), options.hidden.end());
  widths.push_back(kIntentSize);
  Mlp network = Mlp::Random(widths, rng);
  MlpPass pass(widths, options.batch, kernels);
  std::vector<std::size_t> order(demonstrations.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  AdamState state;
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    const double done = static_cast<double>(epoch) / options.epochs;
    Adam adam(network.parameters().size(), {.learning_rate = options.learning_rate * std::pow(0.1, done)}, kernels);
    if (epoch > 0) adam.set_state(state);
    for (std::size_t i = order.size(); i-- > 1;) std::swap(order[i], order[rng.Next() % (i + 1)]);
    double loss = 0;
    for (std::size_t first = 0; first < order.size(); first += static_cast<std::size_t>(options.batch)) {
      const std::size_t count = std::min(order.size() - first, static_cast<std::size_t>(options.batch));
      std::vector<float> views, intents;
      for (std::size_t k = 0; k < count; ++k) AddSample(demonstrations, order[first + k], rng, views, intents);
      std::vector<float> slopes(count * kIntentSize);
      loss += static_cast<double>(count) * MeanSquareLoss(pass.Forward(network, views), intents, slopes);
      const std::span<const float> gradient = pass.Backward(network, slopes);
      adam.Step(network.parameters(), gradient, ClipScale(kernels.square_sum(gradient.data(), gradient.size()), kClip));
    }
    state = adam.state();
    if (options.progress && !options.progress(epoch + 1, loss / static_cast<double>(order.size()))) break;
  }
  return network;
}

}  // namespace tautline
