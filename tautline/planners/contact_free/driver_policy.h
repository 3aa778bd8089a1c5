// One policy for all maps: a small network that chooses velocities from what the robot sees, with a look ahead.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_POLICY_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_DRIVER_POLICY_H_

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/network/mlp.h"
#include "tautline/planners/contact_free/driven_motion.h"
#include "tautline/planners/contact_free/driver_view.h"

namespace tautline {

/// What the network says: two points of the way that it wants to take, so far along it, robot radii.
inline constexpr std::array<double, 2> kIntentAhead = {1.5, 4};
/// As numbers: both points in the robot's frame, in units of the farther distance.
inline constexpr int kIntentSize = 4;
/// An intent.
using DriverIntent = std::array<float, kIntentSize>;

/// The intent of a robot that will follow `way` from its pose on.
DriverIntent IntentOf(const RobotPose& pose, std::span<const Point> way, double robot_radius_m);

/// How a policy drives.
struct DriverOptions {
  /// Steps ahead for which velocities are tried on a copy before one is chosen; 0: the network alone decides.
  int look_ahead_steps = 40;
  /// What a contact in each of these steps counts, in half circles of a turn that the network does not want.
  double caution = 8;
};

/// The policy. A copy of the network and scratch; not for two threads at a time. Deterministic for its kernels.
class DriverPolicy {
 public:
  /// Requires a network of kViewSize inputs and kIntentSize outputs. Keeps a reference to the kernels.
  DriverPolicy(const Mlp& network, const Kernels& kernels, const DriverOptions& options = {});

  /// Reads an ONNX file that WriteOnnx wrote. Errors: as ReadOnnx, or a network of another shape; `name` says where.
  static Expected<DriverPolicy> Read(std::string_view bytes, const std::string& name, const Kernels& kernels,
                                     const DriverOptions& options = {});

  /// Where the network wants to go from where the robot stands, `waypoint` as LookAround has it.
  DriverIntent Want(const TetherEnv& env, std::size_t waypoint);

  /// The velocity for the next step: that which pursues what the network wants, or another one where that leads to
  /// contacts soon; never one that hits an obstacle at once where another does not. Well below a millisecond.
  Velocity Choose(const TetherEnv& env, std::size_t waypoint);

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
