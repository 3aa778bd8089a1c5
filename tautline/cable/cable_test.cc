#include "tautline/cable/cable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/base/double_bits.h"
#include "tautline/base/test_scale.h"
#include "tautline/cable/random_drive.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/sketched_scene.h"

namespace tautline {
namespace {

constexpr double kStep = 0.05;

TautSpace Hall() { return TautSpace(SpaceOf(Sketch({".......", ".......", ".......", "......."}))); }

TautSpace HallWithPillar() { return TautSpace(SpaceOf(Sketch({".......", "...a...", "...a...", "......."}))); }

/// Drives straight to a point in steps; says how the last one ended.
StepResult DriveTo(Cable& cable, Point to, double step_m = kStep) {
  StepResult result;
  while (cable.robot() != to && result.outcome == StepOutcome::kMoved) {
    const double rest = Distance(cable.robot(), to);
    result = cable.Step(rest <= step_m ? to : Lerp(cable.robot(), to, step_m / rest), 0.05);
  }
  return result;
}

double LaidLength(const Cable& cable) { return Length(cable.Shape()); }

TEST(Cable, PaysOutWhatTheRobotPulls) {
  const TautSpace space = Hall();
  auto cable = Cable::Create(space, {1, 1}, {.length_m = 5, .link_length_m = 0.1}).value();
  EXPECT_EQ(cable.paid_out_m(), 0);
  EXPECT_EQ(DriveTo(cable, {4.05, 1}).outcome, StepOutcome::kMoved);
  EXPECT_NEAR(cable.paid_out_m(), 3.05, 1e-9);
  ASSERT_EQ(cable.nodes().size(), 32U);
  for (std::size_t i = 1; i < 32; ++i) {
    EXPECT_NEAR(cable.nodes()[i].point.x, 1.05 + 0.1 * static_cast<double>(i - 1), 1e-9);
    EXPECT_NEAR(cable.nodes()[i].point.y, 1, 1e-9);
  }
}

TEST(Cable, LiesWhereItWasDraggedWhenTheRobotComesBack) {
  const TautSpace space = Hall();
  auto cable = Cable::Create(space, {1, 1}, {.length_m = 6, .link_length_m = 0.1}).value();
  DriveTo(cable, {5, 1});
  DriveTo(cable, {3, 1});
  // Half of the way back, the cable turns: what lies before that was never pulled.
  double farthest = 0;
  for (const Place& node : cable.nodes()) farthest = std::max(farthest, node.point.x);
  EXPECT_NEAR(farthest, 4, 0.1);
  EXPECT_NEAR(cable.paid_out_m(), 4, 1e-9);
  EXPECT_NEAR(LaidLength(cable), 4, 0.2);
  DriveTo(cable, {1, 1});
  EXPECT_NEAR(cable.paid_out_m(), 4, 1e-9);
  EXPECT_EQ(cable.TautLength(), 0);
}

TEST(Cable, HoldsTheRobotAtItsLength) {
  const TautSpace space = Hall();
  auto cable = Cable::Create(space, {1, 1}, {.length_m = 2}).value();
  EXPECT_EQ(DriveTo(cable, {5, 1}).outcome, StepOutcome::kHeld);
  EXPECT_NEAR(cable.robot().x, 3, kStep);
  const Point before = cable.robot();
  EXPECT_EQ(cable.Step(before + Point{1, 0}, 1).outcome, StepOutcome::kHeld);
  EXPECT_EQ(cable.robot(), before);
  EXPECT_EQ(DriveTo(cable, {1, 2.9}).outcome, StepOutcome::kMoved) << "the straight way there is within reach";
}

TEST(Cable, IsBlockedByObstacles) {
  const TautSpace space = HallWithPillar();
  auto cable = Cable::Create(space, {1, 2}, {.length_m = 9}).value();
  EXPECT_EQ(DriveTo(cable, {5, 2}).outcome, StepOutcome::kBlocked);
  EXPECT_NEAR(cable.robot().x, 3, kStep);
}

TEST(Cable, TellsOfCornersThatHoldIt) {
  const TautSpace space = HallWithPillar();
  auto cable = Cable::Create(space, {1, 2}, {.length_m = 5}).value();
  DriveTo(cable, {2.5, 3.5});
  EXPECT_TRUE(cable.contacts().empty());
  DriveTo(cable, {4.5, 3.5});
  const StepResult end = DriveTo(cable, {4.5, 0.5});
  EXPECT_EQ(end.outcome, StepOutcome::kHeld);
  EXPECT_TRUE(end.touches_obstacle);
  EXPECT_FALSE(end.touches_robot);
  ASSERT_GE(cable.contacts().size(), 1U);
  for (const Contact& contact : cable.contacts()) {
    EXPECT_EQ(contact.kind, ContactKind::kObstacle);
    EXPECT_EQ(contact.at.y, 3);
    EXPECT_EQ(space.mesh().point(contact.corner), contact.at);
    EXPECT_GT(contact.time_s, 3.5 / kStep * 0.05);
    EXPECT_LE(contact.time_s, cable.time_s());
  }
}

TEST(Cable, TellsWhenTheRobotDrivesOverIt) {
  const TautSpace space = Hall();
  auto cable = Cable::Create(space, {1, 1}, {.length_m = 9, .robot_radius_m = 0.2}).value();
  DriveTo(cable, {5, 1});
  DriveTo(cable, {5, 3});
  DriveTo(cable, {3, 3});
  EXPECT_TRUE(cable.contacts().empty());
  DriveTo(cable, {3, 0.5});
  ASSERT_EQ(cable.contacts().size(), 1U) << "once, however many steps it takes";
  EXPECT_EQ(cable.contacts()[0].kind, ContactKind::kRobot);
  EXPECT_NEAR(Distance(cable.contacts()[0].at, {3, 1}), 0, 0.25);
}

TEST(Cable, IsTautOnARetractingReel) {
  const TautSpace space = HallWithPillar();
  auto cable = Cable::Create(space, {1, 2}, {.length_m = 9, .link_length_m = 0.1, .reel = Reel::kRetracting}).value();
  for (const Point to : {Point{2.5, 3.5}, {4.5, 3.5}, {4.5, 0.5}, {4.5, 3.5}, {1.5, 3.5}}) {
    EXPECT_EQ(DriveTo(cable, to).outcome, StepOutcome::kMoved);
    EXPECT_NEAR(cable.paid_out_m(), cable.TautLength(), 1e-9);
    EXPECT_NEAR(LaidLength(cable), cable.TautLength(), 1e-9);
  }
  EXPECT_NEAR(cable.paid_out_m(), Distance({1, 2}, {1.5, 3.5}), 1e-9);
}

TEST(Cable, RetractsByLength) {
  const TautSpace space = Hall();
  auto cable = Cable::Create(space, {1, 1}, {.length_m = 9, .link_length_m = 0.1}).value();
  DriveTo(cable, {5, 1});
  DriveTo(cable, {3, 2});
  const double before = cable.paid_out_m();
  EXPECT_NEAR(cable.Retract(0.37), 0.37, 1e-9);
  EXPECT_NEAR(cable.paid_out_m(), before - 0.37, 1e-9);
  EXPECT_EQ(cable.robot(), (Point{3, 2}));
  EXPECT_NEAR(cable.Retract(100), before - 0.37 - std::hypot(2, 1), 1e-9);
  EXPECT_NEAR(LaidLength(cable), std::hypot(2, 1), 1e-9);
  EXPECT_EQ(cable.Retract(1), 0);
}

TEST(Cable, IsLaidAlongAPolyline) {
  const TautSpace space = HallWithPillar();
  const Polyline laid{{1, 2}, {2.5, 3.5}, {4.5, 3.5}, {4.5, 1.5}};
  const auto cable = Cable::Lay(space, laid, {.length_m = 9, .link_length_m = 0.1}).value();
  EXPECT_NEAR(cable.paid_out_m(), Length(laid), 1e-9);
  EXPECT_EQ(cable.robot(), laid.back());
  EXPECT_EQ(space.Pull(cable.ClassWalk()).points, Shorten(space, laid).path.points);
  for (std::size_t i = 0; i < cable.links().size(); ++i) {
    EXPECT_LE(cable.links()[i].length, cable.RestLength(i) * (1 + 1e-9));
    EXPECT_GE(cable.links()[i].length, 0.7 * cable.RestLength(i)) << "shorter only at a bend";
  }
}

TEST(Cable, RefusesWhatMakesNoSense) {
  const TautSpace space = HallWithPillar();
  const auto create = [&](Point base, CableOptions options) { return Cable::Create(space, base, options).has_value(); };
  EXPECT_TRUE(create({1, 1}, {.length_m = 1}));
  EXPECT_FALSE(create({3.5, 1.5}, {.length_m = 1})) << "inside the pillar";
  EXPECT_FALSE(create({1, NAN}, {.length_m = 1}));
  for (const double bad : {0.0, -1.0, double{NAN}, double{INFINITY}}) {
    EXPECT_FALSE(create({1, 1}, {.length_m = bad}));
    EXPECT_FALSE(create({1, 1}, {.length_m = 1, .link_length_m = bad}));
  }
  EXPECT_FALSE(create({1, 1}, {.length_m = 1, .link_length_m = 1e-7}));
  EXPECT_FALSE(create({1, 1}, {.length_m = 1, .robot_radius_m = -1}));
  EXPECT_FALSE(Cable::Lay(space, {}, {.length_m = 1}));
  EXPECT_FALSE(Cable::Lay(space, Polyline{{1, 1}, {3, 1}}, {.length_m = 1})) << "longer than the cable";
  EXPECT_FALSE(Cable::Lay(space, Polyline{{1, 2}, {6, 2}}, {.length_m = 9})) << "through the pillar";
}

/// Every point and every piece of the chain against all boundary edges.
void ExpectInFreeSpace(const RandomScene& scene, const Cable& cable) {
  const Polyline shape = cable.Shape();
  const BruteSight sight(scene.rings, shape);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto here = sight.NodesAt(shape[i]);
    ASSERT_FALSE(here.empty()) << "point " << i << " is in blocked ground";
    if (i == 0 || shape[i - 1] == shape[i]) continue;
    const auto before = sight.NodesAt(shape[i - 1]);
    const bool sees = std::any_of(here.begin(), here.end(), [&](std::size_t b) {
      return std::any_of(before.begin(), before.end(), [&](std::size_t a) { return sight.Sees(a, b); });
    });
    ASSERT_TRUE(sees) << "piece " << i << " passes blocked ground";
  }
}

/// Links are not stretched, what was paid out is on the floor, and nobody has more than the cable's length.
void ExpectLengths(const Cable& cable) {
  double laid = 0;
  for (std::size_t i = 0; i < cable.links().size(); ++i) {
    const double length = cable.links()[i].length;
    ASSERT_LE(length, cable.RestLength(i) + 0.0011 * cable.options().link_length_m) << "link " << i;
    laid += length;
  }
  EXPECT_NEAR(laid, LaidLength(cable), 1e-9);
  EXPECT_NEAR(laid + cable.SlackM(), cable.paid_out_m(), 0.01 * cable.options().link_length_m);
  EXPECT_LE(cable.paid_out_m(), cable.options().length_m * (1 + 1e-9));
  EXPECT_LE(cable.TautLength(), cable.options().length_m * (1 + 1e-9));
}

/// The chain and the way that the robot drove, both pulled tight by the engine.
void ExpectSameClass(const TautSpace& space, const Cable& cable, const std::optional<Walk>& driven) {
  const TautPath chain = space.Pull(cable.ClassWalk()), path = space.Pull(*driven);
  EXPECT_EQ(chain.points, path.points);
  EXPECT_EQ(chain.word, path.word);
}

CableOptions RandomOptions(Rng& rng) {
  CableOptions options;
  options.length_m = rng.Uniform(2, 30);
  options.link_length_m = rng.Uniform(0.1, 0.8);
  options.robot_radius_m = rng.Uniform(0, 0.4);
  return options;
}

TEST(Cable, KeepsLengthsGroundAndClassOnRandomDrives) {
  const std::int64_t trials = ScaledTestCount(60);
  std::int64_t held = 0, winding = 0;
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    auto cable = Cable::Create(space, RandomFreePoint(rng, scene), RandomOptions(rng)).value();
    RandomDrive drive(rng, rng.Uniform(0.02, 0.6));
    std::optional<Walk> driven;
    ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
    double paid_out = 0;
    for (int step = 1; step <= 600; ++step) {
      if (drive.Step(cable).outcome == StepOutcome::kHeld) ++held;
      ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
      EXPECT_GE(cable.paid_out_m(), paid_out - 1e-9) << "nothing pulls it in";
      paid_out = cable.paid_out_m();
      ExpectLengths(cable);
      if (step % 60 == 0) ExpectSameClass(space, cable, driven);
      if (step % 150 == 0) ExpectInFreeSpace(scene, cable);
      if (testing::Test::HasFailure()) return;
    }
    if (space.Pull(*driven).word.size() >= 2) ++winding;
  }
  EXPECT_GT(held, trials * 5);
  EXPECT_GE(winding, trials / 30);
}

TEST(Cable, PulledToItsLimitIsTheTautCurve) {
  const std::int64_t trials = ScaledTestCount(60);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(1000 + seed));
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    CableOptions options = RandomOptions(rng);
    auto cable = Cable::Create(space, RandomFreePoint(rng, scene), options).value();
    std::optional<Walk> driven;
    ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
    RandomDrive drive(rng, 0.2);
    for (int step = 0; step < 300; ++step) {
      drive.Step(cable);
      ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
    }
    const TautPath engine = space.Pull(*driven);
    Cable wound = cable;
    wound.RetractAll();
    EXPECT_NEAR(wound.paid_out_m(), engine.length, 1e-9);
    EXPECT_NEAR(LaidLength(wound), engine.length, 1e-9);
    ExpectInFreeSpace(scene, wound);
    ExpectSameClass(space, wound, driven);
    // In small bites it comes to the same.
    while (cable.Retract(0.3) > 0) ExpectLengths(cable);
    EXPECT_NEAR(cable.paid_out_m(), engine.length, 1e-9);
    ExpectSameClass(space, cable, driven);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Cable, RefusedRobotHasPulledItTaut) {
  std::int64_t refused = 0;
  const std::int64_t trials = ScaledTestCount(60);
  for (std::int64_t seed = 0; seed < trials; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(2000 + seed));
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    CableOptions options = RandomOptions(rng);
    options.length_m = rng.Uniform(2, 8);
    auto cable = Cable::Create(space, RandomFreePoint(rng, scene), options).value();
    std::optional<Walk> driven;
    ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
    RandomDrive drive(rng, 0.05);
    StepResult result;
    for (int step = 0; step < 2000 && result.outcome != StepOutcome::kHeld; ++step) {
      result = drive.Step(cable);
      ASSERT_FALSE(space.Follow(std::vector{cable.robot()}, driven));
    }
    if (result.outcome != StepOutcome::kHeld) continue;
    ++refused;
    const TautPath engine = space.Pull(*driven);
    EXPECT_NEAR(engine.length, options.length_m, 0.05 + 1e-6) << "at most a step is left";
    EXPECT_NEAR(LaidLength(cable), engine.length, 0.05 + 0.02 * engine.length);
    ExpectSameClass(space, cable, driven);
    ExpectInFreeSpace(scene, cable);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(refused, trials / 4);
}

std::uint64_t Digest(const Cable& cable, std::uint64_t hash) {
  const auto add = [&hash](double value) { hash = (hash ^ DoubleBits(value)) * 0x100000001b3ULL; };
  for (const Point p : cable.Shape()) add(p.x), add(p.y);
  add(cable.paid_out_m());
  add(static_cast<double>(cable.contacts().size()));
  return hash;
}

TEST(Cable, IsTheSameEverywhereAndAlways) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Rng rng(seed);
    const RandomScene scene = MakeRandomScene(rng);
    const TautSpace space(scene.space);
    auto cable = Cable::Create(space, RandomFreePoint(rng, scene), {.length_m = 8, .link_length_m = 0.1}).value();
    RandomDrive drive(rng, 0.1);
    for (int step = 0; step < 300; ++step) {
      drive.Step(cable);
      hash = Digest(cable, hash);
    }
  }
  EXPECT_EQ(hash, 7132984036938573036ULL);
}

}  // namespace
}  // namespace tautline
