// The cable on a floor: seconds simulated per second, paired with a rope that tests every node against every obstacle.
#include <benchmark/benchmark.h>

#include <numbers>
#include <string>

#include "bench/free_points.h"
#include "bench/peers/plain_rope.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "tautline/base/check.h"
#include "tautline/cable/cable.h"
#include "tautline/homotopy/classes.h"

namespace tautline {
namespace {

constexpr double kStepS = 0.05;      // Of simulated time, at
constexpr double kSpeed = 0.5;       // metres a second.
constexpr std::size_t kLinks = 199;  // 200 nodes.
constexpr std::uint64_t kSeed = 4;

/// A floor of 5 m x 3 m with six round pillars.
World PillarFloor() {
  World world;
  world.outline = {{0, 0}, {5, 0}, {5, 3}, {0, 3}};
  for (int i = 0; i < 6; ++i) {
    Ring ring;
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * std::numbers::pi * k / 16;
      ring.push_back(Point{0.9 + 1.6 * (i % 3), i < 3 ? 0.9 : 2.1} + 0.2 * Point{std::cos(angle), std::sin(angle)});
    }
    Obstacle pillar;
    pillar.name = "p" + std::to_string(i + 1);
    pillar.polygon = PolygonWithHoles{ring, {}};
    world.obstacles.push_back(pillar);
  }
  return world;
}

/// Where the robot goes: along shortest paths from one random place to the next, step by step.
class Tour {
 public:
  Tour(const TautSpace& space, std::uint64_t seed) : space_(space), rng_(seed) {}

  Point base() { return RandomFreePoints(rng_, space_, 1)[0]; }

  Point NextFrom(Point robot) {
    if (at_ == path_.size()) Turn(robot);
    const double rest = Distance(robot, path_[at_]), step = kSpeed * kStepS;
    return rest <= step ? path_[at_++] : Lerp(robot, path_[at_], step / rest);
  }

  /// Chooses the next place at once.
  void Turn(Point robot) {
    const Point to = RandomFreePoints(rng_, space_, 1)[0];
    const auto path = FindShortestOnward(space_, Walk(*space_.Locate(robot)), *space_.Locate(to));
    TAUTLINE_CHECK(path.has_value());
    path_ = path->points;
    at_ = path_.size() > 1 ? 1 : 0;
  }

 private:
  const TautSpace& space_;
  Rng rng_;
  Polyline path_;
  std::size_t at_ = 0;
};

/// What the robot did, so that the peer can do the same.
struct Drive {
  std::vector<Point> robot;
  double seconds = 0;
  std::size_t held = 0;
};

Drive DriveCable(Cable& cable, Tour& tour, std::size_t steps) {
  Drive drive;
  for (std::size_t step = 0; step < steps; ++step) {
    const Point to = tour.NextFrom(cable.robot());
    StepResult result;
    drive.seconds += SecondsOf([&] { result = cable.Step(to, kStepS); });
    drive.robot.push_back(cable.robot());
    if (result.outcome == StepOutcome::kMoved) continue;
    ++drive.held;
    tour.Turn(cable.robot());
  }
  TAUTLINE_CHECK(cable.TautLength() <= cable.options().length_m * (1 + kLengthTolerance));
  return drive;
}

void RunCable(benchmark::State& state, const World& world, double length_m, Reel reel, std::size_t steps) {
  const TautSpace space(BuildFreeSpace(world).value());
  for (auto _ : state) {
    Tour tour(space, kSeed);
    auto cable =
        Cable::Create(space, tour.base(), {.length_m = length_m, .link_length_m = length_m / kLinks, .reel = reel})
            .value();
    const Drive drive = DriveCable(cable, tour, steps);
    state.SetIterationTime(drive.seconds);
    state.counters["real_time_factor"] = kStepS * static_cast<double>(steps - drive.held) / drive.seconds;
    state.counters["nodes"] = static_cast<double>(cable.nodes().size());
    state.counters["held"] = static_cast<double>(drive.held) / static_cast<double>(steps);
    state.counters["contacts"] = static_cast<double>(cable.contacts().size());
  }
}

/// The plain rope along the way that the cable's robot drove.
void RunPlainRope(benchmark::State& state, const World& world, double length_m, int sweeps, std::size_t steps) {
  const TautSpace space(BuildFreeSpace(world).value());
  Tour tour(space, kSeed);
  const Point base = tour.base();
  auto cable = Cable::Create(space, base, {.length_m = length_m, .link_length_m = length_m / kLinks}).value();
  const Drive drive = DriveCable(cable, tour, steps);
  std::vector<Ring> obstacles;
  for (const FreeComponent& component : space.free_space().components) {
    for (const BoundaryRing& hole : component.holes) obstacles.push_back(hole.points);
  }
  for (auto _ : state) {
    PlainRope rope(obstacles, base, kLinks, length_m / kLinks);
    double seconds = 0, worst = 0;
    std::size_t through = 0;
    for (const Point to : drive.robot) {
      seconds += SecondsOf([&] { rope.Step(to, sweeps); });
      worst = std::max(worst, rope.WorstStretch());
      if (rope.LinksThroughObstacles() > 0) ++through;
    }
    state.SetIterationTime(seconds);
    state.counters["real_time_factor"] = kStepS * static_cast<double>(steps - drive.held) / seconds;
    state.counters["steps_through_obstacles"] = static_cast<double>(through) / static_cast<double>(steps);
    state.counters["worst_stretch"] = worst;
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const std::size_t steps = tiny ? 20 : 20'000;
  const auto with = [tiny](benchmark::internal::Benchmark* registered) {
    registered->Iterations(tiny ? 1 : 3)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  const World floor = PillarFloor();
  const World map = SyntheticMap({.vertices = tiny ? 30U : 1'000U, .obstacles = tiny ? 4U : 50U});
  with(benchmark::RegisterBenchmark("cable/pillars/free", RunCable, floor, 10, Reel::kFree, steps));
  with(benchmark::RegisterBenchmark("cable/pillars/short", RunCable, floor, 4, Reel::kFree, steps));
  with(benchmark::RegisterBenchmark("cable/pillars/retracting", RunCable, floor, 10, Reel::kRetracting, steps));
  with(benchmark::RegisterBenchmark("cable/map/free", RunCable, map, 60, Reel::kFree, steps));
  for (const int sweeps : {1, 20}) {
    with(benchmark::RegisterBenchmark(("cable/pillars/plain_rope/" + std::to_string(sweeps)).c_str(), RunPlainRope,
                                      floor, 10, sweeps, tiny ? 20 : 2'000));
  }
}

}  // namespace tautline
