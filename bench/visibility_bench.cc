// The reduced visibility graph: time and memory per vertex.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/memory.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "tautline/homotopy/visibility_graph.h"
#include "tautline/scene/free_space.h"

namespace tautline {
namespace {

void BuildGraph(benchmark::State& state, std::size_t vertices) {
  const FreeSpace space = BuildFreeSpace(SyntheticMap({.vertices = vertices, .obstacles = vertices / 20})).value();
  const FreeMesh mesh(space);
  const Corners corners(space, mesh);
  std::vector<double> seconds;
  std::size_t bytes = 0, edges = 0;
  for (auto _ : state) {
    const std::size_t before = AllocatedBytes();
    std::optional<VisibilityGraph> graph;
    seconds.push_back(SecondsOf([&] { graph.emplace(corners, SeeFromAllCorners(mesh, corners)); }));
    state.SetIterationTime(seconds.back());
    bytes = AllocatedBytes() - before;
    edges = graph->edges().size();
  }
  const auto count = static_cast<double>(mesh.triangulation().points().size() - 4);
  state.counters["vertices"] = count;
  state.counters["corners"] = static_cast<double>(corners.size());
  state.counters["edges"] = static_cast<double>(edges);
  state.counters["seconds"] = Summarize(seconds).median;
  state.counters["seconds_per_vertex"] = Summarize(seconds).median / count;
  state.counters["bytes_per_vertex"] = static_cast<double>(bytes) / count;
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  for (const std::size_t vertices : {1'000, 3'000, 10'000, 30'000}) {
    benchmark::RegisterBenchmark(("visibility_graph/" + std::to_string(vertices)).c_str(), BuildGraph,
                                 tiny ? vertices / 100 + 20 : vertices)
        ->Iterations(tiny ? 1 : static_cast<std::int64_t>(5 + 30'000 / vertices))
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace tautline
