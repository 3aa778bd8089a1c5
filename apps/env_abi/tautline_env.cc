#include "apps/env_abi/tautline_env.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "apps/answers/learn_options.h"
#include "apps/answers/learn_setup.h"
#include "tautline/scene/scene_file.h"

/// What a handle points to.
struct tautline_env {
  tautline::LearnSetup setup;
  std::optional<tautline::TetherEnv> env;
  bool running = false;  ///< Within an episode.
};

namespace tautline {
namespace {

/// The text of this thread's last error. A C interface has no other place for it.
thread_local std::string last_error;

/// Handles that are alive, so that a wrong one is refused without looking at it.
class Handles {
 public:
  static Handles& All() {
    static Handles handles;
    return handles;
  }
  void Add(const tautline_env* env) {
    const std::lock_guard lock(mutex_);
    alive_.insert(env);
  }
  bool Has(const tautline_env* env) {
    const std::lock_guard lock(mutex_);
    return alive_.count(env) != 0;
  }
  bool Remove(const tautline_env* env) {
    const std::lock_guard lock(mutex_);
    return alive_.erase(env) != 0;
  }

 private:
  std::mutex mutex_;
  std::set<const tautline_env*> alive_;
};

std::int32_t Fail(const std::string& what) {
  last_error = what;
  return -1;
}

/// Runs what may throw; -1 and the error where it does.
template <class Do>
auto Guarded(const Do& act) noexcept -> decltype(act()) {
  try {
    return act();
  } catch (const std::exception& fault) {
    try {
      last_error = fault.what();
    } catch (...) {
      last_error.clear();
    }
  }
  return static_cast<decltype(act())>(-1);
}

/// -1 and the error unless the handle is one.
bool Refused(const tautline_env* env) {
  if (env != nullptr && Handles::All().Has(env)) return false;
  last_error = "no such environment: it is null, was freed, or is none";
  return true;
}

struct GivenOptions {
  LearnOptions options;
  double robot_radius_m = 0;  ///< 0: not given.
  double link_length_m = 0;   ///< 0: not given.
};

template <class Value>
void Take(const nlohmann::json& from, Value& value) {
  if constexpr (std::is_same_v<Value, int>) {
    if (!from.is_number_integer()) throw std::invalid_argument("must be a whole number");
    // Larger ones would become others.
    constexpr double kMost = std::numeric_limits<int>::max();
    if (std::abs(from.get<double>()) > kMost) throw std::invalid_argument("must be a whole number up to 2147483647");
  } else {
    if (!from.is_number()) throw std::invalid_argument("must be a number");
  }
  from.get_to(value);
}

/// One key of the options. False where there is no such key.
bool TakeOption(const std::string& key, const nlohmann::json& value, GivenOptions& given) {
  TetherEnvOptions& env = given.options.env;
  if (key == "observation") {
    if (value != "metres" && value != "scaled") throw std::invalid_argument("must be \"scaled\" or \"metres\"");
    env.observation = value == "metres" ? ObservationScale::kMetres : ObservationScale::kScaled;
    return true;
  }
  if (key == "use_reference") {
    if (!value.is_boolean()) throw std::invalid_argument("must be true or false");
    env.reward.use_reference = value.get<bool>();
    return true;
  }
  bool known = false;
  VisitEnvOptions(env, [&](const std::string& name, auto& field, const char*) {
    if (name != key) return;
    known = true;
    if (name == "robot_radius") {
      Take(value, given.robot_radius_m);
    } else if (name == "link") {
      Take(value, given.link_length_m);
    } else {
      Take(value, field);
    }
  });
  return known;
}

Expected<GivenOptions> ReadOptions(const char* text) {
  GivenOptions given;
  if (text == nullptr) return given;
  const auto json = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return InvalidInput("must be a JSON object, such as {\"max_steps\": 300}", "options");
  for (const auto& [key, value] : json.items()) {
    try {
      if (!TakeOption(key, value, given)) return InvalidInput("there is no option '" + key + "'", "options");
    } catch (const std::exception& fault) {
      return InvalidInput(fault.what(), "options: " + key);
    }
  }
  if (given.robot_radius_m < 0 || given.link_length_m < 0) {
    return InvalidInput("robot_radius and link must be positive", "options");
  }
  return given;
}

Expected<std::unique_ptr<tautline_env>> Make(const char* scene_path, const char* options_json) {
  if (scene_path == nullptr) return InvalidInput("no scene file is named");
  auto given = ReadOptions(options_json);
  if (!given) return tl::unexpected(given.error());
  const auto scene = ReadSceneFile(scene_path, {});
  if (!scene) return tl::unexpected(scene.error());
  ResolveBody(*scene, given->robot_radius_m, given->link_length_m, given->options.env);
  auto setup = SetUpLearning(*scene, given->options.env);
  if (!setup) return tl::unexpected(setup.error());
  if (!setup->env) return InvalidInput(setup->selection.explanation, scene_path);
  auto made = std::make_unique<tautline_env>(tautline_env{*std::move(setup), std::nullopt, false});
  made->env = *made->setup.env;
  return made;
}

void Write(const Observation& from, float* to) {
  if (to != nullptr) std::copy(from.begin(), from.end(), to);
}

}  // namespace
}  // namespace tautline

using tautline::Fail;
using tautline::Guarded;
using tautline::Handles;
using tautline::Refused;

static_assert(TAUTLINE_ENV_INPUTS == std::tuple_size_v<tautline::Observation>);
static_assert(TAUTLINE_ENV_ACTIONS == tautline::kTetherActions);

int32_t tautline_env_version(void) { return TAUTLINE_ENV_VERSION; }

const char* tautline_env_error(void) { return tautline::last_error.c_str(); }

tautline_env* tautline_env_create(const char* scene_path, const char* options_json) {
  try {
    auto made = tautline::Make(scene_path, options_json);
    if (!made) {
      Fail(ToString(made.error()));
      return nullptr;
    }
    Handles::All().Add(made->get());
    return made->release();
  } catch (const std::exception& fault) {
    Guarded([&] { return Fail(fault.what()); });
    return nullptr;
  }
}

void tautline_env_free(tautline_env* env) {
  Guarded([env] {
    if (env != nullptr && Handles::All().Remove(env)) delete env;
    return 0;
  });
}

int32_t tautline_env_reset(tautline_env* env, uint64_t seed, float* observation) {
  return Guarded([=]() -> int32_t {
    if (Refused(env)) return -1;
    tautline::Write(env->env->Reset(seed), observation);
    env->running = true;
    return 0;
  });
}

int32_t tautline_env_step(tautline_env* env, int32_t action, tautline_env_step_result* result) {
  return Guarded([=]() -> int32_t {
    if (Refused(env)) return -1;
    if (result == nullptr) return Fail("no place for the result");
    if (!env->running) return Fail("no episode is running: reset first");
    if (action < 0 || action >= TAUTLINE_ENV_ACTIONS) {
      return Fail("there is no action " + std::to_string(action) + ": 0 turns right, 1 goes straight, 2 turns left");
    }
    const tautline::EnvStep step = env->env->Step(static_cast<tautline::TetherAction>(action));
    env->running = !step.ends();
    tautline::Write(env->env->Observe(), result->observation);
    result->reward = step.reward;
    result->terminated = step.at_goal || step.robot_obstacle ? 1 : 0;
    result->truncated = step.cut && result->terminated == 0 ? 1 : 0;
    result->at_goal = step.at_goal ? 1 : 0;
    result->robot_obstacle = step.robot_obstacle ? 1 : 0;
    result->cable_obstacle = step.cable_obstacle ? 1 : 0;
    result->cable_robot = step.cable_robot ? 1 : 0;
    result->held = step.held ? 1 : 0;
    return 0;
  });
}

int32_t tautline_env_observe(const tautline_env* env, float* observation) {
  return Guarded([=]() -> int32_t {
    if (Refused(env)) return -1;
    if (observation == nullptr) return Fail("no place for the observation");
    tautline::Write(env->env->Observe(), observation);
    return 0;
  });
}

int32_t tautline_env_where(const tautline_env* env, tautline_env_pose* pose) {
  return Guarded([=]() -> int32_t {
    if (Refused(env)) return -1;
    if (pose == nullptr) return Fail("no place for the pose");
    const tautline::RobotPose& at = env->env->pose();
    *pose = {at.at.x, at.at.y, at.heading_rad};
    return 0;
  });
}

int64_t tautline_env_cable(const tautline_env* env, double* points, size_t room) {
  return Guarded([=]() -> int64_t {
    if (Refused(env)) return -1;
    const auto nodes = env->env->cable().nodes();
    for (std::size_t i = 0; points != nullptr && i < std::min(room, nodes.size()); ++i) {
      points[2 * i] = nodes[i].x;
      points[2 * i + 1] = nodes[i].y;
    }
    return static_cast<int64_t>(nodes.size());
  });
}

int32_t tautline_env_goal(const tautline_env* env, double* goal) {
  return Guarded([=]() -> int32_t {
    if (Refused(env)) return -1;
    if (goal == nullptr) return Fail("no place for the goal");
    goal[0] = env->env->task().goal.x;
    goal[1] = env->env->task().goal.y;
    goal[2] = env->env->options().goal_radius_m;
    return 0;
  });
}
