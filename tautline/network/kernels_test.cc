#include "tautline/network/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

std::vector<float> Random(std::size_t count, Rng& rng) {
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(rng.Uniform(-1, 1));
  return values;
}

class EveryKernel : public testing::TestWithParam<const Kernels*> {};

TEST_P(EveryKernel, ALayerIsTheSumsThatItStandsFor) {
  Rng rng(1);
  for (const auto& [inputs, outputs, batch] : {std::array{3, 5, 1}, std::array{3, 256, 32}, std::array{70, 33, 7}}) {
    const auto in = static_cast<std::size_t>(inputs), out = static_cast<std::size_t>(outputs);
    const auto rows = static_cast<std::size_t>(batch);
    const auto weights = Random(in * out, rng), bias = Random(out, rng), x = Random(rows * in, rng);
    std::vector<float> y(rows * out);
    GetParam()->layer({.inputs = inputs,
                       .outputs = outputs,
                       .batch = batch,
                       .weights = weights.data(),
                       .bias = bias.data(),
                       .x = x.data(),
                       .y = y.data(),
                       .relu = true});
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t o = 0; o < out; ++o) {
        double sum = bias[o];
        for (std::size_t i = 0; i < in; ++i) sum += static_cast<double>(weights[o * in + i]) * x[r * in + i];
        ASSERT_NEAR(y[r * out + o], std::max(0.0, sum), 1e-5);
      }
    }
  }
}

TEST_P(EveryKernel, SumsDoNotDependOnTheAddress) {
  Rng rng(2);
  const auto values = Random(1000, rng);
  const double sum = GetParam()->square_sum(values.data(), 1000);
  double exact = 0;
  for (const float value : values) exact += static_cast<double>(value) * value;
  EXPECT_NEAR(sum, exact, 1e-4);
  std::vector<float> room(1020);
  for (std::size_t shift = 0; shift < 20; ++shift) {
    std::copy(values.begin(), values.end(), room.begin() + static_cast<std::ptrdiff_t>(shift));
    EXPECT_EQ(GetParam()->square_sum(room.data() + shift, 1000), sum) << shift;
  }
}

TEST_P(EveryKernel, GradientsDoNotDependOnTheAddress) {
  Rng rng(3);
  const int inputs = 37, outputs = 29, batch = 11;
  const auto weights = Random(37 * 29, rng), x = Random(37 * 11, rng), d_y = Random(29 * 11, rng);
  std::vector<float> first;
  std::vector<float> room(2 * (37 * 29) + 29 + 3 * 37 * 11 + 29 * 11 + 64);
  for (std::size_t shift = 0; shift < 17; ++shift) {
    float* const w = room.data() + shift;
    float* const in = std::copy(weights.begin(), weights.end(), w);
    float* const d_out = std::copy(x.begin(), x.end(), in);
    float* const results = std::copy(d_y.begin(), d_y.end(), d_out);
    float* const d_bias = results + 37 * 29;
    float* const d_x = d_bias + 29;
    GetParam()->layer_gradient({.inputs = inputs,
                                .outputs = outputs,
                                .batch = batch,
                                .weights = w,
                                .x = in,
                                .d_y = d_out,
                                .d_weights = results,
                                .d_bias = d_bias,
                                .d_x = d_x});
    const std::vector<float> got(results, d_x + 37 * 11);
    if (shift == 0) first = got;
    ASSERT_EQ(got, first) << shift;
  }
}

INSTANTIATE_TEST_SUITE_P(Kernels, EveryKernel, testing::ValuesIn(AvailableKernels()),
                         [](const auto& kernels) { return std::string(kernels.param->name); });

TEST(Kernels, AreFoundByTheirNames) {
  EXPECT_EQ(FindKernels("portable"), &PortableKernels());
  EXPECT_EQ(FindKernels("auto"), AvailableKernels().back());
  EXPECT_EQ(FindKernels("sse9"), nullptr);
}

}  // namespace
}  // namespace tautline
