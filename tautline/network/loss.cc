#include "tautline/network/loss.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"

namespace tautline {

double HuberLoss(std::span<const float> outputs, const ChosenTargets& wanted, std::span<float> slopes) {
  const std::size_t batch = wanted.chosen.size();
  TAUTLINE_CHECK(batch > 0 && wanted.targets.size() == batch && outputs.size() == slopes.size());
  TAUTLINE_CHECK(outputs.size() % batch == 0);
  const std::size_t row = outputs.size() / batch;
  const double share = 1 / static_cast<double>(batch);
  std::fill(slopes.begin(), slopes.end(), 0.0F);
  double loss = 0;
  for (std::size_t i = 0; i < batch; ++i) {
    const auto choice = static_cast<std::size_t>(wanted.chosen[i]);
    TAUTLINE_CHECK(choice < row);
    const double excess = static_cast<double>(outputs[i * row + choice]) - wanted.targets[i];
    loss += share * (std::abs(excess) < 1 ? excess * excess / 2 : std::abs(excess) - 0.5);
    slopes[i * row + choice] = static_cast<float>(share * std::clamp(excess, -1.0, 1.0));
  }
  return loss;
}

double MeanSquareLoss(std::span<const float> outputs, std::span<const float> targets, std::span<float> slopes) {
  TAUTLINE_CHECK(!outputs.empty() && outputs.size() == targets.size() && outputs.size() == slopes.size());
  const double share = 1 / static_cast<double>(outputs.size());
  double loss = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const double excess = static_cast<double>(outputs[i]) - targets[i];
    loss += share * excess * excess;
    slopes[i] = static_cast<float>(2 * share * excess);
  }
  return loss;
}

float ClipScale(double square_sum, double max_norm) {
  return static_cast<float>(std::min(1.0, max_norm / (std::sqrt(square_sum) + 1e-6)));
}

}  // namespace tautline
