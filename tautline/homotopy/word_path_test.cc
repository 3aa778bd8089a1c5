#include "tautline/homotopy/word_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

std::optional<TautPath> PathOf(const TautSpace& space, Point from, Point to, std::string_view word) {
  return FindWordPath(space, *space.Locate(from), *space.Locate(to), ParseWord(word, space.rays().names()).value());
}

TEST(FindWordPath, LeadsAroundTheNamedObstacles) {
  const auto scene = Sketch({".........",  //
                             "A.a...b.B",  //
                             "..a...b..",  //
                             "........."});
  const TautSpace space(SpaceOf(scene));
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "")->points, (Polyline{scene['A'], {2, 1}, {7, 1}, scene['B']}));
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "a b")->points, (Polyline{scene['A'], {2, 3}, {7, 3}, scene['B']}));
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "a")->points,
            (Polyline{scene['A'], {2, 3}, {3, 3}, {6, 1}, {7, 1}, scene['B']}));
  EXPECT_EQ(PathOf(space, scene['A'], scene['A'], "a a")->word.size(), 2U);
}

TEST(FindWordPath, TellsObstaclesOfOneColumnApart) {
  const auto scene = Sketch({".....",  //
                             "..b..",  //
                             "A...B",  //
                             "..a..",  //
                             "....."});
  const TautSpace space(SpaceOf(scene));
  // Between the two only a's ray is crossed; above both, a's and then b's.
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "a")->points, (Polyline{scene['A'], scene['B']}));
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "a b")->points, (Polyline{scene['A'], {2, 4}, {3, 4}, scene['B']}));
  EXPECT_EQ(PathOf(space, scene['A'], scene['B'], "")->points, (Polyline{scene['A'], {2, 1}, {3, 1}, scene['B']}));
  EXPECT_TRUE(PathOf(space, scene['A'], scene['B'], "b"));
}

TEST(FindWordPath, TellsObstaclesOfNearlyOneColumnApart) {
  // As near as numbers can be, in every order of columns and heights: no line fits between the rays.
  for (const double step : {0x1p-52, -0x1p-52, 0x1p-45}) {
    auto scene = Sketch({".....",  //
                         "..c..",  //
                         ".....",  //
                         "A.b.B",  //
                         ".....",  //
                         "..a..",  //
                         "....."});
    double x = 2.5;
    for (const double y : {1.5, 3.5, 5.5}) {
      scene.world.obstacles[static_cast<std::size_t>(y / 2)].representative = Point{x, y};
      x += 4 * step;
    }
    const TautSpace space(SpaceOf(scene));
    for (const char* word :
         {"", "a", "b", "c", "a b", "b a", "a b c", "c b a", "b c^-1 a", "a c b^-1 a", "b b a^-1 c"}) {
      SCOPED_TRACE(word);
      ASSERT_TRUE(PathOf(space, scene['A'], scene['B'], word)) << "step " << step;
    }
  }
}

// No number lies between the columns of two rays, but one is crossed before the other.
TEST(FindWordPath, TellsObstaclesOfNeighbouringColumnsApart) {
  auto scene = Sketch({".....",  //
                       "..c..",  //
                       ".....",  //
                       "..b..",  //
                       "A...B",  //
                       "..a..",  //
                       "....."});
  const double middle = 2.5, right = std::nextafter(middle, 3);
  for (const double a_x : {middle, right}) {
    for (const double b_x : {middle, right}) {
      scene.world.obstacles[0].representative = {a_x, 1.5};
      scene.world.obstacles[1].representative = {b_x, 3.5};
      scene.world.obstacles[2].representative = {middle, 5.5};
      const TautSpace space(SpaceOf(scene));
      for (const Point above : {Point{2.5, 0.5}, {2.5, 2.5}, {2.5, 4.5}, {2.5, 6.5}}) {
        const Word word = space.rays().WordOf(Polyline{scene['A'], {1.5, above.y}, {3.5, above.y}, scene['B']});
        const auto path = FindWordPath(space, *space.Locate(scene['A']), *space.Locate(scene['B']), word);
        ASSERT_TRUE(path) << above.y;
        EXPECT_EQ(path->points.size(), above.y == 2.5 ? 2U : 4U);
      }
      for (const char* word : {"a", "b", "c", "a^-1", "b^-1", "c b a", "b^-1 a c^-1"}) {
        EXPECT_TRUE(PathOf(space, scene['A'], scene['B'], word)) << word;
      }
    }
  }
}

TEST(FindWordPath, KnowsThatACourtyardIsLeftByNoWord) {
  const auto scene = Sketch({".......",  //
                             ".aaaaa.",  //
                             ".aA.Ba.",  //
                             ".aaaaa.",  //
                             "......."});
  const TautSpace space(SpaceOf(scene));
  const auto straight = space.rays().WordOf(Polyline{scene['A'], scene['B']});
  EXPECT_TRUE(FindWordPath(space, *space.Locate(scene['A']), *space.Locate(scene['B']), straight));
  EXPECT_FALSE(PathOf(space, scene['A'], scene['B'], "a a a"));
}

TEST(FindWordPath, FindsTheClassOfEveryListedWord) {
  const auto rounds = static_cast<std::uint64_t>(ScaledTestCount(1000));
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    const Point from = RandomFreePoint(rng, scene), to = RandomFreePoint(rng, scene);
    for (const TautPath& path : FindClasses(space, from, to, {.max_length = {}, .max_count = 12}).classes) {
      const auto found = FindWordPath(space, *space.Locate(from), *space.Locate(to), path.word);
      ASSERT_TRUE(found) << ToString(path.word, space.rays().names());
      ASSERT_EQ(found->points, path.points);
    }
  }
}

TEST(FindWordPath, FindsAPathForEveryWordWhereAllIslandsAreInReach) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const RandomScene scene = MakeRandomScene(rng);
    if (scene.space.components.size() > 1 || scene.space.islands.empty()) continue;
    const TautSpace space(scene.space);
    const auto from = space.Locate(RandomFreePoint(rng, scene)), to = space.Locate(RandomFreePoint(rng, scene));
    Word word;
    for (int i = rng.UniformInt(0, 8); i > 0; --i) {
      const int island = rng.UniformInt(0, static_cast<int>(scene.space.islands.size()) - 1);
      word.Append({ObstacleId(island), rng.UniformInt(0, 1) == 1});
    }
    const auto found = FindWordPath(space, *from, *to, word);
    ASSERT_TRUE(found) << ToString(word, space.rays().names());
    ASSERT_EQ(found->word, word);
  }
}

}  // namespace
}  // namespace tautline
