#include "tautline/homotopy/taut_space.h"

#include <gtest/gtest.h>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

SketchedScene TwoBlocks() {
  return Sketch({"C......D",  //
                 "..a..b..",  //
                 "A.a..b.B",  //
                 "..a..b..",  //
                 "E......F"});
}

std::string WordOf(const TautSpace& space, const Shortened& shortened) {
  return ToString(shortened.path.word, space.rays().names());
}

TEST(Shorten, GivesPointsLengthAndWord) {
  const auto scene = TwoBlocks();
  const TautSpace space(SpaceOf(scene));
  const Shortened shortened =
      Shorten(space, Polyline{scene['A'], scene['C'], {4, 4.5}, {4, 0.5}, scene['F'], scene['B']});
  ASSERT_FALSE(shortened.departure);
  EXPECT_EQ(shortened.path.points, (Polyline{scene['A'], {2, 4}, {3, 4}, {5, 1}, {6, 1}, scene['B']}));
  EXPECT_NEAR(shortened.path.length, 2 * std::hypot(1.5, 1.5) + 2 + std::hypot(2, 3), 1e-12);
  EXPECT_EQ(WordOf(space, shortened), "a");
}

TEST(Shorten, KeepsAPointAPoint) {
  const auto scene = TwoBlocks();
  const TautSpace space(SpaceOf(scene));
  for (const Polyline& polyline :
       {Polyline{scene['A']}, {scene['A'], scene['A']}, {scene['A'], scene['C'], scene['A']}}) {
    const Shortened shortened = Shorten(space, polyline);
    EXPECT_EQ(shortened.path.points, (Polyline{scene['A']}));
    EXPECT_EQ(shortened.path.length, 0);
    EXPECT_TRUE(shortened.path.word.empty());
  }
}

TEST(Shorten, SaysWhereThePolylineLeavesTheFreeSpace) {
  const auto scene = TwoBlocks();
  const TautSpace space(SpaceOf(scene));
  const auto through = Shorten(space, Polyline{scene['C'], scene['A'], scene['B']}).departure;
  ASSERT_TRUE(through);
  EXPECT_EQ(through->segment, 1U);
  EXPECT_NEAR(Distance(through->at, {2, 2.5}), 0, 1e-12);
  const auto into = Shorten(space, Polyline{scene['A'], {2.5, 2.5}}).departure;
  ASSERT_TRUE(into);
  EXPECT_EQ(into->segment, 0U);
  EXPECT_TRUE(Shorten(space, Polyline{{-1, 2}, scene['A']}).departure) << "starts outside";
  EXPECT_TRUE(Shorten(space, Polyline{{2.5, 2.5}}).departure) << "a point inside an obstacle";
}

TEST(Shorten, ForgivesWhatIsWithinTheTolerance) {
  const auto scene = TwoBlocks();
  const TautSpace space(SpaceOf(scene));
  const double inside = 0.5 * space.tolerance();
  const Shortened shortened =
      Shorten(space, Polyline{{2 + inside, 1 + inside}, {2 + inside, 4 - inside}, {3 - inside, 4 - inside}});
  ASSERT_FALSE(shortened.departure);
  EXPECT_NEAR(shortened.path.length, 4, 4 * space.tolerance());
  EXPECT_EQ(shortened.path.points, (Polyline{{2, 1}, {2, 4}, {3, 4}}));
  EXPECT_TRUE(Shorten(space, Polyline{{2 + 3 * inside, 1.5}, {2 + 3 * inside, 3}}).departure);
}

TEST(TautSpace, FollowGoesOnFromWhereTheWalkStands) {
  const auto scene = TwoBlocks();
  const TautSpace space(SpaceOf(scene));
  std::optional<Walk> walk;
  ASSERT_FALSE(space.Follow(Polyline{scene['A'], scene['C']}, walk));
  ASSERT_FALSE(space.Follow(Polyline{scene['D'], scene['B']}, walk));
  EXPECT_EQ(space.Pull(*walk).points,
            Shorten(space, Polyline{scene['A'], scene['C'], scene['D'], scene['B']}).path.points);
}

class TautSpaceRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, TautSpaceRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(TautSpaceRandom, ShortenIsTheSameForTheSameClass) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const TautSpace space(scene.space);
    const std::vector<Point> points{RandomFreePoint(rng, scene), RandomFreePoint(rng, scene),
                                    RandomFreePoint(rng, scene)};
    const ClassOracle oracle(scene.rings, scene.representatives, points);
    const std::size_t from = oracle.sight().NodesAt(points[0])[0], to = oracle.sight().NodesAt(points[1])[0];
    const auto one = RandomWalk(rng, oracle, from, to), other = RandomWalk(rng, oracle, from, to);
    if (!one) continue;
    const Shortened first = Shorten(space, *one), second = Shorten(space, *other);
    ASSERT_FALSE(first.departure || second.departure);
    ASSERT_EQ(first.path.word, space.rays().WordOf(*one));
    // Equal words mean equal taut curves, and the other way round.
    ASSERT_EQ(first.path.word == second.path.word, first.path.points == second.path.points);
  }
}

}  // namespace
}  // namespace tautline
