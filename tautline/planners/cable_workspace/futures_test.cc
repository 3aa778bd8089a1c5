#include "tautline/planners/cable_workspace/futures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tautline/geometry/random_rings.h"
#include "tautline/homotopy/print_point.h"
#include "tautline/planners/cable_workspace/best.h"

namespace tautline {
namespace {

Obstacle Block(const std::string& name, Point low, Point high) {
  Obstacle obstacle;
  obstacle.name = name;
  obstacle.polygon = PolygonWithHoles{Rectangle(low, high), {}};
  return obstacle;
}

/// A square room of 10 m with blocks of 2 m, and anchors in its corners:
///
///    4--------3
///    |  a  b  |
///    1--------2
class Room : public testing::Test {
 protected:
  explicit Room(const std::vector<Point>& corners = {{4, 4}}) {
    world_.outline = Rectangle({0, 0}, {10, 10});
    for (const Point p : corners) {
      const std::string name(1, static_cast<char>('a' + world_.obstacles.size()));
      world_.obstacles.push_back(Block(name, p, p + Point{2, 2}));
    }
  }

  void Lay(const std::vector<std::string>& words) {
    ground_.emplace(*CableGround::Prepare(world_));
    anchors_ = *PlaceAnchors(*ground_, points_);
    const std::vector<std::string> names = NamesOf(ground_->space().free_space());
    std::vector<Word> parsed;
    for (const std::string& word : words) parsed.push_back(*ParseWord(word, names));
    boundary_ = BoundaryOfWords(*ground_, anchors_, parsed).value();
  }

  FutureOutcomes Carry(const std::vector<Future>& futures) const {
    const auto prepared = Futures::Prepare(world_, points_, futures);
    return prepared.value().Carry(*ground_, anchors_, boundary_);
  }

  /// One future in which an obstacle moves.
  FutureOutcome Move(const std::string& obstacle, const Polyline& path) const {
    return Carry({{1, {{obstacle, path}}}}).outcomes[0];
  }

  std::vector<std::string> Words(const FutureOutcome& outcome) const {
    std::vector<std::string> words;
    const std::vector<std::string> names = NamesOf(ground_->space().free_space());
    for (const BoundarySide& side : outcome.boundary.value().sides) words.push_back(ToString(side.path.word, names));
    return words;
  }

  std::string ErrorOf(const std::vector<Future>& futures) const {
    const auto prepared = Futures::Prepare(world_, points_, futures);
    return prepared ? "no error" : ToString(prepared.error());
  }

  World world_;
  std::vector<Point> points_{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  std::optional<CableGround> ground_;
  Anchors anchors_;
  WorkspaceBoundary boundary_;
};

/// The lower side runs over the block: 100 m^2 without the trapezium below.
class RoomWithABlock : public Room {
 protected:
  RoomWithABlock() { Lay({"a", "", "a^-1", ""}); }
};

TEST_F(RoomWithABlock, AreasByHand) {
  EXPECT_NEAR(boundary_.area, 64, 1e-9);
  const FutureOutcomes all = Carry({{0.5, {{"a", {{5, 5}, {5.5, 5}}}}},
                                    {0.3, {{"a", {{5, 5}, {5, 6}}}}},
                                    {0.1, {{"a", {{5, 5}, {1.5, 5}}}}},
                                    {0.1, {{"a", {{5, 5}, {5, 1}}}}}});
  ASSERT_EQ(all.outcomes.size(), 4u);
  const std::vector<double> areas{64, 58, 64, 88};
  for (std::size_t i = 0; i < areas.size(); ++i) {
    ASSERT_TRUE(all.outcomes[i].boundary.has_value()) << i;
    EXPECT_NEAR(all.outcomes[i].boundary->area, areas[i], 1e-9) << i;
  }
  EXPECT_NEAR(all.expected_area, 0.5 * 64 + 0.3 * 58 + 0.1 * 64 + 0.1 * 88, 1e-9);
  EXPECT_EQ(all.lost_probability, 0);
  // Between the lower corners, over the block; from anywhere to the corner across, 10 sqrt(2) around nothing.
  ASSERT_EQ(all.longest_cables.size(), 4u);
  EXPECT_NEAR(all.longest_cables[0], 2 * std::sqrt(4 * 4 + 7 * 7) + 2, 1e-9);
  EXPECT_NEAR(all.longest_cables[1], 2 * std::sqrt(4 * 4 + 7 * 7) + 2, 1e-9);
}

TEST_F(RoomWithABlock, AFutureInWhichNothingMovesIsThePresent) {
  for (const std::vector<ObstacleMove>& moves :
       std::vector<std::vector<ObstacleMove>>{{},
                                              {{"a", {{5, 5}}}},
                                              {{"a", {{5, 5}, {2, 2}, {5, 5}}}},
                                              {{"a", {{5, 5}, {6, 7}}}, {"a", {{6, 7}, {5, 5}}}}}) {
    const FutureOutcomes all = Carry({{1, moves}});
    ASSERT_TRUE(all.outcomes[0].boundary.has_value());
    EXPECT_EQ(all.outcomes[0].boundary->ring, boundary_.ring);
    EXPECT_EQ(all.outcomes[0].boundary->length, boundary_.length);
    EXPECT_EQ(all.expected_area, boundary_.area);
    const auto longest = LongestCables(*ground_, anchors_, boundary_);
    for (std::size_t i = 0; i < longest.size(); ++i) EXPECT_EQ(all.longest_cables[i], longest[i].length);
  }
}

TEST_F(RoomWithABlock, PinchedOffByTheWall) {
  const FutureOutcomes all = Carry({{0.75, {{"a", {{5, 5}, {5, 9}}}}}, {0.25, {}}});
  ASSERT_FALSE(all.outcomes[0].boundary.has_value());
  const BoundaryFault& fault = all.outcomes[0].boundary.error();
  EXPECT_EQ(fault.obstruction, WorkspaceObstruction::kNoSuchClass);
  EXPECT_EQ(fault.sides, std::vector<std::size_t>{0});
  EXPECT_EQ(fault.explanation,
            "the side from anchor 1 to anchor 2 is pinched off: it ran between obstacles, or between one and a wall, "
            "where no way is left");
  EXPECT_EQ(fault.curves.size(), 2u) << "the upper side is lost as well, the others are there";
  EXPECT_TRUE(all.outcomes[0].longest.empty());
  EXPECT_EQ(all.lost_probability, 0.75);
  EXPECT_NEAR(all.expected_area, 0.25 * 64, 1e-9);
}

TEST_F(RoomWithABlock, AnObstacleThatCoversAnAnchor) {
  const FutureOutcomes all = Carry({{0.5, {{"a", {{5, 5}, {9.5, 9}}}}}, {0.5, {}}});
  ASSERT_FALSE(all.outcomes[0].boundary.has_value());
  const BoundaryFault& fault = all.outcomes[0].boundary.error();
  EXPECT_EQ(fault.obstruction, WorkspaceObstruction::kAnchorBlocked);
  EXPECT_EQ(ToString(fault.obstruction), "anchor_blocked");
  EXPECT_EQ(fault.sides, std::vector<std::size_t>{2});
  EXPECT_EQ(fault.at, (Point{10, 10}));
  EXPECT_EQ(fault.explanation,
            "anchor 3 (10, 10) stands inside an obstacle or outside: move it onto the boundary of the free ground");
  EXPECT_EQ(all.lost_probability, 0.5);
}

TEST_F(RoomWithABlock, AnObstacleThatLeaves) {
  // Out at the right it drags the cable above it along; nothing is left of the way around it.
  const FutureOutcome right = Move("a", {{5, 5}, {30, 5}});
  ASSERT_FALSE(right.boundary.has_value());
  EXPECT_EQ(right.boundary.error().obstruction, WorkspaceObstruction::kNoSuchClass);
  // Below the cable it leaves the whole room free.
  const FutureOutcome down = Move("a", {{5, 5}, {5, -20}});
  ASSERT_TRUE(down.boundary.has_value());
  EXPECT_NEAR(down.boundary->area, 100, 1e-9);
  EXPECT_EQ(down.boundary->ring, (Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}}));
}

TEST_F(RoomWithABlock, AnObstacleThatTakesAllRoom) {
  world_.obstacles.push_back(Block("lid", {-40, -40}, {-20, -20}));
  Lay({"a", "", "a^-1", ""});
  EXPECT_EQ(ErrorOf({{1, {}}, {1, {{"lid", {{-30, -30}, {5, 5.5}}}}}}),
            "futures[2]: no free ground is left inside the outline: the obstacles cover all of it; lower the clearance "
            "or check the units");
}

TEST_F(RoomWithABlock, MovesThatCannotBeMeant) {
  EXPECT_EQ(ErrorOf({{1, {}}, {1, {{"a", {{5, 5}, {6, 5}}}, {"b", {{5, 5}, {6, 5}}}}}}),
            "futures[2].moves[2]: there is no obstacle 'b': name one of world.obstacles");
  EXPECT_EQ(ErrorOf({{1, {{"a", {}}}}}), "futures[1].moves[1]: path has 0 points: it needs 1 or more");
  EXPECT_EQ(
      ErrorOf({{1, {{"a", {{5, 7}, {6, 5}}}}}}),
      "futures[1].moves[1]: the path of 'a' must start inside of the obstacle, where it is by then, not at (5, 7)");
  EXPECT_EQ(ErrorOf({{1, {{"a", {{5, 5}, {6, 5}}}, {"a", {{4.5, 5}, {6, 5}}}}}}),
            "futures[1].moves[2]: the path of 'a' must start inside of the obstacle, where it is by then, not at (4.5, "
            "5)");
  EXPECT_EQ(ErrorOf({{1, {{"a", {{5, 5}, {5, 1e300}}}}}}),
            "futures[1].moves[1]: path[2] is 1e+300: coordinates go up to 1e7 metres; move the origin nearer or check "
            "the units");
  EXPECT_EQ(ErrorOf({{1, {{"a", {{5, 5}, {NAN, 5}}}}}}),
            "futures[1].moves[1]: path[2] is not a number: coordinates must be finite");
  EXPECT_EQ(
      ErrorOf({{1, {{"a", {{5, 5}, {15, 15}}}}}}),
      "futures[1].moves[1]: the representative of 'a' moves exactly through anchor 3 at (10, 10): lead it past on "
      "the side that is meant");
  world_.obstacles[0].representative = Point{4.5, 5};
  EXPECT_EQ(ErrorOf({{1, {{"a", {{5, 5}, {6, 5}}}}}}),
            "futures[1].moves[1]: the path of 'a' must start where its representative is by then, at (4.5, 5), not at "
            "(5, 5)");
  EXPECT_EQ(ErrorOf({{1, {{"a", {{4.5, 5}, {6, 5}}}, {"a", {{6, 5}, {6, 6}}}}}}), "no error");
}

TEST_F(RoomWithABlock, StopsWhenAsked) {
  const std::vector<Future> futures(2, Future{0.5, {}});
  double last = -1;
  const Watcher watch = [&last](std::string_view, double share) {
    EXPECT_GE(share, last);
    last = share;
    return share < 0.5;
  };
  const auto prepared = Futures::Prepare(world_, points_, futures, watch);
  ASSERT_FALSE(prepared.has_value());
  EXPECT_EQ(prepared.error().code, ErrorCode::kStopped);
  EXPECT_GE(last, 0.5);
}

/// The lower side runs over a and under b.
class RoomWithTwoBlocks : public Room {
 protected:
  RoomWithTwoBlocks() : Room({{1.5, 4}, {6, 4}}) { Lay({"a", "", "a^-1", ""}); }
};

TEST_F(RoomWithTwoBlocks, PinchedOffBetweenObstacles) {
  const FutureOutcome near = Move("b", {{7, 5}, {4.6, 5}});
  EXPECT_TRUE(near.boundary.has_value());
  const FutureOutcome together = Move("b", {{7, 5}, {4, 5}});
  ASSERT_FALSE(together.boundary.has_value());
  EXPECT_EQ(together.boundary.error().obstruction, WorkspaceObstruction::kNoSuchClass);
  EXPECT_EQ(together.boundary.error().sides, std::vector<std::size_t>{0});
}

TEST_F(RoomWithTwoBlocks, WordsAreCarriedPastEachOther) {
  // b over a to its left: the side between them goes over a still, and comes to b's left side from below.
  const FutureOutcome over = Move("b", {{7, 5}, {7, 8}, {1.2, 8}});
  EXPECT_EQ(Words(over), (std::vector<std::string>{"a", "", "a^-1", ""}));
  EXPECT_EQ(over.boundary->ring.size(), 8u) << "under b, which has a of its own column below it";
  // Under a: b takes the cable along, which comes from over a, to a's left side again.
  const FutureOutcome under = Move("b", {{7, 5}, {7, 2}, {1.2, 2}});
  EXPECT_EQ(Words(under), (std::vector<std::string>{"b a b^-1", "", "b a^-1 b^-1", ""}));
  // a to the right of b, over it and under it.
  EXPECT_EQ(Words(Move("a", {{2.5, 5}, {2.5, 8}, {8, 8}})),
            (std::vector<std::string>{"b a b^-1", "", "b a^-1 b^-1", ""}));
  EXPECT_EQ(Words(Move("a", {{2.5, 5}, {2.5, 2}, {8, 2}})), (std::vector<std::string>{"a", "", "a^-1", ""}));
}

TEST_F(RoomWithTwoBlocks, ObstaclesThatPartAgain) {
  // a drives into b and on, out of it on the other side, above b's middle: the same as passing over it.
  const FutureOutcome through = Move("a", {{2.5, 5}, {7, 5.1}, {8.7, 7}, {8.7, 8.2}});
  const FutureOutcome over = Move("a", {{2.5, 5}, {2.5, 8.2}, {8.7, 8.2}});
  ASSERT_TRUE(over.boundary.has_value());
  ASSERT_TRUE(through.boundary.has_value());
  EXPECT_EQ(through.boundary->ring, over.boundary->ring);
}

TEST_F(RoomWithTwoBlocks, ThroughTheRepresentativeOfAnotherIsAnError) {
  EXPECT_EQ(ErrorOf({{1, {{"b", {{7, 5}, {9, 5}, {7, 5}}}, {"a", {{2.5, 5}, {8, 5}}}}}}),
            "futures[1].moves[2]: the representative of 'a' moves exactly through that of 'b' at (7, 5): lead it past "
            "on the side that is meant");
}

TEST_F(RoomWithTwoBlocks, MovesComeInTheirOrder) {
  // b makes room before a comes, or a is over b first.
  const ObstacleMove b_leaves{"b", {{7, 5}, {7, 1.5}}}, a_comes{"a", {{2.5, 5}, {8.5, 4}}};
  const FutureOutcomes all = Carry({{0.5, {b_leaves, a_comes}}, {0.5, {a_comes, b_leaves}}});
  EXPECT_EQ(Words(all.outcomes[0])[0], "b a b^-1");
  EXPECT_EQ(Words(all.outcomes[1])[0], "a");
}

/// Three blocks in a row, over the first of which the lower side runs.
class RoomWithThreeBlocks : public Room {
 protected:
  RoomWithThreeBlocks() : Room({{1, 4}, {4, 4}, {7, 4}}) { Lay({"a", "", "a^-1", ""}); }

  /// The left block over the middle one, then the right one over the new middle one, and so on.
  static Future Plait(int turns) {
    Future future{1, {}};
    std::array<std::string, 3> order{"a", "b", "c"};
    for (int i = 0; i < turns; ++i) {
      const bool from_left = i % 2 == 0;
      const Point outer = from_left ? Point{2, 5} : Point{8, 5}, middle{5, 5}, beside{from_left ? 6.5 : 3.5, 8};
      std::string& outer_name = order[from_left ? 0 : 2];
      future.moves.push_back({outer_name, {outer, {outer.x, 8}, beside}});
      future.moves.push_back({order[1], {middle, outer}});
      future.moves.push_back({outer_name, {beside, middle}});
      std::swap(outer_name, order[1]);
    }
    return future;
  }
};

TEST_F(RoomWithThreeBlocks, WordsGrowByFactors) {
  const FutureOutcomes few = Carry({Plait(9)});
  ASSERT_TRUE(few.outcomes[0].boundary.has_value());
  EXPECT_GT(few.outcomes[0].boundary->sides[0].path.word.size(), 100u);
  // A boundary is pulled, not cut: its area is never larger than the room.
  EXPECT_LT(few.expected_area, 100 - 3 * 4);
  const FutureOutcomes many = Carry({Plait(60)});
  ASSERT_FALSE(many.outcomes[0].boundary.has_value());
  EXPECT_EQ(many.outcomes[0].boundary.error().obstruction, WorkspaceObstruction::kTooTangled);
  EXPECT_EQ(many.outcomes[0].boundary.error().explanation,
            "the side from anchor 1 to anchor 2 cannot be followed: the obstacles that move wind it around each other "
            "so often that its word grows to thousands of letters");
  EXPECT_EQ(many.lost_probability, 1);
}

// The best boundary now need not be the best one to expect.
TEST_F(RoomWithThreeBlocks, EveryBoundaryUpToALength) {
  const BoundaryList list = FindBoundaries(*ground_, anchors_, {.max_boundary = 60});
  ASSERT_TRUE(list.complete);
  ASSERT_GT(list.boundaries.size(), 3u);
  const std::vector<Future> moves{{0.25, {}}, {0.75, {{"b", {{5, 5}, {5, 1}}}}}};
  const auto futures = Futures::Prepare(world_, points_, moves);
  BoundaryCarrier carrier(*futures, *ground_, anchors_);
  std::size_t best = 0;
  double best_area = 0;
  for (std::size_t i = 0; i < list.boundaries.size(); ++i) {
    const FutureOutcomes all = carrier.Carry(list.boundaries[i], {.longest_cables = false});
    ASSERT_TRUE(all.outcomes[0].boundary.has_value());
    EXPECT_EQ(all.outcomes[0].boundary->ring, list.boundaries[i].ring);
    const double then = all.outcomes[1].boundary ? all.outcomes[1].boundary->area : 0;
    EXPECT_NEAR(all.expected_area, 0.25 * list.boundaries[i].area + 0.75 * then, 1e-9);
    if (all.expected_area <= best_area) continue;
    best = i;
    best_area = all.expected_area;
  }
  EXPECT_GT(best_area, 0);
  EXPECT_LT(list.boundaries[best].area, list.boundaries[0].area + 1e-9);
}

/// a and b stand together now, and are one island; c stands in the wall.
class RoomWithATwin : public Room {
 protected:
  RoomWithATwin() : Room({{2, 4}, {4, 4}, {9, 4}}) { Lay({"a", "", "a^-1", ""}); }
};

TEST_F(RoomWithATwin, ObstaclesThatPartAreBothBelowTheSideStill) {
  ASSERT_EQ(ground_->space().free_space().islands.size(), 1u);
  // The lower side bends over both, the right one around c.
  const FutureOutcome apart = Move("b", {{5, 5}, {6, 5}});
  ASSERT_TRUE(apart.boundary.has_value());
  EXPECT_NEAR(apart.boundary->area, 100 - 0.5 * 6 * (10 + 5) - 0.5 * 1 * (10 + 2), 1e-9);
  EXPECT_EQ(apart.boundary->sides[0].path.word.size(), 2u);
  const FutureOutcome other = Move("a", {{3, 5}, {2, 2}});
  ASSERT_TRUE(other.boundary.has_value());
  EXPECT_EQ(other.boundary->sides[0].path.word.size(), 2u);
}

TEST_F(RoomWithATwin, WhatWasAWallMayBecomeAnIsland) {
  // Into the room below the side from 2 to 3, which then runs around it: right of it there is no cable.
  const FutureOutcome outcome = Move("c", {{9.5, 5}, {8, 5}});
  ASSERT_TRUE(outcome.boundary.has_value());
  const TautPath& side = outcome.boundary->sides[1].path;
  EXPECT_EQ(side.points, (Polyline{{10, 0}, {7.5, 4}, {7.5, 6}, {10, 10}}));
}

TEST_F(RoomWithABlock, ManyBoundariesShareTheirSides) {
  const std::vector<Future> moves{{0.5, {{"a", {{5, 5}, {5, 6}}}}}, {0.5, {}}};
  const auto futures = Futures::Prepare(world_, points_, moves);
  BoundaryCarrier carrier(*futures, *ground_, anchors_);
  const FutureOutcomes first = carrier.Carry(boundary_), again = carrier.Carry(boundary_);
  const FutureOutcomes alone = futures->Carry(*ground_, anchors_, boundary_);
  const FutureOutcomes areas = carrier.Carry(boundary_, {.longest_cables = false});
  for (const FutureOutcomes* other : {&again, &alone, &areas}) {
    EXPECT_EQ(first.expected_area, other->expected_area);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(first.outcomes[i].boundary->ring, other->outcomes[i].boundary->ring);
    }
  }
  EXPECT_EQ(again.longest_cables, first.longest_cables);
  EXPECT_TRUE(areas.longest_cables.empty());
}

}  // namespace
}  // namespace tautline
