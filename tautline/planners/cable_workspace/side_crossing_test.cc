#include "tautline/planners/cable_workspace/side_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/cable_workspace/random_cables.h"
#include "tautline/planners/cable_workspace/word_crossing.h"

namespace tautline {
namespace {

class SideCrossingRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, SideCrossingRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// A walk between two anchors of a scene.
struct Side {
  std::size_t from;
  std::size_t to;
  Walk walk;
};

/// All walks from an anchor to a later one along the laid cables.
std::vector<Side> SidesOf(const RandomCables& cables) {
  std::vector<Side> sides;
  for (std::size_t from = 0; from < cables.anchors.size(); ++from) {
    for (std::size_t to = from + 1; to < cables.anchors.size(); ++to) {
      sides.push_back({from, to, WalkByCables(cables, from, to)});
    }
  }
  return sides;
}

bool IsRectangle(const Ring& outline) { return outline.size() == 4; }

bool OnRectangle(Point p, const Box& box) {
  return p.x == box.low.x || p.x == box.high.x || p.y == box.low.y || p.y == box.high.y;
}

TEST_P(SideCrossingRandom, AgreesWithTheWordsInARectangle) {
  std::int64_t compared = 0, crossing = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(1500); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    const Box box = BoundingBox(cables.scene.world.outline);
    const bool on_rectangle = std::all_of(cables.anchors.begin(), cables.anchors.end(),
                                          [&box](const Socket& anchor) { return OnRectangle(anchor.base, box); });
    if (!IsRectangle(cables.scene.world.outline) || !on_rectangle) continue;
    const WordCrossing oracle(box, cables.scene.representatives);
    ClassOracle reader({}, cables.scene.representatives, {});
    const auto curve = [&](const Side& side) {
      const int word = reader.AppendPolyline(0, LaidBetween(cables, side.from, side.to));
      return WordCrossing::Curve{cables.points[side.from], cables.points[side.to], reader.words().ToWord(word)};
    };
    const auto sides = SidesOf(cables);
    for (const Side& a : sides) {
      for (const Side& b : sides) {
        const bool expected = oracle.Cross(curve(a), curve(b));
        EXPECT_EQ(CablesCross(cables.ground.space(), a.walk, b.walk), expected)
            << "seed " << seed << ", sides " << a.from << "-" << a.to << " and " << b.from << "-" << b.to;
        ++compared;
        crossing += expected ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, ScaledTestCount(5'000));
  EXPECT_GT(crossing, compared / 20);
  EXPECT_LT(crossing, compared - compared / 20);
}

/// Whether curves meet nowhere but in the insides of segments, and at ends that both have.
bool InGeneralPosition(const Polyline& a, const Polyline& b) {
  const auto meets = [](const Polyline& one, const Polyline& other) {
    for (const Point p : one) {
      for (std::size_t i = 0; i + 1 < other.size(); ++i) {
        const bool both_end = (p == one.front() || p == one.back()) &&
                              ((i == 0 && p == other.front()) || (i + 2 == other.size() && p == other.back()));
        // An end beside a slanted wall is off it by rounding.
        if (!both_end && DistanceToSegment(p, other[i], other[i + 1]) < 1e-9) return true;
      }
    }
    return false;
  };
  return !meets(a, b) && !meets(b, a);
}

/// Whether segments cross by more than the rounding of ends beside slanted walls.
bool CrossClearly(Point a, Point b, Point c, Point d) {
  const double least = std::min(
      {DistanceToSegment(a, c, d), DistanceToSegment(b, c, d), DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)});
  return least > 1e-9 && CrossProperly(a, b, c, d);
}

bool CrossSomewhere(const Polyline& a, const Polyline& b) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      if (CrossClearly(a[i], a[i + 1], b[k], b[k + 1])) return true;
    }
  }
  return false;
}

// Two taut curves in the cover cross at most once, so that no crossing of segments can be undone.
TEST_P(SideCrossingRandom, AgreesWithSegmentsInGeneralPosition) {
  std::int64_t apart = 0, crossing = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(1500); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    const TautSpace& space = cables.ground.space();
    const auto sides = SidesOf(cables);
    std::vector<Polyline> taut;
    for (const Side& side : sides) taut.push_back(space.Pull(side.walk).points);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const bool cross = CrossSomewhere(taut[i], taut[k]);
        const bool found = CablesCross(space, sides[i].walk, sides[k].walk);
        // What crosses properly crosses, whatever else the two share.
        if (cross) {
          EXPECT_TRUE(found) << "seed " << seed << ", sides " << i << " and " << k;
        } else if (InGeneralPosition(taut[i], taut[k])) {
          EXPECT_FALSE(found) << "seed " << seed << ", sides " << i << " and " << k;
          ++apart;
        }
        crossing += cross ? 1 : 0;
      }
      if (CrossSomewhere(taut[i], taut[i])) {
        EXPECT_TRUE(CablesCross(space, sides[i].walk, sides[i].walk)) << "seed " << seed << ", side " << i;
      }
    }
  }
  EXPECT_GT(apart, ScaledTestCount(1500));
  EXPECT_GT(crossing, ScaledTestCount(1500));
}

TEST_P(SideCrossingRandom, IsSymmetricAndDoesNotMindTheDirection) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(400); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    const TautSpace& space = cables.ground.space();
    const auto sides = SidesOf(cables);
    for (const Side& a : sides) {
      for (const Side& b : sides) {
        const bool cross = CablesCross(space, a.walk, b.walk);
        EXPECT_EQ(CablesCross(space, b.walk, a.walk), cross) << "seed " << seed;
        EXPECT_EQ(CablesCross(space, Reversed(a.walk), b.walk), cross) << "seed " << seed;
        EXPECT_EQ(CablesCross(space, a.walk, Reversed(b.walk)), cross) << "seed " << seed;
      }
    }
  }
}

/// The walk from one anchor to another along a polyline.
std::optional<Walk> WalkAlong(const CableGround& ground, const Socket& from, const Socket& to, Polyline points) {
  std::optional<Walk> walk(from.exit);
  walk->rooted = true;
  points.back() = to.exit.point;
  if (ground.space().Follow(points, walk)) return std::nullopt;
  TAUTLINE_CHECK(TurnInto(ground.space().mesh(), to.exit.triangle, *walk));
  return walk;
}

/// Expects the crossings of the same cables in a changed world. False when they cannot be laid there.
bool ExpectSameCrossings(const RandomCables& cables, const World& world, Point (*change)(Point), std::int64_t seed) {
  const CableGround ground = CableGround::Prepare(world).value();
  std::vector<Point> points;
  for (const Point p : cables.points) points.push_back(change(p));
  const auto anchors = PlaceAnchors(ground, points);
  if (!anchors) return false;
  const auto sides = SidesOf(cables);
  std::vector<Walk> changed;
  for (const Side& side : sides) {
    Polyline laid = LaidBetween(cables, side.from, side.to);
    for (Point& p : laid) p = change(p);
    const auto walk = WalkAlong(ground, (*anchors)[side.from], (*anchors)[side.to], laid);
    if (!walk) return false;
    changed.push_back(*walk);
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      EXPECT_EQ(CablesCross(ground.space(), changed[i], changed[k]),
                CablesCross(cables.ground.space(), sides[i].walk, sides[k].walk))
          << "seed " << seed << ", sides " << i << " and " << k;
    }
  }
  return true;
}

TEST_P(SideCrossingRandom, IsTheSameInAMirror) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    const auto mirror = [](Point p) { return Point{16 - p.x, p.y}; };
    const World world = MappedWorld(cables.scene.world, mirror);
    EXPECT_TRUE(ExpectSameCrossings(cables, world, mirror, seed)) << "seed " << seed;
  }
}

// Corners of walls are rounded to a grid, so that anchors at them are off them by rounding.
TEST_P(SideCrossingRandom, IsTheSameInAnotherUnit) {
  std::int64_t compared = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    const auto scale = [](Point p) { return 0.1 * p; };
    const World world = MappedWorld(cables.scene.world, scale);
    compared += ExpectSameCrossings(cables, world, scale, seed) ? 1 : 0;
  }
  // What touches in points may come to overlap.
  EXPECT_GE(compared, ScaledTestCount(300) * 9 / 10);
}

// A speck on a wall, out of the way of what is laid, changes the triangles everywhere around it.
TEST_P(SideCrossingRandom, IsTheSameInAnotherTriangulation) {
  std::int64_t changed = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomCables cables = MakeRandomCables(rng, GetParam());
    World world = cables.scene.world;
    // A speck outside of all that is laid, against a wall, so that no word knows of it.
    const Point a = world.outline[0], b = world.outline[1], middle = Lerp(a, b, 0.375);
    const double inward = SignedArea(world.outline) > 0 ? 0x1p-8 : -0x1p-8;
    const Point apex = middle + inward * Point{a.y - b.y, b.x - a.x};
    const Ring speck{middle - 0x1p-8 * (b - a), middle + 0x1p-8 * (b - a), apex};
    bool is_clear = true;
    for (const Polyline& laid : cables.laid) {
      for (std::size_t i = 0; i + 1 < laid.size(); ++i) {
        for (const Point p : speck) is_clear = is_clear && DistanceToSegment(p, laid[i], laid[i + 1]) > 0.2;
      }
    }
    for (const Ring& ring : cables.scene.rings) {
      for (const Point p : ring) is_clear = is_clear && Distance(p, apex) > 0.2;
    }
    if (!is_clear) continue;
    world.obstacles.push_back(random_scene::PolygonObstacle(world, speck));
    changed += ExpectSameCrossings(
                   cables, world, [](Point p) { return p; }, seed)
                   ? 1
                   : 0;
  }
  EXPECT_GT(changed, ScaledTestCount(300) / 20);
}

}  // namespace
}  // namespace tautline
