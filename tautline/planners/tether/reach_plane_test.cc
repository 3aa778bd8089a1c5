#include "tautline/planners/tether/reach_plane.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/tether/disc_area.h"
#include "tautline/planners/tether/random_reach.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

/// Chords of arcs stand back from them by less than this, metres.
constexpr double kChordError = 1e-3;

double PlaneArea(const TautSpace& space, Point base, double length) {
  return AreaOf(ReachPlane(space, *space.Locate(base), length));
}

TautSpace SpaceOfWorld(const World& world) { return TautSpace(BuildFreeSpace(world).value()); }

/// A square barn with side 4 in a wide field.
World Barn() {
  World world;
  world.outline = Rectangle({-50, -50}, {50, 50});
  world.obstacles = {
      {.name = "barn", .polygon = PolygonWithHoles{Rectangle({0, 0}, {4, 4}), {}}, .circle = {}, .representative = {}}};
  return world;
}

TEST(ReachPlane, TheGoatAtTheCornerOfTheBarn) {
  const TautSpace space = SpaceOfWorld(Barn());
  EXPECT_NEAR(PlaneArea(space, {0, 0}, 3), 0.75 * kPi * 9, 1e-12);
  EXPECT_NEAR(PlaneArea(space, {0, 0}, 7), 0.75 * kPi * 49 + 0.5 * kPi * 9, 1e-11);
}

TEST(ReachPlane, TheGoatInTheMiddleOfAWall) {
  const TautSpace space = SpaceOfWorld(Barn());
  EXPECT_NEAR(PlaneArea(space, {2, 0}, 5), 0.5 * kPi * 25 + 0.5 * kPi * 9, 1e-11);
  // Around both corners to the back, where the two quarter circles about the far corners would meet at 8.
  EXPECT_NEAR(PlaneArea(space, {2, 0}, 7.5), 0.5 * kPi * (7.5 * 7.5 + 5.5 * 5.5 + 1.5 * 1.5), 1e-11);
}

TEST(ReachPlane, TheTwoWaysAroundTheBarnOverlap) {
  const TautSpace space = SpaceOfWorld(Barn());
  // Behind the barn, two quarter discs of radius 3 about (0, 4) and (4, 4) share a half lens: twice the half segment
  // of height 1.
  const double half_segment = 0.5 * (9 * std::acos(2.0 / 3) - 2 * std::sqrt(5));
  EXPECT_NEAR(PlaneArea(space, {2, 0}, 9), 0.5 * kPi * (81 + 49 + 9) - 2 * half_segment, 1e-11);
}

TEST(ReachPlane, ZeroLengthReachesNothing) {
  const TautSpace space = SpaceOfWorld(Barn());
  EXPECT_TRUE(ReachPlane(space, *space.Locate({-1, -1}), 0).empty());
}

TEST(ReachPlane, InAConvexRoomItIsADiscClippedByTheWalls) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    World world;
    const int corners = rng.UniformInt(3, 9);
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * kPi * (i + rng.Uniform(0, 0.9)) / corners;
      world.outline.push_back({5 * std::cos(angle), 4 * std::sin(angle)});
    }
    const auto built = BuildFreeSpace(world);
    if (!built) continue;
    const TautSpace space(*built);
    const Point base{rng.Uniform(-4, 4), rng.Uniform(-3, 3)};
    if (!space.mesh().Locate(base, 0)) continue;
    const double length = rng.Uniform(0.1, 11);
    const double expected = AreaInDisc(space.free_space().components[0].outer.points, {base, length});
    ASSERT_NEAR(PlaneArea(space, base, length), expected, 1e-7 * length);
  }
}

class ReachPlaneRandom : public testing::TestWithParam<bool> {
 protected:
  template <class Check>
  void ForEach(std::int64_t count, int samples, Check check) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE(seed);
      Rng rng(static_cast<std::uint64_t>(seed));
      RandomReach question = MakeRandomReach(rng, GetParam(), true, samples);
      const TautSpace space(question.ground.space);
      ASSERT_NO_FATAL_FAILURE(check(question, space, rng));
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, ReachPlaneRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(ReachPlaneRandom, HoldsWhatTheOracleReaches) {
  ForEach(400, 40, [](const RandomReach& question, const TautSpace& space, Rng&) {
    const auto rings = ReachPlane(space, *space.Locate(question.base), question.length);
    const std::vector<double> distances = question.DistancesOf(question.samples);
    for (std::size_t i = 0; i < question.samples.size(); ++i) {
      if (std::fabs(distances[i] - question.length) < kChordError) continue;
      ASSERT_EQ(WindingAround(rings, question.samples[i]), distances[i] < question.length ? 1 : 0)
          << question.samples[i].x << ' ' << question.samples[i].y << " at " << distances[i];
    }
  });
}

TEST_P(ReachPlaneRandom, ItsAreaIsThatOfItsRings) {
  ForEach(300, 0, [](const RandomReach& question, const TautSpace& space, Rng&) {
    double area = 0;
    const auto rings = ReachPlane(space, *space.Locate(question.base), question.length);
    for (const RegionRing& ring : rings) area += SignedArea(Polygonised(ring, 1e-4));
    ASSERT_NEAR(AreaOf(rings), area, 1e-6);
  });
}

TEST_P(ReachPlaneRandom, EndsWhereTheTetherDoesOrAtAWall) {
  ForEach(150, 0, [](const RandomReach& question, const TautSpace& space, Rng&) {
    std::vector<Point> arcs;
    for (const RegionRing& ring : ReachPlane(space, *space.Locate(question.base), question.length)) {
      for (std::size_t i = 0; i < ring.pieces.size(); ++i) {
        const RegionPiece& piece = ring.pieces[i];
        ASSERT_EQ(piece.to, ring.pieces[(i + 1) % ring.pieces.size()].from);
        if (piece.is_arc()) {
          ASSERT_NEAR(Distance(piece.centre, piece.from), piece.radius, 1e-7);
          ASSERT_NEAR(Distance(piece.centre, piece.to), piece.radius, 1e-7);
          if (Length(piece) > 1e-3) arcs.push_back(Middle(piece));
          continue;
        }
        double gap = 1;
        for (const Ring& wall : question.ground.rings) {
          for (std::size_t k = 0; k < wall.size(); ++k) {
            gap = std::min(gap, DistanceToSegment(Middle(piece), wall[k], wall[(k + 1) % wall.size()]));
          }
        }
        ASSERT_LT(gap, 1e-7);
      }
    }
    if (arcs.size() > 30) arcs.resize(30);
    std::vector<Point> looked = arcs;
    looked.push_back(question.base);
    const RandomReach again{question.ground, question.base, question.length, arcs,
                            ClassOracle(question.ground.rings, question.ground.representatives, looked)};
    for (const double distance : again.DistancesOf(arcs)) ASSERT_NEAR(distance, question.length, 1e-6);
  });
}

TEST_P(ReachPlaneRandom, GrowsWithTheTether) {
  ForEach(100, 0, [](const RandomReach& question, const TautSpace& space, Rng& rng) {
    double last = 0;
    for (double length = 0; length < 30; length += rng.Uniform(0, 3)) {
      const double area = PlaneArea(space, question.base, length);
      ASSERT_GE(area, last - 1e-7);
      last = area;
    }
  });
}

TEST_P(ReachPlaneRandom, IsTheSameInAMirroredTurnedAndScaledScene) {
  ForEach(100, 0, [](const RandomReach& question, const TautSpace& space, Rng& rng) {
    const double area = PlaneArea(space, question.base, question.length);
    const double scale = std::exp2(rng.UniformInt(-8, 8));
    const auto moved = [&](auto map, double by) {
      World world = question.ground.world;
      for (Point& p : world.outline) p = map(p);
      for (Obstacle& obstacle : world.obstacles) {
        for (Point& p : obstacle.polygon->outer) p = map(p);
      }
      world.snap *= by;
      const TautSpace other = SpaceOfWorld(world);
      return PlaneArea(other, map(question.base), by * question.length) / (by * by);
    };
    ASSERT_NEAR(moved([](Point p) { return Point{-p.x, p.y}; }, 1), area, 1e-6);
    ASSERT_NEAR(moved([](Point p) { return Point{-p.y, p.x}; }, 1), area, 1e-6);
    ASSERT_NEAR(moved([scale](Point p) { return scale * p; }, scale), area, 1e-6);
  });
}

}  // namespace
}  // namespace tautline
