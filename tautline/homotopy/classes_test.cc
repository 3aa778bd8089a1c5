#include "tautline/homotopy/classes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

ClassOptions UpTo(double max_length) { return {.max_length = max_length, .max_count = {}}; }
ClassOptions Shortest(std::int64_t count) { return {.max_length = {}, .max_count = count}; }

std::vector<std::string> WordsOf(const TautSpace& space, const ClassList& list) {
  std::vector<std::string> words;
  for (const TautPath& path : list.classes) words.push_back(ToString(path.word, space.rays().names()));
  return words;
}

std::vector<double> LengthsOf(const ClassList& list) {
  std::vector<double> lengths;
  for (const TautPath& path : list.classes) lengths.push_back(path.length);
  return lengths;
}

TEST(FindClasses, ListsBothWaysAroundABlock) {
  const auto scene = Sketch({".......",  //
                             "...a...",  //
                             "A..a..B",  //
                             "...a...",  //
                             "......."});
  const TautSpace space(SpaceOf(scene));
  const double over = 2 * std::hypot(2.5, 1.5) + 1, around = 2 * std::hypot(2.5, 1.5) + 2 * (1 + 3) + 1;
  const ClassList list = FindClasses(space, scene['A'], scene['B'], UpTo(around + 1));
  EXPECT_TRUE(list.complete);
  EXPECT_EQ(WordsOf(space, list), (std::vector<std::string>{"", "a", "a^-1", "a a"}));
  ASSERT_EQ(list.classes.size(), 4U);
  EXPECT_NEAR(list.classes[1].length, over, 1e-12);
  EXPECT_NEAR(list.classes[2].length, around, 1e-12);
  EXPECT_EQ(list.classes[1].points, (Polyline{scene['A'], {3, 4}, {4, 4}, scene['B']}));
}

TEST(FindClasses, HasOneClassWithoutObstacles) {
  const auto scene = Sketch({"A..", "..B"});
  const ClassList list = FindClasses(TautSpace(SpaceOf(scene)), scene['A'], scene['B']);
  EXPECT_TRUE(list.complete);
  ASSERT_EQ(list.classes.size(), 1U);
  EXPECT_EQ(list.classes[0].points, (Polyline{scene['A'], scene['B']}));
}

TEST(FindClasses, StartsWithThePointWhereStartIsGoal) {
  const auto scene = Sketch({".....",  //
                             ".Aa..",  //
                             "....."});
  const TautSpace space(SpaceOf(scene));
  const ClassList list = FindClasses(space, scene['A'], scene['A'], Shortest(3));
  EXPECT_EQ(WordsOf(space, list), (std::vector<std::string>{"", "a", "a^-1"}));
  EXPECT_EQ(list.classes.at(0).points, (Polyline{scene['A']}));
  EXPECT_EQ(list.classes.at(0).length, 0);
  EXPECT_FALSE(list.complete);
}

TEST(FindClasses, IsEmptyBetweenComponents) {
  const auto scene = Sketch({"A.a.",  //
                             "..a.",  //
                             "..aB"});
  const ClassList list = FindClasses(TautSpace(SpaceOf(scene)), scene['A'], scene['B'], UpTo(100));
  EXPECT_TRUE(list.classes.empty());
  EXPECT_TRUE(list.complete);
}

TEST(FindClasses, IncludesAClassOfExactlyTheLimit) {
  const auto scene = Sketch({".......",  //
                             "A..a..B",  //
                             "......."});
  const TautSpace space(SpaceOf(scene));
  const double length = FindClasses(space, scene['A'], scene['B'], Shortest(1)).classes.at(0).length;
  EXPECT_EQ(FindClasses(space, scene['A'], scene['B'], UpTo(length)).classes.size(), 2U);
  EXPECT_EQ(FindClasses(space, scene['A'], scene['B'], UpTo(length * (1 - 1e-6))).classes.size(), 0U);
}

TEST(FindClasses, StopsAtItsBudget) {
  const auto scene = Sketch({".......",  //
                             "A.a.b.B",  //
                             "......."});
  const TautSpace space(SpaceOf(scene));
  const ClassList all = FindClasses(space, scene['A'], scene['B'], UpTo(30));
  ASSERT_TRUE(all.complete);
  EXPECT_FALSE(all.budget_exceeded);
  const ClassList some = FindClasses(space, scene['A'], scene['B'], {.max_length = 30, .max_count = {}, .budget = 20});
  EXPECT_TRUE(some.budget_exceeded);
  EXPECT_FALSE(some.complete);
  ASSERT_LT(some.classes.size(), all.classes.size());
  ASSERT_GT(some.classes.size(), 0U);
  for (std::size_t i = 0; i < some.classes.size(); ++i) {
    EXPECT_NEAR(some.classes[i].length, all.classes[i].length, 1e-12);
  }
}

/// A random question with a limit that no class meets by a hair.
struct Question {
  RandomScene scene;
  Point from, to;
  double max_length = 0;
  std::vector<OracleClass> expected;
};

std::optional<Question> RandomQuestion(std::uint64_t seed, bool lattice) {
  Rng rng(seed);
  Question question{MakeRandomScene(rng, lattice), {}, {}, 0, {}};
  question.from = RandomFreePoint(rng, question.scene);
  question.to = rng.UniformInt(0, 7) == 0 ? question.from : RandomFreePoint(rng, question.scene);
  ClassOracle oracle(question.scene.rings, question.scene.representatives, std::vector{question.from, question.to});
  const double least =
      oracle.DistancesTo(oracle.sight().NodesAt(question.to))[oracle.sight().NodesAt(question.from)[0]];
  question.max_length = std::isfinite(least) ? (least + 1) * rng.Uniform(1, 2.5) : 10;
  const auto classes = oracle.Classes(question.from, question.to, question.max_length);
  if (!classes) return std::nullopt;
  question.expected = *classes;
  constexpr double kHair = 1e-7;
  while (!question.expected.empty() && question.expected.back().length > question.max_length * (1 - kHair)) {
    question.max_length = question.expected.back().length * (1 - 2 * kHair);
    while (!question.expected.empty() && question.expected.back().length > question.max_length)
      question.expected.pop_back();
  }
  return question;
}

class ClassesRandom : public testing::TestWithParam<bool> {
 protected:
  /// Calls test(question, rng) for `count` random questions.
  void ForEachQuestion(std::int64_t count, const std::function<void(const Question&, Rng&)>& test) const {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE(seed);
      Rng rng(static_cast<std::uint64_t>(seed) + 1'000'000);
      if (const auto question = RandomQuestion(static_cast<std::uint64_t>(seed), GetParam())) test(*question, rng);
      if (HasFatalFailure()) return;
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, ClassesRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

TEST_P(ClassesRandom, AreThoseOfTheOracle) {
  ForEachQuestion(500, [](const Question& question, Rng&) {
    const TautSpace space(question.scene.space);
    const ClassList list = FindClasses(space, question.from, question.to, UpTo(question.max_length));
    ASSERT_TRUE(list.complete);
    ASSERT_EQ(list.classes.size(), question.expected.size());
    std::map<Word, double> expected;
    for (const OracleClass& c : question.expected) expected[c.word] = c.length;
    for (std::size_t i = 0; i < list.classes.size(); ++i) {
      const TautPath& path = list.classes[i];
      ASSERT_TRUE(expected.contains(path.word)) << ToString(path.word, space.rays().names());
      ASSERT_NEAR(path.length, expected[path.word], 1e-9 * (1 + path.length));
      ASSERT_EQ(path.length, Length(path.points));
      ASSERT_EQ(path.points.front(), question.from);
      ASSERT_EQ(path.points.back(), question.to);
      if (i % 16 != 0) continue;
      const Shortened again = Shorten(space, path.points);
      ASSERT_FALSE(again.departure);
      ASSERT_EQ(again.path.points, path.points);
      ASSERT_EQ(again.path.word, path.word);
    }
  });
}

TEST(FindClasses, LeavesAndArrivesThroughEverySectorOfATouchingPoint) {
  constexpr double kMaxLength = 8.123;
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, true);
    const Point from = RandomTouchingPoint(rng, scene), to = RandomTouchingPoint(rng, scene);
    ClassOracle oracle(scene.rings, scene.representatives, std::vector{from, to});
    std::vector<double> expected;
    bool all = true;
    for (const std::size_t a : oracle.sight().NodesAt(from)) {
      for (const std::size_t b : oracle.sight().NodesAt(to)) {
        const auto classes = oracle.ClassesBetween(std::vector{a}, std::vector{b}, kMaxLength);
        all = all && classes;
        if (!classes) break;
        for (const OracleClass& c : *classes) expected.push_back(c.length);
      }
    }
    if (!all) continue;
    std::sort(expected.begin(), expected.end());
    // Staying at the point is one class, not one for each sector.
    if (from == to) expected.erase(expected.begin() + 1, std::upper_bound(expected.begin(), expected.end(), 0.0));
    const auto found = LengthsOf(FindClasses(TautSpace(scene.space), from, to, UpTo(kMaxLength)));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-8);
  }
}

TEST_P(ClassesRandom, ComeShortestFirst) {
  ForEachQuestion(200, [](const Question& question, Rng& rng) {
    const TautSpace space(question.scene.space);
    const auto all = LengthsOf(FindClasses(space, question.from, question.to, UpTo(question.max_length)));
    for (std::size_t i = 1; i < all.size(); ++i) ASSERT_LE(all[i - 1], all[i] * (1 + 1e-9));
    const int count = rng.UniformInt(0, static_cast<int>(all.size()));
    const ClassList prefix = FindClasses(space, question.from, question.to, Shortest(count));
    ASSERT_EQ(prefix.classes.size(), static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < prefix.classes.size(); ++i) {
      ASSERT_NEAR(prefix.classes[i].length, all[i], 1e-9 * (1 + all[i]));
    }
  });
}

TEST_P(ClassesRandom, AreCompleteExactlyWhenNothingIsLeft) {
  ForEachQuestion(200, [](const Question& question, Rng&) {
    const TautSpace space(question.scene.space);
    const auto count = static_cast<std::int64_t>(question.expected.size());
    for (const std::int64_t most : {count - 1, count, count + 1}) {
      if (most < 0) continue;
      const ClassList list =
          FindClasses(space, question.from, question.to, {.max_length = question.max_length, .max_count = most});
      ASSERT_EQ(list.complete, most >= count);
      ASSERT_EQ(list.classes.size(), static_cast<std::size_t>(std::min(most, count)));
      ASSERT_FALSE(list.budget_exceeded);
    }
  });
}

using Map = std::function<Point(Point)>;

/// The question with all its points moved; names and representatives stay with their obstacles.
std::pair<FreeSpace, World> Moved(const Question& question, const Map& map, double scale) {
  World world = question.scene.world;
  for (Point& p : world.outline) p = map(p);
  for (Obstacle& obstacle : world.obstacles) {
    obstacle.representative = map(obstacle.representative.value_or(InteriorPoint(*obstacle.polygon)));
    for (Point& p : obstacle.polygon->outer) p = map(p);
  }
  world.snap *= scale;
  return {BuildFreeSpace(world).value(), world};
}

void ExpectSameLengths(const ClassList& list, const Question& question, double scale) {
  ASSERT_TRUE(list.complete);
  ASSERT_EQ(list.classes.size(), question.expected.size());
  for (std::size_t i = 0; i < list.classes.size(); ++i) {
    ASSERT_NEAR(list.classes[i].length, scale * question.expected[i].length, 1e-8 * scale * question.max_length);
  }
}

Word Mirrored(const Word& word) {
  Word mirrored;
  for (const Letter letter : word.letters()) mirrored.Append({letter.obstacle, !letter.inverse});
  return mirrored;
}

bool MeetsAColumn(const Question& question) {
  std::vector<double> columns{question.from.x, question.to.x};
  for (const Point r : question.scene.representatives) columns.push_back(r.x);
  std::sort(columns.begin() + 2, columns.end());
  const auto of = [&](double x) { return std::count(columns.begin() + 2, columns.end(), x); };
  return of(columns[0]) > 0 || of(columns[1]) > 0 ||
         std::adjacent_find(columns.begin() + 2, columns.end()) != columns.end();
}

TEST_P(ClassesRandom, AreMirroredInAMirroredScene) {
  const Map mirror = [](Point p) { return Point{-p.x, p.y}; };
  ForEachQuestion(200, [&](const Question& question, Rng&) {
    const TautSpace space(Moved(question, mirror, 1).first);
    const ClassList list = FindClasses(space, mirror(question.from), mirror(question.to), UpTo(question.max_length));
    ExpectSameLengths(list, question, 1);
    // On the column of a ray left and right are not alike.
    if (MeetsAColumn(question)) return;
    std::vector<Word> expected, found;
    for (const OracleClass& c : question.expected) expected.push_back(Mirrored(c.word));
    for (const TautPath& path : list.classes) found.push_back(path.word);
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  });
}

TEST_P(ClassesRandom, KeepTheirLengthsInAQuarterTurn) {
  const Map turn = [](Point p) { return Point{-p.y, p.x}; };
  ForEachQuestion(200, [&](const Question& question, Rng&) {
    const TautSpace space(Moved(question, turn, 1).first);
    ExpectSameLengths(FindClasses(space, turn(question.from), turn(question.to), UpTo(question.max_length)), question,
                      1);
  });
}

TEST_P(ClassesRandom, ScaleWithTheScene) {
  ForEachQuestion(200, [&](const Question& question, Rng& rng) {
    const double scale = std::exp2(rng.UniformInt(-20, 16));  // Within the largest coordinate of a world.
    const Map map = [scale](Point p) { return scale * p; };
    const TautSpace space(Moved(question, map, scale).first);
    ExpectSameLengths(FindClasses(space, map(question.from), map(question.to), UpTo(scale * question.max_length)),
                      question, scale);
  });
}

TEST(FindClasses, KeepsItsLengthsInATurnedScaledAndMovedScene) {
  // Only where obstacles keep apart: what touches exactly need not after rounding.
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    const auto question = RandomQuestion(static_cast<std::uint64_t>(seed), false);
    if (!question) continue;
    Rng rng(static_cast<std::uint64_t>(seed));
    const double scale = std::pow(10, rng.Uniform(-3, 3)), angle = rng.Uniform(0, 2 * std::numbers::pi);
    const Point x = scale * Point{std::cos(angle), std::sin(angle)}, y{-x.y, x.x};
    const Point shift{scale * rng.Uniform(-100, 100), scale * rng.Uniform(-100, 100)};
    const Map map = [&](Point p) { return shift + p.x * x + p.y * y; };
    const TautSpace space(Moved(*question, map, scale).first);
    const ClassList list =
        FindClasses(space, map(question->from), map(question->to), UpTo(scale * question->max_length));
    ExpectSameLengths(list, *question, scale);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace tautline
