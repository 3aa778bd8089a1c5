#include "tautline/homotopy/moving.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/print_point.h"
#include "tautline/homotopy/rays.h"

namespace tautline {
namespace {

constexpr ObstacleId kA(0), kB(1), kC(2);

std::vector<std::string> Names(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) names.emplace_back(1, static_cast<char>('a' + i));
  return names;
}

/// a, b and c with room above and below each, and two ends far off to either side.
class ThreePunctures : public testing::Test {
 protected:
  Word Parse(const std::string& text) const { return *ParseWord(text, Names(3)); }

  std::string Carried(const std::string& word) const {
    const auto carried = moving_.Carry(Parse(word), 0, 1);
    return carried ? ToString(*carried, Names(3)) : "too long";
  }

  void MoveAlong(ObstacleId puncture, const Polyline& path) {
    for (const Point p : path) ASSERT_TRUE(moving_.Move(puncture, p).has_value());
  }

  MovingPunctures moving_{{{2, 2}, {4, 2}, {6, 2}}, {{-9, 9}, {19, 9}}};
};

// a passes above b from left to right. A curve over both keeps its side of both; so does one between the two:
//
//    ___________          ___________
//      a  |                  |  a
//      ---|-->     ->     ---|-->          a is over the curve, b under it
//         b                  b
TEST_F(ThreePunctures, OverAnotherToTheRight) {
  MoveAlong(kA, {{3, 4}, {5, 4}});
  EXPECT_EQ(Carried("a b"), "b a");
  EXPECT_EQ(Carried("b"), "b");
  EXPECT_EQ(Carried("a"), "b a b^-1");
  EXPECT_EQ(Carried("a^-1"), "b a^-1 b^-1");
  EXPECT_EQ(Carried("c a"), "c b a b^-1");
}

TEST_F(ThreePunctures, OverAnotherToTheLeft) {
  MoveAlong(kB, {{3, 4}, {1, 4}});
  EXPECT_EQ(Carried("a b"), "b a");
  EXPECT_EQ(Carried("a"), "a");
  EXPECT_EQ(Carried("b"), "a^-1 b a");
}

TEST_F(ThreePunctures, UnderAnotherTheRolesSwap) {
  MoveAlong(kA, {{3, 0}, {5, 0}});
  EXPECT_EQ(Carried("a b"), "b a");
  EXPECT_EQ(Carried("a"), "a");
  EXPECT_EQ(Carried("b"), "a^-1 b a");
  MoveAlong(kA, {{3, 0}});
  EXPECT_EQ(Carried("b"), "b");
}

TEST_F(ThreePunctures, AroundAnother) {
  MoveAlong(kA, {{4, 4}, {6, 1}, {4, 0}, {2, 2}});
  // Clockwise around b: what went over a goes around b first.
  EXPECT_EQ(Carried("a b"), "a b");
  EXPECT_EQ(Carried("a"), "a b a b^-1 a^-1");
  EXPECT_EQ(Carried("b"), "a b a^-1");
}

TEST_F(ThreePunctures, SeveralOnOneWayInTheOrderOfTravel) {
  MoveAlong(kA, {{7, 4}});
  EXPECT_EQ(Carried("a b c"), "b c a");
  EXPECT_EQ(Carried("a"), "b c a c^-1 b^-1");
  MoveAlong(kA, {{2, 4}});
  EXPECT_EQ(Carried("a"), "a");
}

TEST_F(ThreePunctures, UpAndDownChangesNothing) {
  MoveAlong(kA, {{2, 7}, {2, -7}, {3.5, -7}, {3.5, 8}});
  EXPECT_EQ(Carried("a b a^-1 c"), "a b a^-1 c");
}

TEST_F(ThreePunctures, OfOneColumnTheFirstIsToTheLeft) {
  MoveAlong(kA, {{4, 4}});
  EXPECT_EQ(Carried("a b"), "a b");
  MoveAlong(kB, {{6, 5}});  // Over c, under whom nobody else is.
  EXPECT_EQ(Carried("b c"), "b c");
  MoveAlong(kC, {{6, 1}, {5, 1}});  // Under b, to whose right it was.
  EXPECT_EQ(Carried("b c"), "c b");
  MoveAlong(kC, {{6, 1}, {4, 1}, {4.5, 1}});
  EXPECT_EQ(Carried("a b c"), "a c b");
}

TEST_F(ThreePunctures, TheRayOverAnEnd) {
  MoveAlong(kC, {{19, 8}});
  EXPECT_EQ(Carried("a"), "a") << "an end in the column is to the right of the ray";
  MoveAlong(kC, {{20, 8}});
  EXPECT_EQ(Carried("a"), "a c^-1");
  EXPECT_EQ(Carried("a c"), "a");
  MoveAlong(kC, {{18.5, 10}});
  EXPECT_EQ(Carried("a"), "a c^-1") << "over the end no ray passes it";
  MoveAlong(kC, {{20, 10}, {20, 8}, {6, 2}});
  EXPECT_EQ(Carried("a"), "a");
  MoveAlong(kA, {{2, 1}, {-10, 1}});
  EXPECT_EQ(Carried("a"), "");
  EXPECT_EQ(moving_.Carry(Word(), 1, 1), Word());
  EXPECT_EQ(moving_.Carry(Parse("b"), 0, 0), Parse("a^-1 b a"));
}

TEST_F(ThreePunctures, ExactlyThroughAnotherIsNoWay) {
  const auto through = moving_.Move(kA, {6, 2});
  ASSERT_FALSE(through.has_value());
  EXPECT_EQ(through.error().puncture, kB);
  EXPECT_EQ(moving_.punctures()[0], (Point{2, 2})) << "nothing has moved";
  EXPECT_EQ(Carried("a b"), "a b");
  MoveAlong(kA, {{4, 4}});
  const auto down = moving_.Move(kA, {4, 0});
  ASSERT_FALSE(down.has_value());
  EXPECT_EQ(down.error().puncture, kB);
  const auto onto_end = moving_.Move(kA, {19, 9});
  ASSERT_FALSE(onto_end.has_value());
  EXPECT_EQ(onto_end.error().end, 1u);
  EXPECT_FALSE(onto_end.error().puncture.has_value());
}

TEST_F(ThreePunctures, WordsThatGrowWithoutBoundAreGivenUp) {
  // A plait: the left one over the middle one, then the right one over the new middle one, and so on. Every turn
  // lengthens words by a factor.
  std::array<ObstacleId, 3> order{kA, kB, kC};
  for (int i = 0; i < 40; ++i) {
    const bool from_left = i % 2 == 0;
    const std::size_t outer = from_left ? 0 : 2;
    MoveAlong(order[outer], {{from_left ? 5.0 : 3.0, 4}});
    MoveAlong(order[1], {{from_left ? 2.0 : 6.0, 2}});
    MoveAlong(order[outer], {{4, 2}});
    std::swap(order[outer], order[1]);
    if (i == 5) {
      EXPECT_NE(Carried("a b"), "too long");
    }
  }
  EXPECT_EQ(Carried("a b"), "too long");
}

// Table I of the paper: which point passes over which, and the words of the four sides after it. The paper counts right
// to left as positive, so every exponent is the other way around here.
struct Stage {
  const char* what;
  ObstacleId moving;
  double to_x;
  std::array<const char*, 4> words;
};

TEST(MovingPunctures, TheStagesOfTheRevisionTable) {
  const std::array<const char*, 4> current{"a^-1", "a b c", "c^-1 b^-1 c", "c^-1"};
  const std::vector<std::vector<Stage>> configurations{
      {{"P1, stage 1", kA, 4.5, {"b a^-1 b^-1", "b a c", "c^-1 b^-1 c", "c^-1"}},
       {"P1, stage 2", kA, 7, {"b c a^-1 c^-1 b^-1", "b c a", "c^-1 b^-1 c", "c^-1"}}},
      {{"P2, stage 1", kB, 7, {"a^-1", "a c b", "b^-1", "c^-1"}},
       {"P2, stage 2", kA, 6.5, {"c a^-1 c^-1", "c a b", "b^-1", "c^-1"}}},
      {{"P3, stage 1", kB, 1, {"a^-1", "b a c", "c^-1 a^-1 b^-1 a c", "c^-1"}}}};
  const std::vector<std::string> names = Names(3);
  for (const auto& stages : configurations) {
    MovingPunctures moving({{2, 2}, {4, 2}, {6, 2}}, {{-9, 9}, {-9, -9}, {19, -9}, {19, 9}});
    for (const Stage& stage : stages) {
      SCOPED_TRACE(stage.what);
      ASSERT_TRUE(moving.Move(stage.moving, {moving.punctures()[stage.moving.index()].x, 3}).has_value());
      ASSERT_TRUE(moving.Move(stage.moving, {stage.to_x, 3}).has_value());
      ASSERT_TRUE(moving.Move(stage.moving, {stage.to_x, 2}).has_value());
      Word product;
      for (std::size_t i = 0; i < current.size(); ++i) {
        const auto carried = moving.Carry(*ParseWord(current[i], names), i, (i + 1) % 4);
        ASSERT_TRUE(carried.has_value());
        EXPECT_EQ(ToString(*carried, names), stage.words[i]) << "side " << i + 1;
        product.Append(*carried);
      }
      EXPECT_TRUE(product.empty());
    }
  }
}

TEST(MovingPunctures, WordsThatTheLiteralRulesMiss) {
  const auto names = Names(3);
  const auto carried = [&](double to_x, const char* word) {
    MovingPunctures moving({{to_x > 4 ? 2.0 : 5.0, 3}, {4, 2}, {8, 2}}, {{-9, 9}, {19, 9}});
    EXPECT_TRUE(moving.Move(kA, {to_x, 3}).has_value());
    return ToString(*moving.Carry(*ParseWord(word, names), 0, 1), names);
  };
  EXPECT_EQ(carried(5, "a^-1 b"), "b a^-1");
  EXPECT_EQ(carried(2, "b a^-1 c"), "a^-1 b c");
}

/// Random punctures, ends and paths between them; on a lattice, where columns are shared, or off it.
class RandomMotion {
 public:
  explicit RandomMotion(Rng& rng) : lattice_(rng.UniformInt(0, 1) == 0) {
    while (ends_.size() < 3) AddApart(rng, ends_);
    const auto count = static_cast<std::size_t>(rng.UniformInt(2, 5));
    while (punctures_.size() < count) AddApart(rng, punctures_);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      Polyline path{ends_[i]};
      for (int k = rng.UniformInt(1, 4); k > 0; --k) path.push_back({rng.Uniform(0, 8), rng.Uniform(0, 8)});
      path.push_back(ends_[(i + 1) % ends_.size()]);
      paths_.push_back(path);
    }
  }

  Point RandomTarget(Rng& rng) const {
    if (lattice_) return {1.0 * rng.UniformInt(0, 8), 1.0 * rng.UniformInt(0, 8)};
    return {rng.Uniform(0, 8), rng.Uniform(0, 8)};
  }

  const std::vector<Point>& punctures() const { return punctures_; }
  const std::vector<Point>& ends() const { return ends_; }
  const std::vector<Polyline>& paths() const { return paths_; }
  std::vector<Word> Words() const {
    const Rays rays(punctures_, Names(punctures_.size()));
    std::vector<Word> words;
    for (const Polyline& path : paths_) words.push_back(rays.WordOf(path));
    return words;
  }

  /// Pushes the paths out of the way of a moving puncture: where one crosses its way, it is led on along both sides of
  /// the rest of it and around its end, within a hair. False when a hair was not thin enough.
  bool Push(Rng& rng, std::size_t puncture, Point to) {
    const Point from = punctures_[puncture];
    punctures_[puncture] = to;
    if (from == to) return true;
    const Point ahead = (rng.Uniform(0.5, 1) * kHair / Distance(from, to)) * (to - from), left{-ahead.y, ahead.x};
    for (Polyline& path : paths_) {
      Polyline pushed{path[0]};
      for (std::size_t i = 1; i < path.size(); ++i) {
        const Point u = path[i - 1], v = path[i];
        const int side_u = Orientation(from, to, u), side_v = Orientation(from, to, v);
        if (side_u == 0 || side_v == 0) return false;
        if (side_u != side_v && Orientation(u, v, from) != Orientation(u, v, to)) {
          const double at_u = Cross(to - from, u - from), at_v = Cross(to - from, v - from);
          const Point crossing = Lerp(u, v, at_u / (at_u - at_v)), beside = side_u * left;
          const std::array<Point, 4> detour{crossing + beside, to + ahead + beside, to + ahead - beside,
                                            crossing - beside};
          if (!IsFree(u, crossing, detour[0]) || !IsFree(v, crossing, detour[3])) return false;
          pushed.insert(pushed.end(), detour.begin(), detour.end());
        }
        pushed.push_back(v);
      }
      path = std::move(pushed);
    }
    return true;
  }

  std::size_t PathPoints() const {
    std::size_t points = 0;
    for (const Polyline& path : paths_) points += path.size();
    return points;
  }

 private:
  static constexpr double kHair = 1e-7;

  void AddApart(Rng& rng, std::vector<Point>& points) const {
    const Point p = RandomTarget(rng);
    const auto taken = [p](const std::vector<Point>& others) {
      return std::find(others.begin(), others.end(), p) != others.end();
    };
    if (!taken(punctures_) && !taken(ends_)) points.push_back(p);
  }

  /// Whether no puncture lies in the triangle.
  bool IsFree(Point a, Point b, Point c) const {
    return std::none_of(punctures_.begin(), punctures_.end(), [&](Point p) {
      const int ab = Orientation(a, b, p), bc = Orientation(b, c, p), ca = Orientation(c, a, p);
      return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    });
  }

  bool lattice_;
  std::vector<Point> punctures_;
  std::vector<Point> ends_;
  std::vector<Polyline> paths_;
};

bool LeadsThrough(Point from, Point to, const std::vector<Point>& points, std::size_t except) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i != except && OnSegment(from, to, points[i])) return true;
  }
  return false;
}

TEST(MovingPunctures, WordsAgreeWithPathsThatArePushed) {
  constexpr std::size_t kMostPoints = 20000;
  const std::int64_t count = ScaledTestCount(4000);
  std::int64_t compared = 0, changed = 0, collisions = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    RandomMotion motion(rng);
    const std::vector<Word> words = motion.Words();
    const auto names = Names(motion.punctures().size());
    MovingPunctures moving(motion.punctures(), motion.ends());
    for (int step = rng.UniformInt(1, 8); step > 0 && motion.PathPoints() < kMostPoints; --step) {
      const auto which = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(names.size()) - 1));
      const Point from = motion.punctures()[which], to = motion.RandomTarget(rng);
      const bool collides = LeadsThrough(from, to, motion.punctures(), which) ||
                            LeadsThrough(from, to, motion.ends(), motion.ends().size());
      ASSERT_EQ(moving.Move(ObstacleId(which), to).has_value(), !collides);
      collisions += collides ? 1 : 0;
      if (collides) continue;
      if (!motion.Push(rng, which, to)) break;
      const std::vector<Word> pushed = motion.Words();
      for (std::size_t i = 0; i < words.size(); ++i) {
        const auto carried = moving.Carry(words[i], i, (i + 1) % words.size());
        ASSERT_TRUE(carried.has_value());
        ASSERT_EQ(ToString(*carried, names), ToString(pushed[i], names)) << "from " << ToString(words[i], names);
        ++compared;
        changed += pushed[i] == words[i] ? 0 : 1;
      }
    }
  }
  EXPECT_GT(compared, 5 * count);
  EXPECT_GT(changed, compared / 3);
  EXPECT_GT(collisions, count / 20);
}

TEST(MovingPunctures, ThereAndBackAgainIsNothing) {
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomMotion motion(rng);
    MovingPunctures moving(motion.punctures(), motion.ends());
    std::vector<std::pair<ObstacleId, Point>> back;
    for (int step = rng.UniformInt(1, 6); step > 0; --step) {
      const auto which = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(motion.punctures().size()) - 1));
      const Point from = moving.punctures()[which];
      if (moving.Move(ObstacleId(which), motion.RandomTarget(rng))) back.emplace_back(which, from);
    }
    const std::vector<Word> words = motion.Words();
    // Paths that join to a closed one do so at all times.
    Word before, after;
    for (std::size_t i = 0; i < words.size(); ++i) {
      before.Append(words[i]);
      after.Append(*moving.Carry(words[i], i, (i + 1) % words.size()));
    }
    ASSERT_EQ(moving.Carry(before, 0, 0), after);
    ASSERT_EQ(moving.Carry(words[0].Inverse(), 1, 0), moving.Carry(words[0], 0, 1)->Inverse());
    ASSERT_EQ(moving.Carry(Word(), 2, 2), Word());
    std::reverse(back.begin(), back.end());
    for (const auto& [which, to] : back) ASSERT_TRUE(moving.Move(which, to).has_value());
    for (std::size_t i = 0; i < words.size(); ++i) {
      ASSERT_EQ(moving.Carry(words[i], i, (i + 1) % words.size()), words[i]);
    }
  }
}

TEST(MovingPunctures, MovesThatKeepApartCommute) {
  const std::int64_t count = ScaledTestCount(2000);
  std::int64_t compared = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomMotion motion(rng);
    const Point first_to = motion.RandomTarget(rng), second_to = motion.RandomTarget(rng);
    const Point first = motion.punctures()[0], second = motion.punctures()[1];
    if (CrossProperly(first, first_to, second, second_to) || OnSegment(first, first_to, second_to) ||
        OnSegment(second, second_to, first_to) || OnSegment(first, first_to, second) ||
        OnSegment(second, second_to, first)) {
      continue;
    }
    MovingPunctures one(motion.punctures(), motion.ends()), other(motion.punctures(), motion.ends());
    const bool moved = one.Move(kA, first_to) && one.Move(kB, second_to);
    const bool moved_too = other.Move(kB, second_to) && other.Move(kA, first_to);
    ASSERT_EQ(moved, moved_too);
    if (!moved) continue;
    ++compared;
    const std::vector<Word> words = motion.Words();
    for (std::size_t i = 0; i < words.size(); ++i) {
      ASSERT_EQ(one.Carry(words[i], i, (i + 1) % 3), other.Carry(words[i], i, (i + 1) % 3));
    }
  }
  EXPECT_GT(compared, count / 4);
}

}  // namespace
}  // namespace tautline
