// One policy for all maps: a small network that chooses velocities from what the robot sees, with a look ahead.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_POLICY_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_POLICY_H_

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/network/mlp.h"
#include "tautline/planners/contact_free/driven_motion.h"
#include "tautline/planners/contact_free/driver_view.h"

namespace tautline {

/// How many velocities it chooses among: straight on, arcs of three radii to either side, turns on the spot.
inline constexpr int kDriverChoices = 9;

/// Them, for a robot of these options, by number.
std::array<Velocity, kDriverChoices> DriverChoices(const TetherEnvOptions& options);

/// The number of the choice that is nearest to a velocity.
int ChoiceOf(const Velocity& velocity, const TetherEnvOptions& options);

/// How a policy drives.
struct DriverOptions {
  /// Steps ahead for which a choice is tried on a copy before it is made; 0: the network alone decides.
  int look_ahead_steps = 6;
  /// What a penalty found there counts against the network's preference, by the unit of its outputs.
  double caution = 3;
};

/// The policy. A copy of the network and scratch; not for two threads at a time. Deterministic for its kernels.
class DriverPolicy {
 public:
  /// Requires a network of kViewSize inputs and kDriverChoices outputs. Keeps a reference to the kernels.
  DriverPolicy(const Mlp& network, const Kernels& kernels, const DriverOptions& options = {});

  /// Reads an ONNX file that WriteOnnx wrote. Errors: as ReadOnnx, or a network of another shape; `name` says where.
  static Expected<DriverPolicy> Read(std::string_view bytes, const std::string& name, const Kernels& kernels,
                                     const DriverOptions& options = {});

  /// The choice for where the robot stands, `waypoint` as LookAround has it. Of the network's preferences, less what
  /// the next steps would cost; never one that hits an obstacle or is held at once where another is not. Well below a
  /// millisecond.
  int Choose(const TetherEnv& env, std::size_t waypoint);

  /// Drives from where the environment is until the episode ends. O(steps).
  DrivenMotion Drive(TetherEnv env);

  /// What it chooses by.
  const Mlp& network() const { return network_; }

 private:
  Mlp network_;
  MlpPass pass_;
  DriverOptions options_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_POLICY_H_
