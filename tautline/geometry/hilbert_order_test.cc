#include "tautline/geometry/hilbert_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

TEST(HilbertOrder, WalksOverALatticeInUnitSteps) {
  std::vector<Point> points;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) points.push_back({1.0 * x, 1.0 * y});
  }
  const std::vector<std::int32_t> order = HilbertOrder(points);
  ASSERT_EQ(order.size(), points.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point step = points[static_cast<std::size_t>(order[i])] - points[static_cast<std::size_t>(order[i - 1])];
    EXPECT_EQ(std::fabs(step.x) + std::fabs(step.y), 1) << i;
  }
}

TEST(HilbertOrder, IsAPermutationThatKeepsNeighboursTogether) {
  Rng rng(1);
  std::vector<Point> points;
  for (int i = 0; i < 10000; ++i) points.push_back({rng.Uniform(-5, 5), rng.Uniform(100, 110)});
  const std::vector<std::int32_t> order = HilbertOrder(points);
  std::vector<bool> seen(points.size(), false);
  double length = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    seen[static_cast<std::size_t>(order[i])] = true;
    if (i == 0) continue;
    length += Distance(points[static_cast<std::size_t>(order[i])], points[static_cast<std::size_t>(order[i - 1])]);
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 10000);
  // The shortest tour of n random points is about 0.71 sqrt(n A) long, a Hilbert tour a quarter longer.
  EXPECT_LT(length, 1.0 * std::sqrt(10000.0 * 100));
}

TEST(HilbertOrder, OfFewAndEqualPoints) {
  EXPECT_TRUE(HilbertOrder({}).empty());
  const std::vector<Point> equal(3, Point{2, 2});
  EXPECT_EQ(HilbertOrder(equal), (std::vector<std::int32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace tautline
