#include "tautline/homotopy/taut.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

Walk WalkAlong(const FreeMesh& mesh, const Polyline& polyline) {
  Walk walk(mesh.Locate(polyline.at(0), 0).value());
  for (const Point p : polyline) EXPECT_FALSE(WalkStraight(mesh, p, walk));
  return walk;
}

Polyline PointsOf(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

Polyline PulledTaut(const FreeMesh& mesh, const Polyline& polyline) {
  return PointsOf(PullTaut(mesh, WalkAlong(mesh, polyline)));
}

Polyline Reversed(const Polyline& polyline) { return {polyline.rbegin(), polyline.rend()}; }

TEST(PullTaut, KeepsTheSideOfTheObstacle) {
  const auto scene = Sketch({".......",  //
                             ".C...D.",  //
                             "..aaa..",  //
                             "A.aaa.B",  //
                             "..aaa..",  //
                             ".E...F.",  //
                             "......."});
  const FreeMesh mesh(SpaceOf(scene));
  EXPECT_EQ(PulledTaut(mesh, {scene['A'], scene['C'], scene['D'], scene['B']}),
            (Polyline{scene['A'], {2, 5}, {5, 5}, scene['B']}));
  EXPECT_EQ(PulledTaut(mesh, {scene['A'], scene['E'], scene['F'], scene['B']}),
            (Polyline{scene['A'], {2, 2}, {5, 2}, scene['B']}));
  EXPECT_EQ(PulledTaut(mesh, {scene['A'], scene['C'], scene['D'], scene['F'], scene['E'], scene['A']}),
            (Polyline{scene['A'], {2, 5}, {5, 5}, {5, 2}, {2, 2}, scene['A']}))
      << "once around";
  EXPECT_EQ(PulledTaut(mesh, {scene['A'], scene['C'], scene['D'], scene['C'], scene['E'], scene['A']}),
            (Polyline{scene['A']}))
      << "out and back";
}

TEST(PullTaut, HasNoStraightTurns) {
  const auto scene = Sketch({".......",  //
                             "..a.b..",  //
                             "......."});
  const FreeMesh mesh(SpaceOf(scene));
  EXPECT_EQ(PulledTaut(mesh, {{0, 1}, {3, 0.5}, {7, 1}}), (Polyline{{0, 1}, {7, 1}})) << "along both lower sides";
  EXPECT_EQ(PulledTaut(mesh, {{2, 1}, {3, 0.5}, {5, 1}}), (Polyline{{2, 1}, {5, 1}})) << "from corner to corner";
}

TEST(PullTaut, NamesTheVerticesOfItsBends) {
  const auto scene = Sketch({".....",  //
                             "..aa.",  //
                             ".AaaB",  //
                             "....."});
  const FreeMesh mesh(SpaceOf(scene));
  const TautCurve curve = PullTaut(mesh, WalkAlong(mesh, {scene['A'], {1.5, 0.5}, {4.5, 0.5}, scene['B']}));
  ASSERT_EQ(curve.points.size(), 4U);
  EXPECT_FALSE(curve.points.front().vertex.valid());
  EXPECT_FALSE(curve.points.back().vertex.valid());
  for (const std::size_t i : {1U, 2U}) EXPECT_EQ(mesh.point(curve.points[i].vertex), curve.points[i].point);
}

class TautRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, TautRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(TautRandom, IsTheShortestCurveOfItsClass) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(500); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const std::vector<Point> points{RandomFreePoint(rng, scene), RandomFreePoint(rng, scene),
                                    RandomFreePoint(rng, scene)};
    ClassOracle oracle(scene.rings, scene.representatives, points);
    const std::size_t from = oracle.sight().NodesAt(points[0])[0], to = oracle.sight().NodesAt(points[1])[0];
    const auto laid = RandomWalk(rng, oracle, from, to);
    if (!laid) continue;
    const TautCurve curve = PullTaut(mesh, WalkAlong(mesh, *laid));
    const Polyline taut = PointsOf(curve);
    ASSERT_LE(curve.length, Length(*laid) * (1 + 1e-12));
    ASSERT_EQ(curve.length, Length(taut));
    const int word = oracle.AppendPolyline(0, *laid);
    ASSERT_EQ(oracle.AppendPolyline(0, taut), word);
    const double shortest = oracle.LengthOf(from, to, word, Length(*laid));
    if (std::isfinite(shortest)) {
      ASSERT_NEAR(curve.length, shortest, 1e-9 * (1 + shortest));
    }
    ASSERT_EQ(PulledTaut(mesh, taut), taut) << "again";
    ASSERT_EQ(PulledTaut(mesh, Reversed(*laid)), Reversed(taut));
  }
}

}  // namespace
}  // namespace tautline
