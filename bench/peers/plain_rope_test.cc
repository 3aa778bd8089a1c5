#include "bench/peers/plain_rope.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

TEST(PlainRope, FollowsItsEndInTheOpen) {
  PlainRope rope({}, {0, 0}, 20, 0.1);
  for (int step = 1; step <= 36; ++step) rope.Step({0.05 * step, 0}, 20);
  rope.Step({1.8, 0}, 1000);
  EXPECT_EQ(rope.nodes().front(), (Point{0, 0}));
  EXPECT_EQ(rope.nodes().back(), (Point{1.8, 0}));
  EXPECT_LE(rope.WorstStretch(), 1.01);
}

TEST(PlainRope, CountsTheLinksThatPassAnObstacle) {
  const Ring post{{1, -0.04}, {1.02, -0.04}, {1.02, 0.04}, {1, 0.04}};
  PlainRope rope({post}, {0, 0}, 40, 0.1);
  for (int step = 1; step <= 40; ++step) rope.Step({0.05 * step, 0}, 20);
  EXPECT_EQ(rope.LinksThroughObstacles(), 1U) << "a post thinner than a link stops no node";
}

}  // namespace
}  // namespace tautline
