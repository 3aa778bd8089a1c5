// The optimiser Adam.
#ifndef TAUTLINE_NETWORK_ADAM_H_
#define TAUTLINE_NETWORK_ADAM_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/network/kernels.h"

namespace tautline {

/// Its constants; the defaults are those of [Kingma2014].
struct AdamOptions {
  double learning_rate = 1e-3;  ///< Positive.
  double decay_mean = 0.9;      ///< beta 1, in [0, 1).
  double decay_square = 0.999;  ///< beta 2, in [0, 1).
  double epsilon = 1e-8;        ///< Keeps quotients finite.
};

/// All that Adam remembers, to be kept in a file.
struct AdamState {
  std::int64_t steps = 0;     ///< So many were made.
  std::vector<float> mean;    ///< Of the gradients of each parameter.
  std::vector<float> square;  ///< The mean of their squares.
};

/// Moves parameters against their gradients, each by about the learning rate. [Kingma2014, Alg. 1]
class Adam {
 public:
  /// For so many parameters. Keeps a reference to the kernels.
  Adam(std::size_t parameters, const AdamOptions& options, const Kernels& kernels);

  /// One step. The gradient counts `gradient_scale` times. Requires as many numbers as there are parameters. O(those).
  void Step(std::span<float> parameters, std::span<const float> gradient, float gradient_scale = 1);

  /// What it remembers.
  const AdamState& state() const { return state_; }
  /// Goes on from a state. Requires one of as many parameters.
  void set_state(AdamState state);

 private:
  AdamOptions options_;
  const Kernels* kernels_;
  AdamState state_;
};

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_ADAM_H_
