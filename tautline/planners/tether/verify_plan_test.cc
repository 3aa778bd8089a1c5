#include "tautline/planners/tether/verify_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

/// A plan with a bend in the path, a bend in the tether and a rejected motion, to be spoilt.
class VerifyPlanTest : public testing::Test {
 protected:
  VerifyPlanTest()
      : sketch_(Sketch({".......",  //
                        "...w...",  //
                        "B..w...",  //
                        "G..w...",  //
                        ".......",  //
                        ".......",  //
                        "......R"})),
        planner_(TetherPlanner::Prepare(sketch_.world).value()),
        tether_{sketch_['B'], 10.2, Polyline{sketch_['B'], {3, 6.5}, {6.5, 6.5}, sketch_['R']}},
        result_(planner_.Plan(tether_, sketch_['G'])) {}

  bool Accepts(const PlanResult& result) const { return VerifyPlan(planner_, tether_, sketch_['G'], result).ok(); }

  /// Whether the plan is accepted after `spoil` has been at it.
  bool AcceptsSpoilt(const std::function<void(PlanResult&)>& spoil) const {
    PlanResult result = result_;
    spoil(result);
    return Accepts(result);
  }

  /// A curve with the length and the word that go with its points.
  TautPath Path(Polyline points) const { return planner_.space().MakePath(std::move(points)); }

  SketchedScene sketch_;
  TetherPlanner planner_;
  Tether tether_;
  PlanResult result_;
};

TEST_F(VerifyPlanTest, AcceptsThePlan) {
  ASSERT_EQ(result_.status, PlanStatus::kSolved);
  ASSERT_TRUE(result_.rejected);
  ASSERT_EQ(result_.motion->path.points.size(), 4U);
  const Verification verification = VerifyPlan(planner_, tether_, sketch_['G'], result_);
  EXPECT_TRUE(verification.ok());
  EXPECT_GE(verification.curves, 5);
  EXPECT_GT(verification.samples, 20);
}

TEST_F(VerifyPlanTest, RejectsAMovedPoint) {
  for (const Point shift : {Point{0, 1e-3}, Point{0, -1e-3}, Point{1e-3, 0}, Point{-1e-3, 0}}) {
    for (std::size_t i = 0; i < result_.motion->path.points.size(); ++i) {
      EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) {
        Polyline points = result.motion->path.points;
        points[i] = points[i] + shift;
        result.motion->path = Path(points);
      })) << i;
    }
  }
}

TEST_F(VerifyPlanTest, RejectsABendInOpenGround) {
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) {
    Polyline points = result.motion->path.points;
    points.insert(points.begin() + 1, Lerp(points[0], points[1], 0.5) + Point{0.01, 0.01});
    result.motion->path = Path(points);
  }));
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) {
    Polyline points = result.motion->path.points;
    points.insert(points.begin() + 1, points[0]);
    result.motion->path = Path(points);
  })) << "a repeated point";
}

TEST_F(VerifyPlanTest, RejectsABendAwayFromTheObstacle) {
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) {
    result.motion->path = Path({sketch_['R'], {4, 6}, {4, 3}, sketch_['G']});
  }));
}

TEST_F(VerifyPlanTest, RejectsAWrongLength) {
  EXPECT_FALSE(AcceptsSpoilt([](PlanResult& result) { result.motion->path.length += 1e-3; }));
  EXPECT_FALSE(AcceptsSpoilt([](PlanResult& result) { result.motion->tether.length -= 1e-3; }));
  EXPECT_FALSE(AcceptsSpoilt([](PlanResult& result) { result.start.length -= 1e-3; }));
}

TEST_F(VerifyPlanTest, RejectsAWrongWord) {
  const Letter letter{ObstacleId(std::int32_t{0}), false};
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) { result.motion->path.word.Append(letter); }));
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) { result.motion->tether.word.Append(letter); }));
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) { result.start.word.Append(letter); }));
}

TEST_F(VerifyPlanTest, RejectsAnotherClass) {
  const ClassList tethers =
      FindClasses(planner_.space(), sketch_['B'], sketch_['G'], {.max_length = {}, .max_count = 3});
  const ClassList paths = FindClasses(planner_.space(), sketch_['R'], sketch_['G'], {.max_length = {}, .max_count = 3});
  for (const TautPath& tether : tethers.classes) {
    for (const TautPath& path : paths.classes) {
      const bool same = tether.word == result_.motion->tether.word && path.word == result_.motion->path.word;
      EXPECT_EQ(AcceptsSpoilt([&](PlanResult& result) { result.motion = Motion{path, tether}; }), same);
    }
  }
}

TEST_F(VerifyPlanTest, RejectsAStartThatIsNotTheLaidCable) {
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) { result.start = Path({sketch_['B'], {3, 3}, sketch_['R']}); }));
}

TEST_F(VerifyPlanTest, RejectsATetherBeyondTheLimit) {
  EXPECT_FALSE(AcceptsSpoilt([&](PlanResult& result) { std::swap(result.motion, result.rejected); }));
  EXPECT_FALSE(AcceptsSpoilt([](PlanResult& result) { result.limit = 9; })) << "too long at the start";
}

TEST_F(VerifyPlanTest, RejectsAReasonThatDoesNotHold) {
  for (const PlanObstruction obstruction :
       {PlanObstruction::kNone, PlanObstruction::kStartBlocked, PlanObstruction::kGoalBlocked,
        PlanObstruction::kGoalUnreachable, PlanObstruction::kLaidCableBlocked, PlanObstruction::kLaidCableTooLong,
        PlanObstruction::kTetherTooShort}) {
    PlanResult result;
    result.status = PlanStatus::kInfeasible;
    result.obstruction = obstruction;
    result.limit = result_.limit;
    result.start = result_.start;
    EXPECT_FALSE(Accepts(result)) << ToString(obstruction);
  }
}

TEST_F(VerifyPlanTest, AcceptsReasonsThatHold) {
  const Point inside{3.5, 5}, free = sketch_['R'];
  const auto accepts = [&](const Tether& tether, Point goal, PlanObstruction expected) {
    const PlanResult result = planner_.Plan(tether, goal);
    EXPECT_EQ(result.obstruction, expected);
    return VerifyPlan(planner_, tether, goal, result).ok();
  };
  const Point base = sketch_['B'];
  EXPECT_TRUE(accepts(tether_, inside, PlanObstruction::kGoalBlocked));
  EXPECT_TRUE(accepts({inside, 9, {}}, free, PlanObstruction::kStartBlocked));
  EXPECT_TRUE(accepts({base, 9, Polyline{base, {2, 6.5}, inside}}, free, PlanObstruction::kStartBlocked));
  EXPECT_TRUE(accepts({base, 9, Polyline{base, {6, 4.5}}}, free, PlanObstruction::kLaidCableBlocked));
  EXPECT_TRUE(accepts({base, 9, tether_.laid}, free, PlanObstruction::kLaidCableTooLong));
  EXPECT_TRUE(accepts({base, 3, {}}, free, PlanObstruction::kTetherTooShort));
}

TEST(VerifyPlan, RejectsAStubThroughAWall) {
  World world;
  world.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  world.obstacles = {{.name = "bar", .polygon = PolygonWithHoles{{{2, 0.8}, {8, 0.8}, {8, 0.9}, {2, 0.9}}}}};
  world.clearance = 0.5;
  const auto planner = TetherPlanner::Prepare(world).value();
  const Tether tether{{5, 0.6}, 20, {}};
  const Point goal{5, 5};
  const PlanResult result = planner.Plan(tether, goal);
  ASSERT_EQ(result.status, PlanStatus::kSolved) << "out to the side";
  EXPECT_TRUE(VerifyPlan(planner, tether, goal, result).ok());
  const TautPath through = planner.space().MakePath({tether.base, {5, 1.4}, goal});
  EXPECT_THAT(CurveFaults(planner.space().free_space(), through, &planner.ungrown_space()),
              testing::Contains("leaves its socket"));
}

TEST_F(VerifyPlanTest, RejectsASolutionWithoutAMotion) {
  EXPECT_FALSE(AcceptsSpoilt([](PlanResult& result) { result.motion.reset(); }));
}

}  // namespace
}  // namespace tautline
