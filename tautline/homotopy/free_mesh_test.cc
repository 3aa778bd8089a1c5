#include "tautline/homotopy/free_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

double FreeArea(const FreeMesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
    const TriangleId id(t);
    const auto corner = [&](int i) { return mesh.triangulation().corner(id, i); };
    if (mesh.IsFree(id)) area += SignedArea(Ring{corner(0), corner(1), corner(2)});
  }
  return area;
}

bool Holds(const FreeMesh& mesh, const Place& place) {
  for (int i = 0; i < 3; ++i) {
    const Point a = mesh.triangulation().corner(place.triangle, i);
    const Point b = mesh.triangulation().corner(place.triangle, Next(i));
    if (Orientation(a, b, place.point) < 0) return false;
  }
  return mesh.IsFree(place.triangle);
}

TEST(FreeMesh, CoversTheFreeGroundOnly) {
  const FreeMesh mesh(SpaceOf(Sketch({"......",  //
                                      ".aa.b.",  //
                                      ".aa.b.",  //
                                      "......"})));
  EXPECT_DOUBLE_EQ(FreeArea(mesh), 24 - 4 - 2);
}

TEST(FreeMesh, ToldApartComponents) {
  const auto scene = Sketch({"A.a.",  //
                             "..a.",  //
                             "..aB"});
  const FreeMesh mesh(SpaceOf(scene));
  const auto a = mesh.Locate(scene['A'], 0), b = mesh.Locate(scene['B'], 0);
  ASSERT_TRUE(a && b);
  EXPECT_NE(mesh.ComponentOf(a->triangle), mesh.ComponentOf(b->triangle));
}

TEST(FreeMesh, LocatesOnTheBoundaryAndWithinTheTolerance) {
  const FreeMesh mesh(SpaceOf(Sketch({"...",  //
                                      ".a.",  //
                                      "..."})));
  EXPECT_TRUE(mesh.Locate({1, 1}, 0));
  EXPECT_TRUE(mesh.Locate({1.3, 1}, 0));
  EXPECT_FALSE(mesh.Locate({1.3, 1.001}, 0));
  EXPECT_FALSE(mesh.Locate({1.3, 1.001}, 0.0009));
  EXPECT_FALSE(mesh.Locate({100, 100}, 0.001));
  const auto moved = mesh.Locate({1.3, 1.001}, 0.0011);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(Distance(moved->point, {1.3, 1}), 0, 1e-12);
  EXPECT_TRUE(Holds(mesh, *moved));
  const auto onto_corner = mesh.Locate({1.0003, 1.0003}, 0.0011);
  ASSERT_TRUE(onto_corner);
  EXPECT_EQ(onto_corner->point, (Point{1, 1}));
}

TEST(FreeMesh, LeftOfFindsTheTriangleOfAnEdge) {
  const FreeMesh mesh(SpaceOf(Sketch({"...",  //
                                      ".a.",  //
                                      "..."})));
  for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
    const Triangle& triangle = mesh.triangle(TriangleId(t));
    EXPECT_EQ(mesh.LeftOf(triangle.vertices[0], triangle.vertices[1]), TriangleId(t));
  }
}

class FreeMeshRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, FreeMeshRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(FreeMeshRandom, HasTheAreaAndTheVerticesOfTheFreeSpace) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    double area = 0;
    for (const FreeComponent& component : scene.space.components) area += component.area;
    ASSERT_NEAR(FreeArea(mesh), area, 1e-9 * area);
    const std::size_t input = mesh.triangulation().points().size() - 4;
    for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
      if (!mesh.IsFree(TriangleId(t))) continue;
      for (const VertexId vertex : mesh.triangle(TriangleId(t)).vertices) ASSERT_LT(vertex.index(), input);
    }
  }
}

TEST_P(FreeMeshRandom, LocatesWhatIsFreeAndNothingElse) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    for (int i = 0; i < 30; ++i) {
      const Point p = random_scene::RandomPlace(rng, scene);
      const bool is_free = !BruteSight(scene.rings, std::vector{p}).NodesAt(p).empty();
      const auto place = mesh.Locate(p, 0);
      ASSERT_EQ(place.has_value(), is_free) << p.x << ' ' << p.y;
      if (!place) continue;
      ASSERT_EQ(place->point, p);
      ASSERT_TRUE(Holds(mesh, *place));
    }
  }
}

TEST_P(FreeMeshRandom, FindsTheVerticesNearASegment) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const FreeMesh mesh(scene.space);
    const Point a = random_scene::RandomPlace(rng, scene), b = random_scene::RandomPlace(rng, scene);
    const double tolerance = rng.Uniform(0, 1);
    std::vector<Point> expected;
    for (const Ring& ring : scene.rings) {
      std::copy_if(ring.begin(), ring.end(), std::back_inserter(expected),
                   [&](Point p) { return DistanceToSegment(p, a, b) <= tolerance; });
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    std::vector<Point> found;
    for (const VertexId vertex : mesh.VerticesNear(a, b, tolerance)) found.push_back(mesh.point(vertex));
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end(),
                               [&](Point p, Point q) { return Dot(p - a, b - a) < Dot(q - a, b - a); }));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace tautline
