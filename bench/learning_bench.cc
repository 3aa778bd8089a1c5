// Training: a gradient step of the deep Q-network with each width of vectors, and a whole training of the paper.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "bench/program.h"
#include "bench/stopwatch.h"
#include "tautline/base/check.h"
#include "tautline/planners/contact_free/reference_path.h"
#include "tautline/planners/contact_free/training_run.h"

namespace tautline {
namespace {

constexpr std::uint64_t kSeed = 1;

/// A room with four blocks, and a robot that drives around two of them.
class Room {
 public:
  Room() {
    for (const Point corner : {Point{4, 0}, Point{4, 8}, Point{7, 3}, Point{7, 10}}) {
      const Point size{1, 3};
      world_.obstacles.push_back(
          {.polygon =
               PolygonWithHoles{{corner, corner + Point{size.x, 0}, corner + size, corner + Point{0, size.y}}, {}}});
    }
    space_ = BuildFreeSpace(world_).value();
    map_.emplace(space_, 0.125);
  }

  /// At its base.
  TetherEnv Env() const { return Make({{2, 2}}, {{2, 2}, {3.4, 3.7}, {5.6, 3.7}, {6.4, 6.6}, {8.6, 6.6}, {11, 3}}); }

  /// With a cable of twelve nodes laid around both blocks, on the way to another goal.
  TetherEnv EnvOfTwelveNodes() const {
    const Polyline laid{{2, 2}, {3.4, 3.7}, {5.6, 3.7}, {6.4, 6.6}, {8.6, 6.6}, {10, 4.9}};
    TetherEnv env = Make(laid, {laid.back(), {11, 3}, {9, 1.5}, {7, 1.5}});
    TAUTLINE_CHECK(env.cable().nodes().size() == 12);
    return env;
  }

 private:
  TetherEnv Make(const Polyline& laid, const Polyline& reference) const {
    return TetherEnv::Create(
               *map_,
               {.laid = laid, .cable_length_m = 14, .goal = reference.back(), .waypoints = Waypoints(reference, 0.5)},
               {})
        .value();
  }

  World world_{.outline = Ring{{0, 0}, {13, 0}, {13, 13}, {0, 13}}};
  FreeSpace space_;
  std::optional<ContactMap> map_;
};

/// The steps of a training between two gradient steps leave only those: as often as there is one transition.
void RunGradient(benchmark::State& state, const Kernels* kernels, int steps) {
  const DqnOptions options{.learning_starts = 32, .train_frequency = 1};
  Dqn learner({.inputs = 3, .actions = kTetherActions}, options, kSeed, *kernels);
  Rng rng(kSeed);
  const auto observe = [&rng] {
    Observation seen{};
    for (float& number : seen) number = static_cast<float>(rng.Uniform(-1, 1));
    return seen;
  };
  const auto learn = [&] {
    const Observation before = observe(), after = observe();
    learner.Learn({.before = before, .action = rng.UniformInt(0, 2), .reward = rng.Uniform(-1, 1), .after = after});
  };
  for (int i = 0; i < 40; ++i) learn();
  for (auto _ : state) {
    // The least of several stretches: what else the machine does is not counted.
    double least = 1e300;
    for (int pass = 0; pass < 5; ++pass) {
      least = std::min(least, SecondsOf([&] {
                         for (int i = 0; i < steps; ++i) learn();
                       }));
    }
    state.SetIterationTime(least / steps);
  }
}

void RunTraining(benchmark::State& state, std::int64_t steps) {
  const Room room;
  TrainingOptions options;
  options.dqn.steps = steps;
  options.dqn.learning_starts = static_cast<int>(steps / 60);
  for (auto _ : state) {
    TrainingRun run(room.Env(), options, *FindKernels("auto"));
    state.SetIterationTime(SecondsOf([&] {
      while (!run.done()) run.RunEpisode();
    }));
    state.counters["gradient_steps"] = static_cast<double>(run.gradient_steps());
  }
}

/// The environment alone, at random: what a learner asks of it, steps, observations and starts, with a cable that never
/// has fewer than twelve nodes.
void RunEnvironment(benchmark::State& state, int steps) {
  const Room room;
  TetherEnv env = room.EnvOfTwelveNodes();
  Rng rng(kSeed);
  for (auto _ : state) {
    double nodes = 0;
    Observation seen{};
    const double seconds = SecondsOf([&] {
      bool ended = false;
      for (int i = 0; i < steps; ++i) {
        if (ended) env.Reset();
        const int choice = rng.UniformInt(0, 9);
        ended = env.Step(choice == 0   ? TetherAction::kLeft
                         : choice == 1 ? TetherAction::kRight
                                       : TetherAction::kStraight)
                    .ends();
        seen = env.Observe();
        benchmark::DoNotOptimize(seen);
        nodes += static_cast<double>(env.cable().nodes().size());
      }
    });
    state.SetIterationTime(seconds);
    state.counters["steps_per_second"] = steps / seconds;
    state.counters["nodes"] = nodes / steps;
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const auto with = [](benchmark::internal::Benchmark* registered) {
    registered->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  for (const Kernels* kernels : AvailableKernels()) {
    with(benchmark::RegisterBenchmark((std::string("learning/gradient/") + kernels->name).c_str(), RunGradient, kernels,
                                      tiny ? 2 : 1000));
  }
  with(benchmark::RegisterBenchmark("learning/gradient/auto", RunGradient, FindKernels("auto"), tiny ? 2 : 1000));
  with(benchmark::RegisterBenchmark("learning/training", RunTraining, tiny ? 300 : 300'000));
  with(benchmark::RegisterBenchmark("learning/environment", RunEnvironment, tiny ? 100 : 2'000'000));
}

}  // namespace tautline
