// Real maps with a clearance: preparation, and questions whose tether binds.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "bench/bench_scene.h"
#include "bench/peers/h_augmented_graph.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/tether_queries.h"
#include "tautline/base/check.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

constexpr std::uint64_t kSeed = 20260101;
constexpr double kClearance = 0.2;

struct Map {
  std::string name;
  std::string path;
};

struct Sizes {
  int passes = 3;
  BindingQueryOptions queries;
};

struct PeerSizes {
  BindingQueryOptions queries{.places = 6, .count = 3};
  std::size_t max_states = 2'000'000;
};

void Prepare(benchmark::State& state, const Map& map) {
  const BenchScene scene = ReadMap(map.path, kClearance);
  for (auto _ : state) {
    const TetherPlanner planner = TetherPlanner::Prepare(scene.world).value();
    state.counters["vertices"] = static_cast<double>(planner.space().mesh().triangulation().points().size()) - 4;
    state.counters["corners"] = static_cast<double>(planner.space().corners().size());
    state.counters["islands"] = static_cast<double>(planner.space().free_space().islands.size());
    state.counters["edges"] = static_cast<double>(planner.space().graph().edges().size());
  }
}

void PlanQueries(benchmark::State& state, const Map& map, const Sizes& sizes) {
  const TetherPlanner planner = TetherPlanner::Prepare(ReadMap(map.path, kClearance).world).value();
  Rng rng(kSeed);
  const auto queries = BindingTetherQueries(rng, planner.space(), sizes.queries);
  std::size_t out_of_budget = 0;
  const auto ask = [&](std::size_t i) {
    const PlanResult result = planner.Plan(queries[i].tether, queries[i].goal);
    TAUTLINE_CHECK(result.rejected);
    if (result.status != PlanStatus::kSolved) ++out_of_budget;
  };
  for (auto _ : state) {
    const auto seconds = SecondsOfEach(queries.size(), sizes.passes, ask);
    const Summary summary = Summarize(seconds);
    state.SetIterationTime(summary.median);
    state.counters["p99"] = summary.p99;
    state.counters["worst"] = summary.worst;
    state.counters["queries"] = static_cast<double>(queries.size());
    state.counters["out_of_budget"] = static_cast<double>(out_of_budget) / sizes.passes;
    state.counters["worst_query"] =
        static_cast<double>(std::max_element(seconds.begin(), seconds.end()) - seconds.begin());
  }
}

/// A few of the same questions put to the peers, within a budget of states: where they give up, their time is a lower
/// bound. `gave_up` counts those questions.
void PlanWithPeers(benchmark::State& state, const Map& map, const PeerSizes& sizes) {
  const TetherPlanner planner = TetherPlanner::Prepare(ReadMap(map.path, kClearance).world).value();
  const TautSpace& space = planner.space();
  Rng rng(kSeed);
  const auto queries = BindingTetherQueries(rng, space, sizes.queries);
  const HAugmentedGraph graph(space, SightLines::kTangent);
  for (auto _ : state) {
    std::vector<double> library, peer;
    std::size_t gave_up = 0, states = 0;
    for (const TetherQuery& query : queries) {
      library.push_back(SecondsOf([&] { benchmark::DoNotOptimize(planner.Plan(query.tether, query.goal)); }));
      const auto base = graph.Connect(query.tether.base), goal = graph.Connect(query.goal);
      const HAugmentedGraph::Start start{graph.Connect(query.tether.laid->back()),
                                         space.rays().WordOf(*query.tether.laid)};
      peer.push_back(SecondsOf([&] {
        auto cover = graph.MakeCover(base, goal, {.max_length = query.tether.length, .max_states = sizes.max_states});
        states += cover.states.size();
        if (cover.gave_up || graph.Plan(cover, start, {.max_states = sizes.max_states}).gave_up) ++gave_up;
      }));
    }
    state.SetIterationTime(Summarize(library).median);
    state.counters["queries"] = static_cast<double>(queries.size());
    state.counters["h_augmented"] = Summarize(peer).median;
    state.counters["h_augmented_gave_up"] = static_cast<double>(gave_up);
    state.counters["h_augmented_states"] = static_cast<double>(states) / static_cast<double>(queries.size());
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  Sizes sizes;
  PeerSizes peer_sizes;
  if (tiny) peer_sizes = {{.places = 4, .count = 1}, 1000};
  if (tiny) sizes = {1, {.places = 4, .count = 1}};
  const std::string ros = "scenes/maps/ros/";
  for (const Map& given : {Map{"willow", ros + "willow-2010-02-18-0.10.yaml"}, Map{"intel", ros + "intel-lab.yaml"},
                           Map{"depot", ros + "depot.yaml"}}) {
    // Tiny: under each name the map that is prepared soonest.
    const Map map = tiny ? Map{given.name, ros + "depot.yaml"} : given;
    benchmark::RegisterBenchmark((map.name + "/prepare").c_str(), Prepare, map)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((map.name + "/plan").c_str(), PlanQueries, map, sizes)
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((map.name + "/plan_with_peer").c_str(), PlanWithPeers, map, peer_sizes)
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace tautline
