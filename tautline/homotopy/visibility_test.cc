#include "tautline/homotopy/visibility.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

struct Ground {
  explicit Ground(const FreeSpace& space) : mesh(space), corners(space, mesh) {}

  /// The corners that are seen from a point.
  std::set<Point> From(Point p) const {
    std::set<Point> seen;
    for (const Sighting& sighting : SeeFromPoint(mesh, corners, mesh.Locate(p, 0).value())) {
      seen.insert(corners[sighting.corner].point);
    }
    return seen;
  }

  CornerId CornerAt(Point p) const {
    for (std::size_t c = 0; c < corners.size(); ++c) {
      if (corners.all()[c].point == p) return CornerId(c);
    }
    return {};
  }

  FreeMesh mesh;
  Corners corners;
};

TEST(SeeFromPoint, SeesTangentCornersOnly) {
  const auto scene = Sketch({".....",  //
                             "..a..",  //
                             ".....",  //
                             "..P..",  //
                             "....."});
  const Ground ground(SpaceOf(scene));
  EXPECT_EQ(ground.From(scene['P']), (std::set<Point>{{2, 3}, {3, 3}}));
  EXPECT_EQ(ground.From({2, 0}), (std::set<Point>{{2, 3}, {2, 4}, {3, 3}})) << "along a side";
  EXPECT_EQ(ground.From({2, 3}), (std::set<Point>{{2, 4}, {3, 3}})) << "from a corner";
}

TEST(SeeFromPoint, GrazesCorners) {
  const auto scene = Sketch({"......",  //
                             "...b..",  //
                             "......",  //
                             ".a....",  //
                             "......"});
  const Ground ground(SpaceOf(scene));
  EXPECT_TRUE(ground.From({0, 1}).contains({3, 4})) << "past the corner (1, 2)";
}

TEST(SeeFromCorner, SeesBitangents) {
  const auto scene = Sketch({".......",  //
                             ".aa.bb.",  //
                             ".aa.bb.",  //
                             "......."});
  const Ground ground(SpaceOf(scene));
  const auto seen = SeeFromCorner(ground.mesh, ground.corners, ground.CornerAt({3, 3}));
  // Its own two neighbours, the upper corners of b, and the lower left one by the crossing tangent.
  std::vector<Sighting> expected{{ground.CornerAt({1, 3}), Side::kLeft, Side::kLeft},
                                 {ground.CornerAt({3, 1}), Side::kRight, Side::kRight},
                                 {ground.CornerAt({4, 3}), Side::kRight, Side::kRight},
                                 {ground.CornerAt({6, 3}), Side::kRight, Side::kRight},
                                 {ground.CornerAt({4, 1}), Side::kRight, Side::kLeft}};
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(seen, expected);
}

class VisibilityRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, VisibilityRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// The node of the corner's sector.
std::size_t NodeOf(const BruteSight& sight, const Corner& corner) {
  const auto nodes = sight.NodesAt(corner.point);
  return *std::find_if(nodes.begin(), nodes.end(), [&](std::size_t node) {
    const SightNode& here = sight.nodes()[node];
    return Orientation(here.previous, here.point, here.next) < 0;
  });
}

/// On which side of the directed line ab the points p and q both lie; collinear ones count for both sides.
Side SideOf(Point a, Point b, Point p, Point q) {
  const int at_p = Orientation(a, b, p), at_q = Orientation(a, b, q);
  if (at_p * at_q < 0) return Side::kNone;
  return at_p + at_q > 0 ? Side::kLeft : Side::kRight;
}

TEST_P(VisibilityRandom, FromAPointIsBruteForceSight) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const Ground ground(scene.space);
    const Point eye = RandomFreePoint(rng, scene);
    const BruteSight sight(scene.rings, std::vector{eye});
    std::vector<Sighting> expected;
    for (std::size_t c = 0; c < ground.corners.size(); ++c) {
      const Corner& corner = ground.corners.all()[c];
      if (corner.point == eye || !sight.Sees(sight.NodesAt(eye)[0], NodeOf(sight, corner))) continue;
      const Side head = SideOf(eye, corner.point, corner.previous, corner.next);
      if (head != Side::kNone) expected.push_back({CornerId(c), Side::kNone, head});
    }
    ASSERT_EQ(SeeFromPoint(ground.mesh, ground.corners, ground.mesh.Locate(eye, 0).value()), expected)
        << eye.x << ' ' << eye.y;
  }
}

TEST_P(VisibilityRandom, FromACornerIsBruteForceSightAlongBitangents) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const Ground ground(scene.space);
    const BruteSight sight(scene.rings, {});
    for (std::size_t a = 0; a < ground.corners.size(); ++a) {
      const Corner& from = ground.corners.all()[a];
      std::vector<Sighting> expected;
      for (std::size_t b = 0; b < ground.corners.size(); ++b) {
        const Corner& to = ground.corners.all()[b];
        if (a == b || !sight.Sees(NodeOf(sight, from), NodeOf(sight, to))) continue;
        const Side tail = SideOf(from.point, to.point, from.previous, from.next);
        const Side head = SideOf(from.point, to.point, to.previous, to.next);
        if (tail != Side::kNone && head != Side::kNone) expected.push_back({CornerId(b), tail, head});
      }
      ASSERT_EQ(SeeFromCorner(ground.mesh, ground.corners, CornerId(a)), expected)
          << from.point.x << ' ' << from.point.y;
    }
  }
}

}  // namespace
}  // namespace tautline
