#include "tautline/planners/cable_workspace/move.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/test_scale.h"
#include "tautline/planners/cable_workspace/random_workspace.h"

namespace tautline {
namespace {

using ::testing::HasSubstr;

/// A square room with a block in the middle, four winches in its corners and the robot below the block.
struct Room {
  CableGround ground;
  Anchors anchors;
  WorkspaceBoundary boundary;
};

Room BlockRoom() {
  World world{.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  world.obstacles.push_back({.name = "block", .polygon = PolygonWithHoles{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}}});
  const std::vector<Point> points{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  std::vector<Polyline> laid;
  for (const Point p : points) laid.push_back({{5, 1}, p});
  auto ground = CableGround::Prepare(world).value();
  auto anchors = PlaceAnchors(ground, points).value();
  auto boundary = BoundaryOfCables(ground, anchors, laid).value();
  return {std::move(ground), std::move(anchors), std::move(boundary)};
}

/// The taut cable to a place of the path: pulled from scratch in the class of the path up to there.
Polyline CableFromScratch(const WorkspaceRegion& region, std::size_t anchor, const Move& move, std::size_t piece,
                          Point robot) {
  const TautSpace& space = region.ground().space();
  const std::vector<Walk> ways = region.WaysTo(move.path.points.front());
  std::optional<Walk> walk = ways[ShortestPath(region, ways, region.WaysTo(move.path.points.back())).from];
  Polyline points(move.path.points.begin(), move.path.points.begin() + static_cast<std::ptrdiff_t>(piece) + 1);
  points.push_back(robot);
  TAUTLINE_CHECK(!space.Follow(points, walk));
  return space.Pull(region.CableTo(anchor, *walk)).points;
}

TEST(PlanMove, GoesAroundTheBlockOnTheSideOfTheCables) {
  const Room room = BlockRoom();
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  const auto move = PlanMove(region, {1, 7}, {9, 7});
  ASSERT_TRUE(move);
  EXPECT_EQ(move->path.points, (Polyline{{1, 7}, {4, 4}, {6, 4}, {9, 7}}));
  EXPECT_NEAR(move->path.length, 10.48528137423857, 1e-12);
  EXPECT_NEAR(move->duration_s, 10.48528137423857, 1e-12);
  EXPECT_FALSE(move->outside);
  // At first the cable of winch 3, (10, 10), goes around both lower corners of the block.
  const MoveSample start = SampleAt(*move, 0, 0);
  EXPECT_EQ(start.corners[2], (Point{4, 4}));
  EXPECT_NEAR(start.lengths[2], std::hypot(3, 3) + 2 + std::hypot(4, 6), 1e-12);
  EXPECT_NEAR(start.rates[2], -1, 1e-12);
  EXPECT_NEAR(start.rates[0], (1 - 7) / std::hypot(1, 7) / std::sqrt(2), 1e-12);
}

TEST(PlanMove, SaysWhatIsOutside) {
  const Room room = BlockRoom();
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  const auto start = PlanMove(region, {5, 8}, {5, 1}), goal = PlanMove(region, {5, 1}, {5, 5});
  ASSERT_FALSE(start);
  EXPECT_EQ(start.error().obstruction, WorkspaceObstruction::kStartOutside);
  EXPECT_THAT(start.error().explanation, HasSubstr("the start (5, 8) is outside of the workspace"));
  ASSERT_FALSE(goal);
  EXPECT_EQ(goal.error().obstruction, WorkspaceObstruction::kGoalOutside);
}

TEST(PlanMove, ToWhereTheRobotIsTakesNoTime) {
  const Room room = BlockRoom();
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  for (const auto& acceleration : {std::optional<double>(), std::optional<double>(1)}) {
    const auto move = PlanMove(region, {5, 1}, {5, 1}, {.acceleration = acceleration});
    ASSERT_TRUE(move);
    EXPECT_EQ(move->duration_s, 0);
    const auto samples = SampleMove(*move, 0.1);
    ASSERT_EQ(samples.size(), 1u);
    EXPECT_EQ(samples[0].speed, 0);
    EXPECT_EQ(samples[0].rates, (std::vector<double>{0, 0, 0, 0}));
    EXPECT_NEAR(samples[0].lengths[0], std::sqrt(26), 1e-12);
  }
}

TEST(PlanMove, AlongACableAndThroughItsCorner) {
  // To the corner of the block on the straight cable of winch 4, and beyond.
  const Room room = BlockRoom();
  const WorkspaceRegion region(room.ground, room.anchors, room.boundary);
  const auto move = PlanMove(region, {8, 2}, {2, 6}, {.speed = 2});
  ASSERT_TRUE(move);
  for (const MoveSample& sample : SampleMove(*move, 0.01)) {
    const double distance = Distance(sample.robot, sample.corners[3]);
    const double to_corner = sample.corners[3] == Point{10, 0} ? 0 : Distance({10, 0}, sample.corners[3]);
    EXPECT_NEAR(sample.lengths[3], distance + to_corner, 1e-12);
    EXPECT_LE(std::abs(sample.rates[3]), 2 * (1 + 1e-12));
  }
}

TEST(PlanMove, MayLeaveAWorkspaceOnlyAtAWinchInTheOpen) {
  // The second winch stands in the middle of a room, the boundary runs over it, and the path below.
  const World world{.outline = {{0, 0}, {10, 0}, {10, 8}, {0, 8}}};
  const std::vector<Point> points{{0, 0}, {5, 4}, {10, 0}, {10, 8}, {0, 8}};
  std::vector<Polyline> laid;
  for (const Point p : points) laid.push_back({{5, 6}, p});
  const auto ground = CableGround::Prepare(world).value();
  const auto anchors = PlaceAnchors(ground, points).value();
  const auto boundary = BoundaryOfCables(ground, anchors, laid).value();
  const WorkspaceRegion region(ground, anchors, boundary);
  const auto below = PlanMove(region, {1, 2}, {9, 2}), above = PlanMove(region, {1, 6}, {9, 4});
  ASSERT_TRUE(below && above);
  EXPECT_EQ(below->path.length, 8);
  ASSERT_TRUE(below->outside);
  EXPECT_NEAR(Distance(*below->outside, {2.5, 2}), 0, 1e-12);
  EXPECT_FALSE(above->outside);
}

TEST(CheckMoveOptions, RefusesWhatCannotBeMeant) {
  EXPECT_TRUE(CheckMoveOptions({}, 4));
  EXPECT_TRUE(CheckMoveOptions({.winch_limits = {1, 2, 3, 4}}, 4));
  EXPECT_FALSE(CheckMoveOptions({.speed = 0}, 4));
  EXPECT_FALSE(CheckMoveOptions({.speed = std::nan("")}, 4));
  EXPECT_FALSE(CheckMoveOptions({.acceleration = -1}, 4));
  EXPECT_FALSE(CheckMoveOptions({.winch_limits = {1, 2}}, 4));
  EXPECT_FALSE(CheckMoveOptions({.winch_limits = {1, 0, 1, 1}}, 4));
}

/// Workspaces, moves in them and options, all random.
class RandomMoves : public ::testing::TestWithParam<bool> {
 protected:
  template <class Visit>
  void ForEach(std::uint64_t seed, std::int64_t count, Visit visit) {
    Rng rng(seed);
    for (std::int64_t i = ScaledTestCount(count); i > 0; --i) {
      RandomWorkspace workspace = MakeRandomWorkspace(rng, GetParam());
      const WorkspaceRegion& region = RegionOf(workspace);
      for (int k = 0; k < 5; ++k) {
        const Point start = RandomPlaceInside(rng, region), goal = RandomPlaceInside(rng, region);
        MoveOptions options{.speed = rng.Uniform(0.2, 3)};
        if (rng.UniformInt(0, 1) == 0) options.acceleration = rng.Uniform(0.1, 2);
        const int limited = rng.UniformInt(0, 2);
        if (limited == 1) options.winch_limits = {rng.Uniform(0.05, 2)};
        for (std::size_t w = 0; limited == 2 && w < region.anchors().size(); ++w) {
          options.winch_limits.push_back(rng.Uniform(0.05, 2));
        }
        SCOPED_TRACE(::testing::Message() << "seed " << seed << ", left " << i << ", move " << k << " from (" << start.x
                                          << ", " << start.y << ") to (" << goal.x << ", " << goal.y << ")");
        const auto move = PlanMove(region, start, goal, options);
        ASSERT_TRUE(move);
        visit(region, *move, options);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }
};

TEST_P(RandomMoves, LengthsAndCornersAreThoseOfCablesPulledFromScratch) {
  int bent = 0;
  ForEach(11, 60, [&](const WorkspaceRegion& region, const Move& move, const MoveOptions&) {
    for (std::size_t k = 0; k < move.pieces.size(); ++k) {
      for (int step = 1; step < 12; ++step) {
        const MoveSample sample = SampleAt(move, k, move.pieces[k].profile.length_m() * step / 12.0);
        const std::vector<Polyline> cables = CablesAt(move, k, move.pieces[k].profile.length_m() * step / 12.0);
        for (std::size_t i = 0; i < sample.lengths.size(); ++i) {
          EXPECT_NEAR(Length(cables[i]) + region.anchors()[i].stub_length, sample.lengths[i], 1e-9);
          EXPECT_EQ(cables[i].front(), region.anchors()[i].exit.point);
          EXPECT_EQ(cables[i].back(), sample.robot);
          const Polyline cable = CableFromScratch(region, i, move, k, sample.robot);
          const double length = Length(cable) + region.anchors()[i].stub_length;
          ASSERT_NEAR(sample.lengths[i], length, 1e-9);
          // Where the last edge is straight or has no length, either end of it is the corner.
          const Point corner = cable.size() > 1 ? cable[cable.size() - 2] : cable[0];
          const bool straight = std::abs(Distance(sample.robot, corner) + Distance(corner, sample.corners[i]) -
                                         Distance(sample.robot, sample.corners[i])) < 1e-9 ||
                                std::abs(Distance(sample.robot, sample.corners[i]) +
                                         Distance(corner, sample.corners[i]) - Distance(sample.robot, corner)) < 1e-9;
          EXPECT_TRUE(corner == sample.corners[i] || straight);
          bent += cable.size() > 2 ? 1 : 0;
        }
      }
    }
  });
  EXPECT_GT(bent, 0);
}

TEST_P(RandomMoves, RatesAreTheDifferencesOfLengths) {
  std::int64_t compared = 0;
  ForEach(12, 60, [&](const WorkspaceRegion&, const Move& move, const MoveOptions&) {
    for (const MovePiece& piece : move.pieces) {
      const std::size_t k = static_cast<std::size_t>(&piece - move.pieces.data());
      const double duration = piece.profile.duration_s(), h = 1e-5 * duration;
      if (duration < 1e-3) continue;
      for (int step = 1; step < 20; ++step) {
        const double t = duration * step / 20.0;
        const auto at = [&](double time) { return SampleAt(move, k, piece.profile.At(time).distance); };
        const MoveSample before = at(t - h), sample = at(t), after = at(t + h);
        // The acceleration jumps between.
        if (std::abs(before.speed + after.speed - 2 * sample.speed) > 1e-9) continue;
        for (std::size_t i = 0; i < sample.rates.size(); ++i) {
          // A corner nearer than the difference reaches bends the length as much as one on the way.
          if (before.corners[i] != after.corners[i] || Distance(sample.robot, sample.corners[i]) < 0.05) continue;
          EXPECT_NEAR((after.lengths[i] - before.lengths[i]) / (2 * h), sample.rates[i], 1e-6);
          ++compared;
        }
      }
    }
  });
  EXPECT_GT(compared, ScaledTestCount(1000));
}

TEST_P(RandomMoves, SwitchWhereBisectionFindsTheSwitch) {
  std::int64_t found = 0;
  ForEach(13, 60, [&](const WorkspaceRegion& region, const Move& move, const MoveOptions&) {
    for (const CornerSwitch& s : move.switches) {
      const MovePiece& piece = move.pieces[s.piece];
      const double length = piece.profile.length_m();
      if (s.distance_m < 1e-6 * length || s.distance_m > (1 - 1e-6) * length) continue;
      // Before the switch the last bend is `from`, after it `to`; where both are in line the robot is nearer to one.
      const auto after = [&](double distance) {
        const Point robot = Lerp(piece.from, piece.to, distance / length);
        const Polyline cable = CableFromScratch(region, s.anchor, move, s.piece, robot);
        const Point corner = cable.size() > 1 ? cable[cable.size() - 2] : cable[0];
        return corner == s.to || (corner != s.from && distance > s.distance_m);
      };
      double low = std::max(0.0, s.distance_m - 1e-3 * length), high = std::min(length, s.distance_m + 1e-3 * length);
      if (after(low) || !after(high)) continue;  // Another switch is too near.
      while (high - low > 1e-9 * length) (after(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
      EXPECT_NEAR(low, s.distance_m, 1e-6 * length);
      EXPECT_NEAR(piece.begin_s + piece.profile.TimeAt(low), s.t_s, 1e-4 * (1 + move.duration_s));
      ++found;
    }
  });
  EXPECT_GT(found, 0);
}

TEST_P(RandomMoves, NeverExceedAnyLimit) {
  std::int64_t reached = 0;
  ForEach(14, 60, [&](const WorkspaceRegion&, const Move& move, const MoveOptions& options) {
    bool at_limit = false;
    for (const MoveSample& sample : SampleMove(move, std::max(move.duration_s, 1e-9) / 500)) {
      EXPECT_LE(sample.speed, options.speed * (1 + 1e-12));
      for (std::size_t i = 0; i < sample.rates.size(); ++i) {
        EXPECT_LE(std::abs(sample.rates[i]), sample.speed * (1 + 1e-12));
        if (options.winch_limits.empty()) continue;
        const double limit = options.winch_limits[options.winch_limits.size() == 1 ? 0 : i];
        EXPECT_LE(std::abs(sample.rates[i]), limit * (1 + 1e-12));
        at_limit = at_limit || std::abs(sample.rates[i]) > limit * (1 - 1e-9);
      }
      at_limit = at_limit || sample.speed > options.speed * (1 - 1e-9);
    }
    reached += at_limit ? 1 : 0;
  });
  EXPECT_GT(reached, 0);
}

TEST_P(RandomMoves, SamplesAreInOrderAndHoldAllThatHappens) {
  ForEach(15, 60, [&](const WorkspaceRegion& region, const Move& move, const MoveOptions&) {
    const auto samples = SampleMove(move, std::max(move.duration_s, 1e-9) / 37);
    EXPECT_EQ(samples.front().t_s, 0);
    EXPECT_EQ(samples.back().t_s, move.duration_s);
    EXPECT_EQ(samples.front().robot, move.path.points.front());
    EXPECT_EQ(samples.back().robot, move.path.points.back());
    for (std::size_t i = 1; i < samples.size(); ++i) EXPECT_LT(samples[i - 1].t_s, samples[i].t_s);
    const auto has = [&](double t) {
      return std::any_of(samples.begin(), samples.end(), [t](const MoveSample& sample) { return sample.t_s == t; });
    };
    for (const MovePiece& piece : move.pieces) EXPECT_TRUE(has(piece.begin_s));
    for (const CornerSwitch& s : move.switches) EXPECT_TRUE(has(s.t_s));
    EXPECT_GE(samples.size(), move.duration_s > 0 ? 38u : 1u);
    for (const MoveSample& sample : samples) ASSERT_EQ(sample.lengths.size(), region.anchors().size());
  });
}

TEST_P(RandomMoves, PathsAreAsLongBackAndNeverShorterThanStraight) {
  std::int64_t straight = 0;
  ForEach(16, 100, [&](const WorkspaceRegion& region, const Move& move, const MoveOptions& options) {
    const Point start = move.path.points.front(), goal = move.path.points.back();
    const auto back = PlanMove(region, goal, start, options);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->path.length, move.path.length, 1e-9);
    EXPECT_NEAR(back->duration_s, move.duration_s, 1e-9 * (1 + move.duration_s));
    EXPECT_GE(move.path.length, Distance(start, goal) * (1 - 1e-12));
    // All winches stand on walls.
    EXPECT_FALSE(move.outside);
    EXPECT_NEAR(move.pieces.back().begin_m + move.pieces.back().profile.length_m(), move.path.length, 1e-9);
    if (FirstOutside(region, Polyline{start, goal}) || move.outside) return;
    // Seen from each other within a workspace without obstacles inside; sheets apart where the boundary touches itself.
    if (region.WaysTo(start).size() > 1 || region.WaysTo(goal).size() > 1 || move.path.points.size() > 2) return;
    EXPECT_NEAR(move.path.length, Distance(start, goal), 1e-12 * (1 + move.path.length));
    ++straight;
  });
  EXPECT_GT(straight, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RandomMoves, ::testing::Bool());

}  // namespace
}  // namespace tautline
