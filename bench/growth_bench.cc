// Synthetic maps: how time and memory grow with vertices, with holes, and with the length of the tether.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "bench/bench_scene.h"
#include "bench/memory.h"
#include "bench/peers/h_augmented_graph.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "bench/tether_queries.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

constexpr std::uint64_t kSeed = 5;

struct Sizes {
  SyntheticMapOptions map;
  BindingQueryOptions queries;
  int passes = 1;
};

/// Preparation once, with its memory, and the median of questions whose tether binds.
void PrepareAndPlan(benchmark::State& state, const Sizes& sizes) {
  const World world = SyntheticMap(sizes.map);
  for (auto _ : state) {
    ResetPeak();
    const std::size_t before = AllocatedBytes(), resident = PeakResidentBytes();
    std::optional<TetherPlanner> planner;
    const double seconds = SecondsOf([&] { planner = TetherPlanner::Prepare(world).value(); });
    state.SetIterationTime(seconds);
    state.counters["prepare"] = seconds;
    state.counters["kept_bytes"] = static_cast<double>(AllocatedBytes() - before);
    state.counters["peak_bytes"] = static_cast<double>(PeakResidentBytes() - resident);
    state.counters["vertices"] = static_cast<double>(planner->space().mesh().triangulation().points().size() - 4);
    state.counters["holes"] = static_cast<double>(planner->space().free_space().islands.size());
    state.counters["edges"] = static_cast<double>(planner->space().graph().edges().size());
    Rng rng(kSeed);
    const auto queries = BindingTetherQueries(rng, planner->space(), sizes.queries);
    std::size_t out_of_budget = 0;
    const Summary plan = Summarize(SecondsOfEach(queries.size(), sizes.passes, [&](std::size_t i) {
      if (planner->Plan(queries[i].tether, queries[i].goal).status != PlanStatus::kSolved) ++out_of_budget;
    }));
    state.counters["plan"] = plan.median;
    state.counters["plan_worst"] = plan.worst;
    state.counters["queries"] = static_cast<double>(queries.size());
    state.counters["out_of_budget"] = static_cast<double>(out_of_budget);
  }
}

/// Questions whose tether binds, sorted by its length, in eight groups of equal size.
void PlanByTether(benchmark::State& state, const Sizes& sizes) {
  constexpr std::size_t kGroups = 8;
  const TetherPlanner planner = TetherPlanner::Prepare(SyntheticMap(sizes.map)).value();
  Rng rng(kSeed);
  auto queries = BindingTetherQueries(rng, planner.space(), sizes.queries);
  std::sort(queries.begin(), queries.end(),
            [](const TetherQuery& a, const TetherQuery& b) { return a.tether.length < b.tether.length; });
  for (auto _ : state) {
    const auto seconds = SecondsOfEach(queries.size(), sizes.passes, [&](std::size_t i) {
      benchmark::DoNotOptimize(planner.Plan(queries[i].tether, queries[i].goal));
    });
    state.SetIterationTime(Summarize(seconds).median);
    for (std::size_t group = 0; group < kGroups; ++group) {
      const std::size_t first = group * queries.size() / kGroups, last = (group + 1) * queries.size() / kGroups;
      if (first == last) continue;
      const std::string prefix = "group" + std::to_string(group);
      state.counters[prefix + "_tether"] = queries[(first + last) / 2].tether.length;
      state.counters[prefix + "_median"] = Summarize({seconds.begin() + static_cast<std::ptrdiff_t>(first),
                                                      seconds.begin() + static_cast<std::ptrdiff_t>(last)})
                                               .median;
    }
  }
}

/// All classes within a tether of the maze, paired with the h-augmented graph. The peer's time is a lower bound when it
/// gives up.
void ClassesByTether(benchmark::State& state, double length) {
  const BenchScene scene = ReadCdt2025("maze");
  const TautSpace space(BuildFreeSpace(scene.world).value());
  const HAugmentedGraph graph(space, SightLines::kAll);
  const auto base = graph.Connect(scene.tether.base), goal = graph.Connect(scene.goals[0]);
  for (auto _ : state) {
    ClassList list;
    PeerClassList peer;
    const auto library = SecondsOfEach(1, 5, [&](std::size_t) {
      list = FindClasses(space, scene.tether.base, scene.goals[0], {.max_length = length, .max_count = {}});
    });
    state.SetIterationTime(library[0]);
    state.counters["length"] = length;
    list = {};
    const std::size_t before = AllocatedBytes();
    list = FindClasses(space, scene.tether.base, scene.goals[0], {.max_length = length, .max_count = {}});
    state.counters["kept_bytes"] = static_cast<double>(AllocatedBytes() - before);
    state.counters["classes"] = static_cast<double>(list.classes.size());
    state.counters["h_augmented"] = SecondsOfEach(1, 2, [&](std::size_t) {
      peer = graph.FindClasses(base, goal, {.max_length = length, .max_states = 4'000'000});
    })[0];
    state.counters["h_augmented_states"] = static_cast<double>(peer.states);
    state.counters["h_augmented_gave_up"] = peer.gave_up;
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const auto once = [](benchmark::internal::Benchmark* registered) {
    registered->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  const auto sized = [tiny](std::size_t vertices, std::size_t obstacles) {
    // The larger the map, the fewer questions, so that all sizes take about as long.
    const std::size_t count = std::clamp<std::size_t>(500'000 / vertices, 20, 100);
    return tiny ? Sizes{{.vertices = 100, .obstacles = 5}, {.places = 4, .count = 1}}
                : Sizes{{.vertices = vertices, .obstacles = obstacles}, {.places = 8, .count = count}};
  };
  for (const std::size_t vertices : {1'000, 3'000, 10'000, 30'000, 100'000}) {
    once(benchmark::RegisterBenchmark(("growth/vertices/" + std::to_string(vertices)).c_str(), PrepareAndPlan,
                                      sized(vertices, vertices / 20)));
  }
  for (const std::size_t obstacles : {10, 30, 100, 300, 1'000, 3'000}) {
    once(benchmark::RegisterBenchmark(("growth/holes/" + std::to_string(obstacles)).c_str(), PrepareAndPlan,
                                      sized(20'000, obstacles)));
  }
  Sizes by_tether = sized(10'000, 500);
  by_tether.queries =
      tiny ? BindingQueryOptions{.places = 8, .count = 8} : BindingQueryOptions{.places = 24, .count = 400};
  once(benchmark::RegisterBenchmark("growth/tether/plan", PlanByTether, by_tether));
  for (const int length : {2000, 3000, 4000, 5000, 6000, 7000, 8000}) {
    once(benchmark::RegisterBenchmark(("growth/tether/classes/" + std::to_string(length)).c_str(), ClassesByTether,
                                      tiny ? 2000.0 : length));
  }
}

}  // namespace tautline
