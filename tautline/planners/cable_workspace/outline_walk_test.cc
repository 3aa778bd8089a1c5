#include "tautline/planners/cable_workspace/outline_walk.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/print_point.h"

namespace tautline {
namespace {

TEST(OutlineWalk, GoesAroundARectangle) {
  const OutlineWalk walk({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(walk.length(), 14);
  EXPECT_EQ(walk.At(0), (Point{0, 0}));
  EXPECT_EQ(walk.At(1), (Point{1, 0}));
  EXPECT_EQ(walk.At(4), (Point{4, 0}));
  EXPECT_EQ(walk.At(5.5), (Point{4, 1.5}));
  EXPECT_EQ(walk.At(13), (Point{0, 1}));
  EXPECT_EQ(walk.At(14), (Point{0, 0}));
}

TEST(OutlineWalk, WrapsPositions) {
  const OutlineWalk walk({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(walk.Wrapped(3), 3);
  EXPECT_EQ(walk.Wrapped(14), 0);
  EXPECT_EQ(walk.Wrapped(15), 1);
  EXPECT_EQ(walk.Wrapped(-1), 13);
  EXPECT_EQ(walk.Wrapped(-1e-300), 0) << "rounds to the length, which is the place 0";
  EXPECT_EQ(walk.Wrapped(-30), 12);
}

TEST(OutlineWalk, FindsTheCornersAround) {
  const OutlineWalk walk({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  EXPECT_EQ(walk.NextCorner(0), 4);
  EXPECT_EQ(walk.NextCorner(3.9), 4);
  EXPECT_EQ(walk.NextCorner(11), 0);
  EXPECT_EQ(walk.NextCorner(12), 0);
  EXPECT_EQ(walk.PreviousCorner(0), 11);
  EXPECT_EQ(walk.PreviousCorner(4), 0);
  EXPECT_EQ(walk.PreviousCorner(4.1), 4);
  EXPECT_EQ(walk.PreviousCorner(13), 11);
}

TEST(OutlineWalk, FindsWhereALineMeetsTheRingFirstBeyondAPoint) {
  // A notch from above: the line through it meets the ring four times.
  const OutlineWalk walk({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  EXPECT_EQ(walk.At(walk.Beyond({0, 3}, {1, 3}).value()), (Point{2, 3}));
  EXPECT_EQ(walk.At(walk.Beyond({0, 3}, {5, 3}).value()), (Point{6, 3}));
  EXPECT_EQ(walk.At(walk.Beyond({6, 3}, {5, 3}).value()), (Point{4, 3}));
  EXPECT_EQ(walk.At(walk.Beyond({0, 0}, {3, 1}).value()), (Point{6, 2}));
  EXPECT_FALSE(walk.Beyond({0, 3}, {7, 3}));
  EXPECT_FALSE(walk.Beyond({1, 1}, {1, 1}));
}

/// By definition: edge after edge until the rest is on one.
Point SlowAt(const Ring& ring, double position) {
  for (std::size_t i = 0;; i = (i + 1) % ring.size()) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    if (position <= Distance(from, to)) return from + (position / Distance(from, to)) * (to - from);
    position -= Distance(from, to);
  }
}

TEST(OutlineWalk, AgreesWithWalkingOnRandomRings) {
  Rng rng(20260101);
  for (std::int64_t trial = ScaledTestCount(200); trial > 0; --trial) {
    Ring ring;
    for (int corners = rng.UniformInt(3, 12); corners > 0; --corners) {
      ring.push_back({rng.Uniform(0, 10), rng.Uniform(0, 10)});
    }
    const OutlineWalk walk(ring);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const double corner = walk.corners()[i];
      EXPECT_EQ(walk.At(corner), ring[i]);
      EXPECT_EQ(walk.NextCorner(corner), walk.corners()[(i + 1) % ring.size()]);
      EXPECT_EQ(walk.PreviousCorner(walk.NextCorner(corner)), corner);
    }
    const double position = walk.Wrapped(rng.Uniform(-50, 50));
    EXPECT_LT(Distance(walk.At(position), SlowAt(ring, position)), 1e-12) << position;
  }
}

}  // namespace
}  // namespace tautline
