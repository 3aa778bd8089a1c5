#include "tautline/network/loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

using Loss = std::function<double(std::span<const float> outputs, std::span<float> slopes)>;

/// Every slope against the difference of the loss over a step that floats can tell.
void CheckSlopes(const Loss& loss, std::vector<float> outputs) {
  std::vector<float> slopes(outputs.size()), ignored(outputs.size());
  loss(outputs, slopes);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    constexpr float kStep = 1.0F / 1024;
    auto up = outputs, down = outputs;
    up[i] += kStep;
    down[i] -= kStep;
    const double width = static_cast<double>(up[i]) - down[i];
    EXPECT_NEAR(slopes[i], (loss(up, ignored) - loss(down, ignored)) / width, 1e-5) << i;
  }
}

std::vector<float> Outputs(std::size_t count) {
  Rng rng(3);
  std::vector<float> outputs(count);
  for (float& output : outputs) output = static_cast<float>(rng.Uniform(-3, 3));
  return outputs;
}

TEST(Loss, HuberIsASquareInsideAndALineOutside) {
  std::vector<float> slopes(4);
  const std::vector<int> chosen{0, 1};
  const std::vector<float> targets{0, 0};
  EXPECT_DOUBLE_EQ(HuberLoss(std::vector<float>{0.5F, 9, 9, -3}, {chosen, targets}, slopes), 0.5 * (0.125 + 2.5));
  EXPECT_EQ(slopes, (std::vector<float>{0.25F, 0, 0, -0.5F}));
}

TEST(Loss, SlopesAreFiniteDifferences) {
  const std::vector<int> chosen{2, 0, 1, 1};
  const std::vector<float> targets{0.3F, -2, 1, 0};
  CheckSlopes([&](auto y, auto slopes) { return HuberLoss(y, {chosen, targets}, slopes); }, Outputs(12));
  const std::vector<float> wanted(12, 0.5F);
  CheckSlopes([&](auto y, auto slopes) { return MeanSquareLoss(y, wanted, slopes); }, Outputs(12));
}

TEST(Loss, ClippingLeavesShortGradientsAlone) {
  EXPECT_EQ(ClipScale(9, 10), 1);
  EXPECT_NEAR(ClipScale(400, 10), 0.5, 1e-6);
  EXPECT_EQ(ClipScale(0, 10), 1);
}

}  // namespace
}  // namespace tautline
