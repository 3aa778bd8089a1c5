#include "tautline/cable/strand.h"

#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {
namespace {

/// A random walk in a random scene, and its strand.
struct RandomStrand {
  Place first, second;
  Strand strand;
};

std::optional<RandomStrand> MakeRandomStrand(Rng& rng, const RandomScene& scene, const TautSpace& space) {
  const std::vector<Point> ends{RandomFreePoint(rng, scene), RandomFreePoint(rng, scene)};
  const ClassOracle oracle(scene.rings, scene.representatives, ends);
  const auto way = RandomWalk(rng, oracle, oracle.sight().NodesAt(ends[0])[0], oracle.sight().NodesAt(ends[1])[0]);
  std::optional<Walk> walk;
  if (!way || space.Follow(*way, walk)) return std::nullopt;
  const Place first{walk->from, walk->sleeve.front()}, second{walk->at, walk->sleeve.back()};
  return RandomStrand{first, second, StrandOf(*walk, PullTaut(space.mesh(), *walk))};
}

void ExpectInTriangle(const FreeMesh& mesh, const Place& place) {
  for (int i = 0; i < 3; ++i) {
    const Point a = mesh.point(mesh.triangle(place.triangle).vertex(i));
    const Point b = mesh.point(mesh.triangle(place.triangle).vertex(Next(i)));
    EXPECT_GE(Orientation(a, b, place.point), 0);
  }
}

TEST(Strand, CutsIntoPiecesOfTheSameCurve) {
  std::int64_t bent = 0;
  const std::int64_t trials = ScaledTestCount(400);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    const auto made = MakeRandomStrand(rng, scene, space);
    if (!made) continue;
    const Strand& whole = made->strand;
    if (whole.bends.size() >= 2) ++bent;
    Strand again = whole;
    PullTight(space.mesh(), made->first.point, made->second.point, again);
    EXPECT_EQ(again.length, whole.length);
    EXPECT_EQ(again.bends.size(), whole.bends.size());
    // From either end, by random lengths: what is left and what was passed add up, and join to the whole.
    Place first = made->first, second = made->second;
    Strand rest = whole, before(first.triangle), after(second.triangle);
    double from_first = 0, from_second = 0;
    while (rest.length > 1e-3) {
      const double by = rng.Uniform(0, 1) * std::min(rest.length, 2.0);
      const bool at_first = rng.UniformInt(0, 1) == 0;
      const double length = rest.length;
      if (at_first) {
        SlideFirst(space.mesh(), first, second, by, rest, &before);
        from_first += by;
      } else {
        SlideSecond(space.mesh(), first, second, by, rest, &after);
        from_second += by;
      }
      ExpectInTriangle(space.mesh(), first);
      ExpectInTriangle(space.mesh(), second);
      EXPECT_NEAR(rest.length, length - by, 1e-9);
      PullTight(space.mesh(), made->first.point, first.point, before);
      PullTight(space.mesh(), second.point, made->second.point, after);
      EXPECT_NEAR(before.length, from_first, 1e-9);
      EXPECT_NEAR(after.length, from_second, 1e-9);
      Strand joined = before;
      Join(joined, rest);
      Join(joined, after);
      EXPECT_EQ(joined.sleeve, whole.sleeve);
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(bent, trials / 20);
}

TEST(StrandCursor, GoesOnWhereItStands) {
  const std::int64_t trials = ScaledTestCount(400);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    const auto made = MakeRandomStrand(rng, scene, space);
    if (!made) continue;
    StrandCursor cursor(space.mesh(), made->first, made->second, made->strand);
    for (double s = 0; s < made->strand.length; s += 0.1) {
      cursor.MoveTo(s);
      StrandCursor fresh(space.mesh(), made->first, made->second, made->strand);
      fresh.MoveTo(s);
      EXPECT_NEAR(Distance(cursor.place().point, fresh.place().point), 0, 1e-9) << s;
      Strand passed(made->first.triangle);
      for (std::size_t k = 0; k <= cursor.position(); ++k) passed.StepSecond(made->strand.sleeve[k]);
      PullTight(space.mesh(), made->first.point, cursor.place().point, passed);
      EXPECT_NEAR(passed.length, s, 1e-9);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(MoveInto, PutsAPointIntoItsTriangle) {
  Rng rng(1);
  const RandomScene scene = MakeRandomScene(rng, false);
  const FreeMesh mesh(scene.space);
  for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
    const TriangleId id(t);
    const Point a = mesh.point(mesh.triangle(id).vertex(0)), b = mesh.point(mesh.triangle(id).vertex(1));
    for (int i = 0; i < 20; ++i) {
      const Point on_side = Lerp(a, b, rng.Uniform());
      const Place place{MoveInto(mesh, id, on_side), id};
      ExpectInTriangle(mesh, place);
      EXPECT_NEAR(Distance(place.point, on_side), 0, 1e-9);
    }
    EXPECT_EQ(MoveInto(mesh, id, a), a) << "what is inside stays";
  }
}

}  // namespace
}  // namespace tautline
