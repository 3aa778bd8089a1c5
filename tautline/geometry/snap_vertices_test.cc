#include "tautline/geometry/snap_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

constexpr double kTolerance = 0.01;

std::vector<SourcedRing> Sourced(const std::vector<Ring>& rings) {
  std::vector<SourcedRing> sourced;
  for (const Ring& ring : rings) sourced.push_back({ring, static_cast<std::int32_t>(sourced.size())});
  return sourced;
}

bool ShareAVertex(const SourcedRing& a, const SourcedRing& b) {
  const std::set<Point> points(a.points.begin(), a.points.end());
  return std::any_of(b.points.begin(), b.points.end(), [&points](Point p) { return points.count(p) > 0; });
}

double DistanceBetween(const Ring& a, const Ring& b) {
  double least = 1e300;
  const auto from_points = [&least](const Ring& points, const Ring& edges) {
    for (const Point p : points) {
      for (std::size_t i = 0; i < edges.size(); ++i) {
        least = std::min(least, DistanceToSegment(p, edges[i], edges[(i + 1) % edges.size()]));
      }
    }
  };
  from_points(a, b);
  from_points(b, a);
  return least;
}

TEST(SnapVertices, AVertexGoesToAVertex) {
  std::vector<SourcedRing> rings = Sourced({Rectangle({0, 0}, {1, 1}), Rectangle({1.001, 1.001}, {2, 2})});
  const std::vector<VertexMove> moves = SnapVertices(rings, kTolerance);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].source, 1);
  EXPECT_EQ(moves[0].onto, 0);
  EXPECT_EQ(moves[0].from, (Point{1.001, 1.001}));
  EXPECT_EQ(moves[0].to, (Point{1, 1}));
  EXPECT_EQ(rings[0].points, Rectangle({0, 0}, {1, 1}));
  EXPECT_EQ(rings[1].points, (Ring{{1, 1}, {2, 1.001}, {2, 2}, {1.001, 2}}));
}

TEST(SnapVertices, AVertexGoesToAnEdgeAndBecomesAVertexThere) {
  std::vector<SourcedRing> rings = Sourced({Rectangle({0, 0}, {4, 1}), {{2, 1.001}, {3, 2}, {1, 2}}});
  const std::vector<VertexMove> moves = SnapVertices(rings, kTolerance);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].to, (Point{2, 1}));
  EXPECT_EQ(rings[0].points, (Ring{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {0, 1}}));
  EXPECT_EQ(rings[1].points, (Ring{{2, 1}, {3, 2}, {1, 2}}));
}

TEST(SnapVertices, AnEdgeBendsThroughAVertex) {
  std::vector<SourcedRing> rings = Sourced({{{2, 0.999}, {1, 0}, {3, 0}}, Rectangle({0, 1}, {4, 2})});
  const std::vector<VertexMove> moves = SnapVertices(rings, kTolerance);
  ASSERT_EQ(moves.size(), 1u);
  EXPECT_EQ(moves[0].source, 1);
  EXPECT_EQ(moves[0].from, (Point{2, 1}));
  EXPECT_EQ(moves[0].to, (Point{2, 0.999}));
  EXPECT_EQ(rings[1].points, (Ring{{0, 1}, {2, 0.999}, {4, 1}, {4, 2}, {0, 2}}));
}

TEST(SnapVertices, EdgesSideBySideBecomeOne) {
  std::vector<SourcedRing> rings = Sourced({Rectangle({0, 0}, {4, 1}), Rectangle({1, 1.001}, {3, 2})});
  SnapVertices(rings, kTolerance);
  EXPECT_EQ(rings[0].points, (Ring{{0, 0}, {4, 0}, {4, 1}, {3, 1}, {1, 1}, {0, 1}}));
  EXPECT_EQ(rings[1].points, Rectangle({1, 1}, {3, 2}));
}

TEST(SnapVertices, AVertexFollowsOneThatMoves) {
  // The second is near the first, the third near where the second was.
  std::vector<SourcedRing> rings =
      Sourced({Rectangle({0, 0}, {1, 1}), Rectangle({1.008, 0}, {2, 1}), {{1.008, 1.008}, {2, 3}, {1, 3}}});
  SnapVertices(rings, kTolerance);
  EXPECT_EQ(rings[1].points, (Ring{{1, 0}, {2, 0}, {2, 1}, {1, 1}}));
  EXPECT_EQ(rings[2].points[0], (Point{1, 1}));
}

TEST(SnapVertices, LeavesAloneWhatIsOfOneSourceOrFartherAway) {
  const std::vector<SourcedRing> before{
      {Rectangle({0, 0}, {1, 1}), 0}, {Rectangle({1.02, 0}, {2, 1}), 1}, {Rectangle({2.001, 0}, {3, 1}), 1}};
  std::vector<SourcedRing> rings = before;
  EXPECT_TRUE(SnapVertices(rings, kTolerance).empty());
  for (std::size_t i = 0; i < rings.size(); ++i) EXPECT_EQ(rings[i].points, before[i].points);
}

TEST(SnapVertices, DoesNotReportWhatAlreadyTouches) {
  std::vector<SourcedRing> rings = Sourced({Rectangle({0, 0}, {4, 1}), {{2, 1}, {3, 2}, {1, 2}}});
  EXPECT_TRUE(SnapVertices(rings, kTolerance).empty());
  EXPECT_TRUE(ShareAVertex(rings[0], rings[1])) << "for rounding must not part them";
}

TEST(SnapVertices, TwoRingsThatComeNearShareAVertex) {
  const std::int64_t count = ScaledTestCount(5000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box{{0, 0}, {1, 1}};
    const std::vector<PolygonWithHoles> polygons = RandomPolygons(rng, box);
    const Ring first = polygons.front().outer, second = polygons.back().outer;
    std::vector<SourcedRing> rings = Sourced({first, second});
    const double tolerance = std::pow(10, rng.Uniform(-9, -1));
    SnapVertices(rings, tolerance);
    ASSERT_TRUE(ShareAVertex(rings[0], rings[1]) || DistanceBetween(first, second) > 0.999 * tolerance);
  }
}

TEST(SnapVertices, RandomMovesAreSmallAndDownwards) {
  const std::int64_t count = ScaledTestCount(5000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<Ring> before;
    for (const PolygonWithHoles& polygon : RandomPolygons(rng, {{0, 0}, {1, 1}})) before.push_back(polygon.outer);
    std::vector<SourcedRing> rings = Sourced(before);
    const double tolerance = std::pow(10, rng.Uniform(-9, -1));
    for (const VertexMove& move : SnapVertices(rings, tolerance)) {
      ASSERT_LT(move.onto, move.source);
      ASSERT_LE(Distance(move.from, move.to), tolerance * static_cast<double>(before.size()));
    }
  }
}

}  // namespace
}  // namespace tautline
