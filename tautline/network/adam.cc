#include "tautline/network/adam.h"

#include <cmath>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {

Adam::Adam(std::size_t parameters, const AdamOptions& options, const Kernels& kernels)
    : options_(options), kernels_(&kernels) {
  state_.mean.assign(parameters, 0);
  state_.square.assign(parameters, 0);
}

void Adam::Step(std::span<float> parameters, std::span<const float> gradient, float gradient_scale) {
  TAUTLINE_CHECK(parameters.size() == state_.mean.size() && gradient.size() == parameters.size());
  const auto t = static_cast<double>(++state_.steps);
  kernels_->adam({.count = parameters.size(),
                  .gradient = gradient.data(),
                  .gradient_scale = gradient_scale,
                  .parameters = parameters.data(),
                  .mean = state_.mean.data(),
                  .square = state_.square.data(),
                  .decay_mean = static_cast<float>(options_.decay_mean),
                  .decay_square = static_cast<float>(options_.decay_square),
                  .rate = static_cast<float>(options_.learning_rate / (1 - std::pow(options_.decay_mean, t))),
                  .root_scale = static_cast<float>(1 / std::sqrt(1 - std::pow(options_.decay_square, t))),
                  .epsilon = static_cast<float>(options_.epsilon)});
}

void Adam::set_state(AdamState state) {
  TAUTLINE_CHECK(state.mean.size() == state_.mean.size() && state.square.size() == state_.mean.size());
  state_ = std::move(state);
}

}  // namespace tautline
