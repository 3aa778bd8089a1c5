#include "tautline/network/mlp.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/test_scale.h"
#include "tautline/network/loss.h"

namespace tautline {
namespace {

std::vector<float> Random(std::size_t count, Rng& rng) {
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(rng.Uniform(-1, 1));
  return values;
}

/// The outputs for one sample by the definition, in double; `nudged` is one of the parameters, changed by `by`.
std::vector<double> Slowly(const Mlp& network, std::span<const float> x, std::size_t nudged = 0, double by = 0) {
  std::vector<double> values(x.begin(), x.end());
  const auto parameter = [&](std::size_t i) { return network.parameters()[i] + (i == nudged ? by : 0); };
  for (int layer = 0; layer < network.layers(); ++layer) {
    const std::size_t inputs = values.size();
    const std::size_t outputs = network.bias(layer).size();
    std::vector<double> next(outputs);
    for (std::size_t o = 0; o < outputs; ++o) {
      next[o] = parameter(network.offset(layer) + inputs * outputs + o);
      for (std::size_t i = 0; i < inputs; ++i) {
        next[o] += parameter(network.offset(layer) + o * inputs + i) * values[i];
      }
      if (layer + 1 < network.layers()) next[o] = std::max(0.0, next[o]);
    }
    values = next;
  }
  return values;
}

TEST(Mlp, WeightsAreWithinTheBoundOfTheirLayerAndFillIt) {
  Rng rng(7);
  const Mlp network = Mlp::Random({4, 100, 3}, rng);
  for (const auto& [layer, bound] : {std::pair{0, 0.5F}, std::pair{1, 0.1F}}) {
    float largest = 0;
    for (const float weight : network.weights(layer)) largest = std::max(largest, std::abs(weight));
    EXPECT_LE(largest, bound);
    EXPECT_GT(largest, 0.9F * bound);
  }
  EXPECT_EQ(network.parameters().size(), 4U * 100 + 100 + 100 * 3 + 3);
}

TEST(Mlp, ABatchGivesWhatTheDefinitionGivesEachSample) {
  Rng rng(8);
  const Mlp network = Mlp::Random({3, 40, 17, 2}, rng);
  for (const Kernels* kernels : AvailableKernels()) {
    MlpPass pass(network.widths(), 9, *kernels);
    for (const std::size_t batch : {1U, 2U, 9U}) {
      const auto x = Random(3 * batch, rng);
      const auto y = pass.Forward(network, x);
      ASSERT_EQ(y.size(), 2 * batch);
      for (std::size_t i = 0; i < batch; ++i) {
        const auto slow = Slowly(network, std::span(x).subspan(3 * i, 3));
        EXPECT_NEAR(y[2 * i], slow[0], 1e-6) << kernels->name;
        EXPECT_NEAR(y[2 * i + 1], slow[1], 1e-6) << kernels->name;
      }
    }
  }
}

/// Checks the gradient of `loss(outputs, slopes)` through a network against differences of the slow forward pass.
template <class Loss>
void CheckGradients(const Kernels& kernels, std::uint64_t seed, const Loss& loss) {
  Rng rng(seed);
  const Mlp network = Mlp::Random({3, 12, 10, 4}, rng);
  const std::size_t batch = 5;
  const auto x = Random(3 * batch, rng);
  MlpPass pass(network.widths(), 8, kernels);
  const auto outputs = pass.Forward(network, x);
  std::vector<float> slopes(outputs.size());
  loss(std::vector<float>(outputs.begin(), outputs.end()), slopes);
  const auto gradient = pass.Backward(network, slopes);
  // The loss is smooth in the outputs, so its own differences are taken to first order: sum of slope * change. What is
  // checked here is the way back through the layers.
  for (std::size_t p = 0; p < gradient.size(); ++p) {
    constexpr double kStep = 1e-7;
    double change = 0;
    for (std::size_t i = 0; i < batch; ++i) {
      const auto sample = std::span(x).subspan(3 * i, 3);
      const auto up = Slowly(network, sample, p, kStep), down = Slowly(network, sample, p, -kStep);
      for (std::size_t o = 0; o < 4; ++o) change += slopes[4 * i + o] * (up[o] - down[o]) / (2 * kStep);
    }
    ASSERT_NEAR(gradient[p], change, 1e-5) << "parameter " << p << " of seed " << seed << ", " << kernels.name;
  }
}

TEST(Mlp, GradientsAreFiniteDifferences) {
  for (const Kernels* kernels : AvailableKernels()) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(20); ++seed) {
      CheckGradients(*kernels, static_cast<std::uint64_t>(seed), [](std::span<const float> y, std::span<float> slopes) {
        const std::vector<float> targets(y.size(), 0.5F);
        MeanSquareLoss(y, targets, slopes);
      });
    }
  }
}

TEST(Mlp, TheSameBatchGivesTheSameBytesInAnotherPass) {
  Rng rng(9);
  const Mlp network = Mlp::Random({3, 64, 3}, rng);
  const auto x = Random(3 * 16, rng);
  MlpPass small(network.widths(), 16, PortableKernels()), large(network.widths(), 100, PortableKernels());
  const auto first = small.Forward(network, x);
  const std::vector<float> kept(first.begin(), first.end());
  EXPECT_THAT(large.Forward(network, x), testing::ElementsAreArray(kept));
}

}  // namespace
}  // namespace tautline
