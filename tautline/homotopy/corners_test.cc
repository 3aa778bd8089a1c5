#include "tautline/homotopy/corners.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

std::vector<Point> PointsOf(const Corners& corners) {
  std::vector<Point> points;
  for (const Corner& corner : corners.all()) points.push_back(corner.point);
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<Point> CornersOf(const SketchedScene& scene) {
  const FreeSpace space = SpaceOf(scene);
  return PointsOf(Corners(space, FreeMesh(space)));
}

TEST(Corners, AreTheCornersOfObstaclesButNotOfTheRoom) {
  const std::vector<Point> expected{{1, 1}, {1, 2}, {2, 1}, {2, 2}};
  EXPECT_EQ(CornersOf(Sketch({"...",  //
                              ".a.",  //
                              "..."})),
            expected);
}

TEST(Corners, AreNotWhereTwoObstaclesTouch) {
  const std::vector<Point> expected{{1, 1}, {1, 2}, {2, 1}, {2, 3}, {3, 2}, {3, 3}};
  EXPECT_EQ(CornersOf(Sketch({"....",  //
                              "..b.",  //
                              ".a..",  //
                              "...."})),
            expected);
}

TEST(Corners, LeaveOutTheInsideOfAnL) {
  const std::vector<Point> expected{{1, 1}, {1, 3}, {2, 3}, {3, 1}, {3, 2}};
  EXPECT_EQ(CornersOf(Sketch({"....",  //
                              ".a..",  //
                              ".aa.",  //
                              "...."})),
            expected);
}

TEST(Corners, TangentFromTellsTheSideOfTheObstacle) {
  const Corner corner{.vertex = {}, .point = {2, 2}, .previous = {1, 2}, .next = {2, 1}, .first = {}};
  EXPECT_EQ(corner.TangentFrom({1, 4}), Side::kRight);
  EXPECT_EQ(corner.TangentFrom({0, 2}), Side::kRight) << "along the upper side";
  EXPECT_EQ(corner.TangentFrom({4, 1}), Side::kLeft);
  EXPECT_EQ(corner.TangentFrom({2, 0}), Side::kLeft) << "along the right side";
  EXPECT_EQ(corner.TangentFrom({4, 4}), Side::kNone);
  EXPECT_EQ(corner.TangentFrom({2, 4}), Side::kRight) << "the right side goes straight on";
}

class CornersRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, CornersRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(CornersRandom, AreTheReflexSectors) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const Corners corners(scene.space, mesh);
    std::vector<Point> reflex;
    const BruteSight sight(scene.rings, {});
    for (const SightNode& node : sight.nodes()) {
      if (node.on_boundary && Orientation(node.previous, node.point, node.next) < 0) reflex.push_back(node.point);
    }
    std::sort(reflex.begin(), reflex.end());
    ASSERT_EQ(PointsOf(corners), reflex);
  }
}

/// Whether the free triangle lies in the sector of the corner, by its middle.
bool InSectorOf(const Corner& corner, const FreeMesh& mesh, TriangleId id) {
  Point middle{0, 0};
  for (int i = 0; i < 3; ++i) middle = middle + 1.0 / 3 * mesh.triangulation().corner(id, i);
  return Orientation(corner.point, corner.next, middle) > 0 || Orientation(corner.previous, corner.point, middle) > 0;
}

TEST_P(CornersRandom, OwnTheTrianglesOfTheirSectors) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const Corners corners(scene.space, mesh);
    for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
      const TriangleId id(t);
      if (!mesh.IsFree(id)) continue;
      for (int i = 0; i < 3; ++i) {
        // No two reflex sectors fit around one vertex.
        const auto at_vertex = std::find_if(corners.all().begin(), corners.all().end(), [&](const Corner& corner) {
          return corner.vertex == mesh.triangle(id).vertex(i);
        });
        const bool owned = at_vertex != corners.all().end() && InSectorOf(*at_vertex, mesh, id);
        ASSERT_EQ(corners.At(id, i).valid(), owned);
        if (!owned) continue;
        ASSERT_EQ(&corners[corners.At(id, i)], &*at_vertex);
      }
    }
  }
}

}  // namespace
}  // namespace tautline
