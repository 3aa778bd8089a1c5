// Random drives of a cable in random scenes, for tests only.
#ifndef TAUTLINE_CABLE_RANDOM_DRIVE_H_
#define TAUTLINE_CABLE_RANDOM_DRIVE_H_

#include <cmath>
#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/cable/cable.h"

namespace tautline {

/// Drives straight for a while, turns, and turns at once where it is refused.
class RandomDrive {
 public:
  RandomDrive(Rng& rng, double step_m) : rng_(rng), step_m_(step_m) { Turn(); }

  StepResult Step(Cable& cable) {
    if (left_ == 0) Turn();
    --left_;
    const Point way{step_m_ * std::cos(heading_), step_m_ * std::sin(heading_)};
    const StepResult result = cable.Step(cable.robot() + way, 0.05);
    if (result.outcome != StepOutcome::kMoved) left_ = 0;
    return result;
  }

 private:
  void Turn() {
    heading_ = rng_.Uniform(0, 2 * std::numbers::pi);
    left_ = rng_.UniformInt(1, 40);
  }

  Rng& rng_;
  double step_m_;
  double heading_ = 0;
  int left_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_CABLE_RANDOM_DRIVE_H_
