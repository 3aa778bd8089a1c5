// Teaching the policy for all maps: what the search does, learned from what the robot sees.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_IMITATION_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_IMITATION_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/network/mlp.h"
#include "tautline/planners/contact_free/driver_policy.h"
#include "tautline/planners/contact_free/plan_contact_free.h"

namespace tautline {

/// What was seen, and where the search went then.
struct Demonstrations {
  std::vector<float> views;    ///< kViewSize numbers each.
  std::vector<float> intents;  ///< kIntentSize numbers each.

  /// How many.
  std::size_t size() const { return views.size() / kViewSize; }
  /// Puts others behind these.
  void Append(const Demonstrations& others);
};

/// A scene, its environment with the way-points of a reference, ready to drive.
struct Course {
  Scene scene;                            ///< What it was made from.
  std::shared_ptr<const ContactMap> map;  ///< Shared with the copies of the environment, which refer to it.
  TetherEnv env;                          ///< At its start.
};

/// A course on a scene with the way-points of the exact reference [SelectReference]. Nothing where there is none, or
/// robot or goal have no room.
std::optional<Course> MakeCourse(const Scene& scene, const TetherEnvOptions& options);

/// The courses of a seed: a random one, and for every second seed the one after it, with its cable laid by the search.
std::optional<Course> CourseOf(std::uint64_t seed, const TetherEnvOptions& options);

/// What is collected.
struct CollectOptions {
  TetherEnvOptions env;                  ///< The robot.
  std::int64_t last_search = 20'000;     ///< As in ContactFreeOptions.
  const DriverPolicy* policy = nullptr;  ///< Whose mistakes are shown the way out; null: the course itself is.
  int recoveries = 3;                    ///< Of a course.
};

/// What the search does on the course of a seed; with a policy, what it does instead from `recoveries` states into
/// which that policy came by itself, so that it learns to get out of its own mistakes [Ross2011]. Deterministic: seeds
/// may be spread over threads. About a second for each search.
Demonstrations CollectDemonstrations(std::uint64_t seed, const CollectOptions& options);

/// How the network is taught.
struct ImitationOptions {
  std::vector<int> hidden = {128, 128};                       ///< Widths of its hidden layers.
  int epochs = 30;                                            ///< How often each demonstration is seen.
  int batch = 128;                                            ///< Demonstrations a step.
  double learning_rate = 1e-3;                                ///< Of Adam at first; it falls to a tenth.
  std::uint64_t seed = 1;                                     ///< Of the first weights and the order.
  std::function<bool(int epoch, double loss)> progress = {};  ///< Told after each epoch; false stops.
};

/// A network that wants what the demonstrations do: least squares, each seen as it is and in a mirror by chance. The
/// same seed and kernels give the same bytes. Requires a demonstration. O(epochs * demonstrations * weights).
Mlp Imitate(const Demonstrations& demonstrations, const ImitationOptions& options, const Kernels& kernels);

/// A view as it would be in a mirror along the robot's heading, and the intent that belongs to it.
DriverView Mirrored(const DriverView& view);
/// That intent.
DriverIntent Mirrored(const DriverIntent& intent);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_IMITATION_H_
