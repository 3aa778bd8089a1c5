#include "bench/synthetic_map.h"

#include <gtest/gtest.h>

#include "tautline/homotopy/taut_space.h"

namespace tautline {
namespace {

TEST(SyntheticMap, HasTheVerticesAndObstaclesAskedForAndNoneTouch) {
  for (const SyntheticMapOptions& options :
       {SyntheticMapOptions{1000, 50, 1}, {2000, 3, 2}, {300, 100, 3}, {1003, 17, 4}}) {
    const FreeSpace space = BuildFreeSpace(SyntheticMap(options)).value();
    EXPECT_EQ(space.islands.size(), options.obstacles);
    EXPECT_TRUE(space.merges.empty());
    EXPECT_TRUE(space.snaps.empty());
    ASSERT_EQ(space.components.size(), 1U);
    std::size_t vertices = 0;
    for (const BoundaryRing& hole : space.components[0].holes) vertices += hole.points.size();
    EXPECT_EQ(vertices, options.vertices);
  }
}

TEST(SyntheticMap, IsTheSameForTheSameSeedOnly) {
  const auto ring = [](std::uint64_t seed) {
    return SyntheticMap({.vertices = 100, .obstacles = 5, .seed = seed}).obstacles.at(2).polygon->outer;
  };
  EXPECT_EQ(ring(1), ring(1));
  EXPECT_NE(ring(1), ring(2));
}

TEST(SyntheticCorridor, ItsWayPassesAllOfItsTriangles) {
  const SyntheticCorridor corridor = MakeSyntheticCorridor(400, 1);
  const TautSpace space(BuildFreeSpace(corridor.world).value());
  std::optional<Walk> walk;
  ASSERT_FALSE(space.Follow(corridor.way, walk));
  // A polygon of n vertices has n - 2 triangles; the two at its ends may be cut off.
  EXPECT_GE(walk->sleeve.size(), 400U - 4);
  EXPECT_GT(PullTaut(space.mesh(), *walk).points.size(), 50U);
}

}  // namespace
}  // namespace tautline
