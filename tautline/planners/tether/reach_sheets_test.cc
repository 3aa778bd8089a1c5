#include "tautline/planners/tether/reach_sheets.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/random_reach.h"
#include "tautline/planners/tether/reach_plane.h"

namespace tautline {
namespace {

constexpr double kPi = std::numbers::pi;

/// Chords of arcs stand back from them by less than this, metres.
constexpr double kChordError = 1e-3;

SheetList SheetsOf(const TautSpace& space, Point base, double length, std::int64_t budget = 2'000) {
  return ReachSheets(space, {.root = *space.Locate(base), .prefix = {}, .length = length, .budget = budget});
}

double PlaneArea(const TautSpace& space, Point base, double length) {
  return AreaOf(ReachPlane(space, *space.Locate(base), length));
}

TautSpace SpaceOfWorld(const World& world) { return TautSpace(BuildFreeSpace(world).value()); }

/// A square barn with side 4 in a wide field; its ray goes up from (1, 1).
World Barn() {
  World world;
  world.outline = Rectangle({-50, -50}, {50, 50});
  world.obstacles = {{.name = "barn",
                      .polygon = PolygonWithHoles{Rectangle({0, 0}, {4, 4}), {}},
                      .circle = {},
                      .representative = Point{1, 1}}};
  return world;
}

TEST(ReachSheets, TheGoatCountsBothWaysAroundTheBarn) {
  const TautSpace space = SpaceOfWorld(Barn());
  // Three quarters about the own corner, then a quarter about each next corner, both ways round, for ever shorter.
  const SheetList list = SheetsOf(space, {0, 0}, 14);
  EXPECT_NEAR(list.area, 0.75 * kPi * 14 * 14 + 0.5 * kPi * (10 * 10 + 6 * 6 + 2 * 2), 1e-10);
  EXPECT_TRUE(list.complete);
  EXPECT_EQ(list.walks, 7);
}

TEST(ReachSheets, ARayCutsOneClassFromTheNext) {
  const TautSpace space = SpaceOfWorld(Barn());
  // From the left, over the barn: what lies right of x = 1 there has the word "barn".
  const SheetList list = SheetsOf(space, {0, 6}, 3);
  ASSERT_EQ(list.sheets.size(), 2u);
  EXPECT_TRUE(list.sheets[0].word.empty());
  EXPECT_EQ(ToString(list.sheets[1].word, space.rays().names()), "barn");
  EXPECT_NEAR(list.area, PlaneArea(space, {0, 6}, 3), 1e-12);
  // Of the disc about (0, 6), the part right of x = 1 and above y = 4.
  const auto strip = [](double x) { return 0.5 * (x * std::sqrt(9 - x * x) + 9 * std::asin(x / 3)); };
  // Above the base all that is within the circle; below it no more than 2 m, which is all right of x = sqrt(5).
  const double above = strip(3) - strip(1), right = strip(3) - strip(std::sqrt(5)), below = 2 * (std::sqrt(5) - 1);
  EXPECT_NEAR(list.sheets[1].area, above + right + below, 1e-12);
}

TEST(ReachSheets, TheBudgetEndsTheCountAndSaysHowFarItCame) {
  const TautSpace space = SpaceOfWorld(Barn());
  const SheetList all = SheetsOf(space, {-1, -2}, 60), some = SheetsOf(space, {-1, -2}, 60, 10);
  EXPECT_TRUE(all.complete);
  EXPECT_FALSE(some.complete);
  EXPECT_EQ(some.walks, 10);
  EXPECT_LT(some.area, all.area);
  EXPECT_LT(some.classes, all.classes);
  EXPECT_EQ(all.classes, static_cast<std::int64_t>(all.sheets.size()));
  EXPECT_TRUE(some.sheets.empty());
  // As many walks as are shorter than what it says.
  EXPECT_EQ(SheetsOf(space, {-1, -2}, some.counted_to).walks, 10);
}

class ReachSheetsRandom : public testing::TestWithParam<bool> {
 protected:
  /// Lengths are cut down so that no question has too many classes for the oracle.
  template <class Check>
  void ForEach(std::int64_t count, int samples, Check check) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE(seed);
      Rng rng(static_cast<std::uint64_t>(seed));
      RandomReach question = MakeRandomReach(rng, GetParam(), false, samples);
      const TautSpace space(question.ground.space);
      SheetList list = SheetsOf(space, question.base, question.length);
      for (; !list.complete; list = SheetsOf(space, question.base, question.length)) question.length *= 0.8;
      ASSERT_NO_FATAL_FAILURE(check(question, space, list));
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, ReachSheetsRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// The words of the sheets that hold a point.
std::multiset<Word> WordsAt(const SheetList& list, Point p) {
  std::multiset<Word> words;
  for (const Sheet& sheet : list.sheets) {
    const int number = WindingAround(sheet.rings, p);
    EXPECT_GE(number, 0);
    for (int i = 0; i < number; ++i) words.insert(sheet.word);
  }
  return words;
}

/// Whether p is too near to a ray or to the end of a class to tell.
bool IsOnAnEdge(const RandomReach& question, const std::vector<OracleClass>& classes, Point p) {
  for (const Point foot : question.ground.representatives) {
    if (std::fabs(foot.x - p.x) < kChordError) return true;
  }
  for (const OracleClass& c : classes) {
    if (std::fabs(c.length - question.length) < kChordError) return true;
  }
  return false;
}

TEST_P(ReachSheetsRandom, HoldTheClassesOfTheOracle) {
  std::int64_t compared = 0;
  ForEach(150, 15, [&](RandomReach& question, const TautSpace&, const SheetList& list) {
    for (const Point p : question.samples) {
      if (question.NodesAt(p).empty()) continue;
      const auto classes = question.oracle.Classes(question.base, p, question.length + kChordError);
      if (!classes || IsOnAnEdge(question, *classes, p)) continue;
      std::multiset<Word> expected;
      for (const OracleClass& c : *classes) expected.insert(c.word);
      ASSERT_EQ(WordsAt(list, p), expected) << p.x << ' ' << p.y;
      ++compared;
    }
  });
  EXPECT_GT(compared, ScaledTestCount(150));
}

TEST_P(ReachSheetsRandom, HoldTheClassesOfTheEngine) {
  ForEach(300, 30, [](const RandomReach& question, const TautSpace& space, const SheetList& list) {
    for (const Point p : question.samples) {
      const auto place = space.mesh().Locate(p, 0);
      if (!place) continue;
      std::multiset<Word> expected;
      bool near = IsOnAnEdge(question, {}, p);
      const auto classes =
          FindClasses(space, question.base, p, {.max_length = question.length + kChordError, .max_count = {}});
      for (const TautPath& path : classes.classes) {
        near = near || path.length > question.length - kChordError;
        expected.insert(path.word);
      }
      if (!near) {
        ASSERT_EQ(WordsAt(list, p), expected) << p.x << ' ' << p.y;
      }
    }
  });
}

TEST_P(ReachSheetsRandom, AreasAgreeWithTheirRingsAndSum) {
  ForEach(400, 0, [](const RandomReach& question, const TautSpace& space, const SheetList& list) {
    double sum = 0;
    std::set<Word> words;
    for (const Sheet& sheet : list.sheets) {
      ASSERT_NEAR(AreaOf(sheet.rings), sheet.area, 1e-6);
      ASSERT_TRUE(words.insert(sheet.word).second);
      sum += sheet.area;
    }
    ASSERT_NEAR(sum, list.area, 1e-6);
    const double plane = PlaneArea(space, question.base, question.length);
    ASSERT_GE(list.area, plane - 1e-6);
    if (space.free_space().islands.empty()) {
      ASSERT_NEAR(list.area, plane, 1e-6);
      ASSERT_EQ(list.sheets.size(), 1u);
    }
  });
}

TEST(ReachSheets, ABaseWhereBlockedGroundTouchesLeavesByAllSectors) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomReach question = MakeRandomReach(rng, true, true, 0);
    const TautSpace space(question.ground.space);
    const SheetList list = SheetsOf(space, question.base, question.length);
    if (!list.complete) continue;
    for (const Sheet& sheet : list.sheets) ASSERT_NEAR(AreaOf(sheet.rings), sheet.area, 1e-6);
    ASSERT_GE(list.area, PlaneArea(space, question.base, question.length) - 1e-6);
  }
}

TEST_P(ReachSheetsRandom, GrowWithTheTether) {
  ForEach(100, 0, [](const RandomReach& question, const TautSpace& space, const SheetList& list) {
    const SheetList less = SheetsOf(space, question.base, 0.8 * question.length);
    ASSERT_LE(less.area, list.area + 1e-7);
    ASSERT_LE(less.sheets.size(), list.sheets.size());
    ASSERT_LE(less.walks, list.walks);
  });
}

/// Whether a blocked segment meets no boundary.
bool StaysInside(const std::vector<Ring>& rings, Point a, Point b) {
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = ring[i], q = ring[(i + 1) % ring.size()];
      if (CrossProperly(a, b, p, q) || DistanceToSegment(b, p, q) < 1e-3 || DistanceToSegment(p, a, b) < 1e-3)
        return false;
    }
  }
  return true;
}

TEST(ReachSheets, RaysAlongWallsAndARoundingErrorBesideThem) {
  std::int64_t moved = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(400); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    RandomReach question = MakeRandomReach(rng, true, false, 0);
    for (Island& island : question.ground.space.islands) {
      Point foot = island.representative;
      foot.x = std::round(foot.x) + (rng.UniformInt(0, 1) == 0 ? 0 : rng.UniformInt(0, 1) == 0 ? 1 : -1);
      if (!StaysInside(question.ground.rings, island.representative, foot)) continue;
      const int ulps = rng.UniformInt(-1, 1);
      if (ulps != 0) foot.x = std::nextafter(foot.x, ulps > 0 ? 1e300 : -1e300);
      island.representative = foot;
      ++moved;
    }
    const TautSpace space(question.ground.space);
    const SheetList list = SheetsOf(space, question.base, question.length);
    if (!list.complete) continue;
    for (const Sheet& sheet : list.sheets) ASSERT_NEAR(AreaOf(sheet.rings), sheet.area, 1e-6);
  }
  EXPECT_GT(moved, ScaledTestCount(50));
}

/// Whether left and right of a ray are not alike: a ray through the base, or two rays in one column.
bool MeetsAColumn(const RandomReach& question) {
  std::set<double> columns{question.base.x};
  for (const Point foot : question.ground.representatives) {
    if (!columns.insert(foot.x).second) return true;
  }
  return false;
}

Word Mirrored(const Word& word) {
  Word mirrored;
  for (const Letter letter : word.letters()) mirrored.Append({letter.obstacle, !letter.inverse});
  return mirrored;
}

TEST_P(ReachSheetsRandom, AreMirroredInAMirroredScene) {
  ForEach(150, 0, [](const RandomReach& question, const TautSpace&, const SheetList& list) {
    FreeSpace mirror = question.ground.space;
    const auto flip = [](BoundaryRing& ring) {
      for (Point& p : ring.points) p.x = -p.x;
      std::reverse(ring.points.begin(), ring.points.end());
    };
    for (FreeComponent& component : mirror.components) {
      flip(component.outer);
      for (BoundaryRing& hole : component.holes) flip(hole);
    }
    for (Island& island : mirror.islands) island.representative.x = -island.representative.x;
    mirror.box = {{-mirror.box.high.x, mirror.box.low.y}, {-mirror.box.low.x, mirror.box.high.y}};
    const SheetList other = SheetsOf(TautSpace(mirror), {-question.base.x, question.base.y}, question.length);
    ASSERT_EQ(other.walks, list.walks);
    ASSERT_NEAR(other.area, list.area, 1e-6);
    if (MeetsAColumn(question)) return;
    ASSERT_EQ(other.sheets.size(), list.sheets.size());
    for (const Sheet& sheet : list.sheets) {
      const auto twin = std::find_if(other.sheets.begin(), other.sheets.end(),
                                     [&](const Sheet& s) { return s.word == Mirrored(sheet.word); });
      ASSERT_NE(twin, other.sheets.end());
      ASSERT_NEAR(twin->area, sheet.area, 1e-6);
    }
  });
}

}  // namespace
}  // namespace tautline
