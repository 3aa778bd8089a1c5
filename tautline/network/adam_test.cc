#include "tautline/network/adam.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

/// Algorithm 1 of [Kingma2014], line by line, for one parameter in double.
struct PlainAdam {
  double m = 0, v = 0, theta = 0;
  int t = 0;
  void Step(double g, const AdamOptions& o) {
    ++t;
    m = o.decay_mean * m + (1 - o.decay_mean) * g;
    v = o.decay_square * v + (1 - o.decay_square) * g * g;
    const double m_hat = m / (1 - std::pow(o.decay_mean, t));
    const double v_hat = v / (1 - std::pow(o.decay_square, t));
    theta -= o.learning_rate * m_hat / (std::sqrt(v_hat) + o.epsilon);
  }
};

TEST(Adam, FollowsTheAlgorithm) {
  const AdamOptions options{.learning_rate = 1e-2, .decay_mean = 0.8, .decay_square = 0.99, .epsilon = 1e-6};
  for (const Kernels* kernels : AvailableKernels()) {
    Rng rng(5);
    constexpr std::size_t kCount = 21;
    Adam adam(kCount, options, *kernels);
    std::vector<PlainAdam> plain(kCount);
    std::vector<float> parameters(kCount), gradient(kCount);
    for (int step = 0; step < 300; ++step) {
      for (float& g : gradient) g = static_cast<float>(rng.Uniform(-2, 2));
      adam.Step(parameters, gradient, 0.5F);
      for (std::size_t i = 0; i < kCount; ++i) {
        plain[i].Step(0.5 * gradient[i], options);
        ASSERT_NEAR(parameters[i], plain[i].theta, 2e-5) << kernels->name << ", step " << step;
      }
    }
  }
}

TEST(Adam, GoesOnFromItsState) {
  Rng rng(6);
  Adam whole(3, {}, PortableKernels());
  std::vector<float> parameters(3), gradient(3);
  const auto step = [&](Adam& adam, std::vector<float>& at) {
    for (float& g : gradient) g = static_cast<float>(rng.Uniform(-1, 1));
    adam.Step(at, gradient);
  };
  for (int i = 0; i < 10; ++i) step(whole, parameters);
  Adam resumed(3, {}, PortableKernels());
  resumed.set_state(whole.state());
  auto again = parameters;
  const Rng before = rng;
  for (int i = 0; i < 10; ++i) step(whole, parameters);
  rng = before;
  for (int i = 0; i < 10; ++i) step(resumed, again);
  EXPECT_EQ(parameters, again);
  EXPECT_EQ(whole.state().steps, resumed.state().steps);
}

}  // namespace
}  // namespace tautline
