#include "tautline/homotopy/taut_strings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/moving.h"
#include "tautline/homotopy/print_point.h"
#include "tautline/homotopy/rays.h"
#include "tautline/homotopy/string_loop.h"

namespace tautline {
namespace {

/// "0 2L 1R 3": the pins from where the string is tied to its holder, with their sides.
std::string Text(std::span<const StringBend> bends) {
  std::string text;
  for (const StringBend& bend : bends) {
    text += (text.empty() ? "" : " ") + std::to_string(bend.pin.value());
    if (bend.side != Side::kNone) text += bend.side == Side::kLeft ? "L" : "R";
  }
  return text;
}

/// Robots whose pins come after those of their bases and of single pins.
struct Yard {
  explicit Yard(const std::vector<Point>& bases, const std::vector<Point>& single = {}) : robots(bases.size()) {
    pins = bases;
    pins.insert(pins.end(), single.begin(), single.end());
    first_robot = pins.size();
    pins.insert(pins.end(), bases.begin(), bases.end());
    strings = std::make_unique<TautStrings>(pins);
    for (std::size_t i = 0; i < robots; ++i) strings->Tie(PinId(i), robot(i));
  }
  PinId robot(std::size_t i) const { return PinId(first_robot + i); }
  bool Go(std::size_t i, Point to) { return strings->Move(robot(i), to).has_value(); }
  std::string Bends(std::size_t i) const { return Text(strings->bends(StringId(i))); }

  std::size_t robots, first_robot;
  std::vector<Point> pins;
  std::unique_ptr<TautStrings> strings;
};

// Robot 1 drives up through the string of robot 0:
//
//      o 1                     3
//                             / `
//   0-----------2     ->    0    `2
//
//      1                      1
TEST(TautStrings, AStringIsPushed) {
  Yard yard({{0, 0}, {3, -4}});
  ASSERT_TRUE(yard.Go(0, {10, 0}));
  ASSERT_TRUE(yard.Go(1, {3, -1}));
  EXPECT_EQ(yard.Bends(0), "0 2");
  ASSERT_TRUE(yard.Go(1, {3, 4}));
  EXPECT_EQ(yard.Bends(0), "0 3R 2");
  EXPECT_DOUBLE_EQ(yard.strings->length(StringId(0)), 5 + Distance({3, 4}, {10, 0}));
  EXPECT_EQ(yard.Bends(1), "1 3");
  ASSERT_TRUE(yard.Go(1, {3, -3}));
  EXPECT_EQ(yard.Bends(0), "0 2");
}

TEST(TautStrings, APinOnAStringTouchesIt) {
  Yard yard({{0, 0}, {3, -4}});
  ASSERT_TRUE(yard.Go(0, {10, 0}));
  ASSERT_TRUE(yard.Go(1, {3, 0}));
  EXPECT_EQ(yard.Bends(0), "0 3R 2");
  EXPECT_DOUBLE_EQ(yard.strings->length(StringId(0)), 10);
  ASSERT_TRUE(yard.Go(1, {7, 0})) << "along the string";
  EXPECT_EQ(yard.Bends(0), "0 3R 2");
  ASSERT_TRUE(yard.Go(1, {8, 1}));
  EXPECT_EQ(yard.Bends(0), "0 3R 2");
  ASSERT_TRUE(yard.Go(1, {1, -1}));
  EXPECT_EQ(yard.Bends(0), "0 2");
}

TEST(TautStrings, WrappedAroundAPinAndBack) {
  Yard yard({{0, 0}}, {{4, 0}});
  ASSERT_TRUE(yard.Go(0, {6, -1}));
  EXPECT_EQ(yard.Bends(0), "0 2");
  ASSERT_TRUE(yard.Go(0, {6, 3}));
  EXPECT_EQ(yard.Bends(0), "0 1L 2");
  ASSERT_TRUE(yard.Go(0, {2, 3}));
  ASSERT_TRUE(yard.Go(0, {2, 0})) << "back beside its own string";
  EXPECT_EQ(yard.Bends(0), "0 2L 1L 2") << "which it touches";
  EXPECT_DOUBLE_EQ(yard.strings->length(StringId(0)), 6);
  ASSERT_TRUE(yard.Go(0, {2, -1})) << "its own string is pushed";
  EXPECT_EQ(yard.Bends(0), "0 2L 1L 2");
  ASSERT_TRUE(yard.Go(0, {2, 1}));
  EXPECT_EQ(yard.Bends(0), "0 1L 2");
  ASSERT_TRUE(yard.Go(0, {5, 1}));
  ASSERT_TRUE(yard.Go(0, {5, -2}));
  EXPECT_EQ(yard.Bends(0), "0 2");
}

TEST(TautStrings, ThePinsThatAFingerSweepsHoldIt) {
  Yard yard({{0, 0}, {5, -2}}, {{3, 4}, {7, 4}, {2.5, 2.5}});
  ASSERT_TRUE(yard.Go(0, {10, 0}));
  ASSERT_TRUE(yard.Go(1, {5, 5}));
  EXPECT_EQ(yard.Bends(0), "0 4L 6R 5") << "two lie above the string's arms, one on an arm";
  Yard low({{0, 0}, {5, -2}}, {{3, 2}, {7, 1}, {2.5, 2.5}});
  ASSERT_TRUE(low.Go(0, {10, 0}));
  ASSERT_TRUE(low.Go(1, {5, 5}));
  EXPECT_EQ(low.Bends(0), "0 2L 6R 3L 5");
  Yard beside({{0, 0}, {5, -2}}, {{2, 2}});
  ASSERT_TRUE(beside.Go(0, {10, 0}));
  ASSERT_TRUE(beside.Go(1, {5, 5}));
  EXPECT_EQ(beside.Bends(0), "0 2L 4R 3");
}

TEST(TautStrings, ARobotLeavesItsBaseThroughAString) {
  for (const double up : {1.0, -1.0}) {
    Yard yard({{0, 0}, {5, 0}});
    ASSERT_TRUE(yard.Go(0, {5, -up}));
    ASSERT_TRUE(yard.Go(0, {10, 0})) << "around the base of robot 1";
    EXPECT_EQ(yard.Bends(0), up > 0 ? "0 1L 2" : "0 1R 2");
    ASSERT_TRUE(yard.Go(1, {5, 3 * up})) << "away from the string";
    EXPECT_EQ(yard.Bends(0), up > 0 ? "0 1L 2" : "0 1R 2");
    Yard other({{0, 0}, {5, 0}});
    ASSERT_TRUE(other.Go(0, {5, -up}));
    ASSERT_TRUE(other.Go(0, {10, 0}));
    ASSERT_TRUE(other.Go(1, {5, -3 * up})) << "through the string";
    EXPECT_EQ(other.Bends(0), up > 0 ? "0 3L 2" : "0 3R 2");
    Yard along({{0, 0}, {5, 0}});
    ASSERT_TRUE(along.Go(0, {5, -up}));
    ASSERT_TRUE(along.Go(0, {10, 0}));
    ASSERT_TRUE(along.Go(1, {7, 0})) << "along the string";
    EXPECT_EQ(along.Bends(0), up > 0 ? "0 1L 3L 2" : "0 1R 3R 2");
  }
}

TEST(TautStrings, ARobotThatLeavesItsBaseBetweenBothArms) {
  Yard yard({{0, 0}, {5, 0}});
  ASSERT_TRUE(yard.Go(0, {6, -1}));
  ASSERT_TRUE(yard.Go(0, {6, 1}));
  ASSERT_TRUE(yard.Go(0, {-1, 0}));
  EXPECT_EQ(yard.Bends(0), "0 1L 0L 2") << "three pins on one line";
  ASSERT_TRUE(yard.Go(0, {1, 1}));
  ASSERT_TRUE(yard.Go(0, {1, 0}));
  EXPECT_EQ(yard.Bends(0), "0 2L 1L 2");
  ASSERT_TRUE(yard.Go(1, {3, 0}));
  EXPECT_EQ(yard.Bends(0), "0 2L 3L 1L 3L 2");
  ASSERT_TRUE(yard.Go(1, {3, 2}));
  EXPECT_EQ(yard.Bends(0), "0 2L 1L 3L 2");
}

TEST(TautStrings, ThroughAPinIsNoWay) {
  Yard yard({{0, 0}, {5, 0}}, {{3, 3}});
  const auto through = yard.strings->Move(yard.robot(0), {6, 6});
  ASSERT_FALSE(through.has_value());
  EXPECT_EQ(through.error().moved, yard.robot(0));
  EXPECT_EQ(through.error().met, PinId(2));
  EXPECT_FALSE(yard.Go(0, {5, 0})) << "a base";
  EXPECT_EQ(yard.strings->point(yard.robot(0)), (Point{0, 0}));
  ASSERT_TRUE(yard.Go(0, {4, 2}));
  EXPECT_FALSE(yard.Go(0, {0, 0})) << "its own base";
  EXPECT_EQ(yard.strings->size(), 2u);
  EXPECT_EQ(yard.strings->pin_count(), 5u);
}

/// A yard of random robots and pins, on a lattice or off it, and the words that their moves carry along.
class RandomYard {
 public:
  explicit RandomYard(Rng& rng) : lattice_(rng.UniformInt(0, 1) == 0) {
    const auto robots = static_cast<std::size_t>(rng.UniformInt(1, 5));
    const auto count = robots + static_cast<std::size_t>(rng.UniformInt(0, 5));
    std::vector<Point> points;
    while (points.size() < count) {
      const Point p = RandomPlace(rng);
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    }
    bases_.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(robots));
    single_.assign(points.begin() + static_cast<std::ptrdiff_t>(robots), points.end());
  }

  Point RandomPlace(Rng& rng) const {
    if (lattice_) return {1.0 * rng.UniformInt(0, 6), 1.0 * rng.UniformInt(0, 6)};
    return {rng.Uniform(0, 6), rng.Uniform(0, 6)};
  }

  const std::vector<Point>& bases() const { return bases_; }
  const std::vector<Point>& single() const { return single_; }

 private:
  bool lattice_;
  std::vector<Point> bases_, single_;
};

Point Mirrored(Point p) { return {-p.x, p.y}; }

std::vector<Point> Mirrored(std::vector<Point> points) {
  for (Point& p : points) p = Mirrored(p);
  return points;
}

std::vector<std::string> AllBends(const Yard& yard) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < yard.robots; ++i) all.push_back(yard.Bends(i));
  return all;
}

/// Where every pin is, but for those of robots that stand on their bases.
std::vector<std::pair<PinId, Point>> VisiblePins(const Yard& yard) {
  std::vector<std::pair<PinId, Point>> pins;
  for (std::size_t k = 0; k < yard.strings->pin_count(); ++k) {
    const Point at = yard.strings->point(PinId(k));
    if (k >= yard.first_robot && at == yard.pins[k]) continue;
    pins.emplace_back(PinId(k), at);
  }
  return pins;
}

/// A string turns around the pins that hold it, by no more than a half turn, and no pin lies on it that it does not
/// touch.
void ExpectTaut(const Yard& yard, std::size_t robot) {
  const auto bends = yard.strings->bends(StringId(robot));
  const Polyline points = yard.strings->points(StringId(robot));
  ASSERT_EQ(points.size(), bends.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(points[i], yard.strings->point(bends[i].pin));
    if (i > 0 && points.size() > 2) {
      for (const auto& [pin, at] : VisiblePins(yard)) {
        ASSERT_TRUE(at == points[i - 1] || at == points[i] || !OnSegment(points[i - 1], points[i], at))
            << yard.Bends(robot) << " meets " << pin.value();
      }
    }
    if (i == 0 || i + 1 == points.size()) continue;
    const int turn = Orientation(points[i - 1], points[i], points[i + 1]);
    ASSERT_NE(bends[i].side, Side::kNone);
    ASSERT_TRUE(turn == 0 || (turn > 0) == (bends[i].side == Side::kLeft)) << yard.Bends(robot);
  }
}

TEST(TautStrings, WordsAgreeWithThoseThatArePushed) {
  const std::int64_t count = ScaledTestCount(5000);
  std::int64_t moves = 0, compared = 0, bent = 0, collisions = 0, touches = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomYard random(rng);
    Yard yard(random.bases(), random.single());
    // A robot on its base stands beside it, by less than strings pass the two at, and that by less than all else is
    // apart.
    constexpr double kBeside = 1e-10, kGap = 1e-9;
    std::vector<Point> punctures = yard.pins;
    for (std::size_t k = yard.first_robot; k < punctures.size(); ++k) {
      punctures[k] = punctures[k] + Point{kBeside, 0.618 * kBeside};
    }
    std::vector<std::string> names;
    for (std::size_t k = 0; k < punctures.size(); ++k) names.push_back("p" + std::to_string(k));
    std::vector<Word> words;
    const Rays before(punctures, names);
    for (std::size_t i = 0; i < yard.robots; ++i) {
      const Polyline line{yard.pins[i], punctures[yard.first_robot + i]};
      words.push_back(before.WordOf(LoopAround(line, std::vector<Side>(2), 0.1 * kBeside)));
    }
    MovingPunctures moving(punctures, {{-100, -100}});
    bool is_short = true;
    for (int step = rng.UniformInt(1, 14); step > 0 && is_short; --step) {
      const auto robot = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(yard.robots) - 1));
      const Point to = random.RandomPlace(rng), from = yard.strings->point(yard.robot(robot));
      bool collides = false;
      for (const auto& [pin, at] : VisiblePins(yard)) {
        if (pin != yard.robot(robot) && at != from && OnSegment(from, to, at)) collides = true;
      }
      ASSERT_EQ(yard.Go(robot, to), !collides) << robot << " to " << to.x << " " << to.y;
      collisions += collides ? 1 : 0;
      if (collides) continue;
      ++moves;
      if (from == to) continue;
      ASSERT_TRUE(moving.Move(ObstacleId(yard.first_robot + robot), to).has_value());
      const Rays rays(moving.punctures(), names);
      for (std::size_t i = 0; i < yard.robots && is_short; ++i) {
        ExpectTaut(yard, i);
        if (testing::Test::HasFatalFailure()) return;
        const auto bends = yard.strings->bends(StringId(i));
        if (yard.strings->length(StringId(i)) == 0) continue;
        const auto carried = moving.Carry(words[i], 0, 0);
        is_short = carried.has_value();
        if (!is_short) break;
        std::vector<Side> sides;
        for (const StringBend& bend : bends) sides.push_back(bend.side);
        const Word now = rays.WordOf(LoopAround(yard.strings->points(StringId(i)), sides, kGap));
        ASSERT_EQ(ToString(RingWord(now), names), ToString(RingWord(*carried), names))
            << "robot " << i << ": " << yard.Bends(i);
        ++compared;
        bent += bends.size() > 2 ? 1 : 0;
        touches += yard.Bends(i).size() > 0 && bends.size() > 4 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moves, 4 * count);
  EXPECT_GT(compared, 10 * count);
  EXPECT_GT(bent, compared / 3);
  EXPECT_GT(touches, compared / 20);
  EXPECT_GT(collisions, count / 4);
}

TEST(TautStrings, TheSameWayBackRestoresAllAndMirrorsAgree) {
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomYard random(rng);
    Yard yard(random.bases(), random.single()), mirror(Mirrored(random.bases()), Mirrored(random.single()));
    std::vector<std::pair<std::size_t, Point>> done;
    std::vector<std::vector<std::string>> states;
    for (int step = rng.UniformInt(1, 14); step > 0; --step) {
      const auto robot = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(yard.robots) - 1));
      const Point to = random.RandomPlace(rng), from = yard.strings->point(yard.robot(robot));
      const std::vector<std::string> before = AllBends(yard);
      const bool went = yard.Go(robot, to);
      ASSERT_EQ(mirror.Go(robot, Mirrored(to)), went);
      if (!went || from == to) continue;
      done.emplace_back(robot, from);
      states.push_back(before);
      for (std::size_t i = 0; i < yard.robots; ++i) {
        std::string text = mirror.Bends(i);
        for (char& c : text) c = c == 'L' ? 'R' : c == 'R' ? 'L' : c;
        ASSERT_EQ(text, yard.Bends(i));
      }
    }
    // A robot does not come back onto its base; what was before it left is out of reach.
    while (!done.empty() && done.back().second != yard.pins[done.back().first]) {
      ASSERT_TRUE(yard.Go(done.back().first, done.back().second));
      ASSERT_EQ(AllBends(yard), states.back());
      done.pop_back();
      states.pop_back();
    }
  }
}

/// The same pins without their grid: far pins make one cell of the whole yard.
TEST(TautStrings, TheGridChangesNothing) {
  const std::int64_t count = ScaledTestCount(300);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<Point> bases, single;
    for (int i = 0; i < 60; ++i) bases.push_back({rng.Uniform(0, 20), rng.Uniform(0, 20)});
    for (int i = 0; i < 60; ++i) single.push_back({rng.Uniform(0, 20), rng.Uniform(0, 20)});
    std::vector<Point> with_far = single;
    with_far.push_back({1e6, 1e6});
    with_far.push_back({-1e6, -1e6});
    single.push_back({100, 100});
    single.push_back({-80, -80});
    Yard fast(bases, single), slow(bases, with_far);
    for (int step = 0; step < 80; ++step) {
      const auto robot = static_cast<std::size_t>(rng.UniformInt(0, 59));
      const Point from = fast.strings->point(fast.robot(robot));
      const Point to = from + Point{rng.Uniform(-4, 4), rng.Uniform(-4, 4)};
      ASSERT_EQ(fast.Go(robot, to), slow.Go(robot, to));
    }
    ASSERT_EQ(AllBends(fast), AllBends(slow));
  }
}

}  // namespace
}  // namespace tautline
