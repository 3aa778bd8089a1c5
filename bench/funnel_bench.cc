// Pulling long sleeves taut: nanoseconds per portal.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/free_points.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "tautline/base/check.h"
#include "tautline/homotopy/classes.h"

namespace tautline {
namespace {

/// Times PullTaut on a walk many times over.
void Pull(benchmark::State& state, const TautSpace& space, const Walk& walk) {
  constexpr int kBatch = 10;  // A batch is long against the reading of the clock.
  const auto portals = static_cast<double>(walk.sleeve.size() - 1);
  std::vector<double> seconds;
  std::size_t bends = 0;
  for (auto _ : state) {
    seconds.push_back(SecondsOf([&] {
                        for (int i = 0; i < kBatch; ++i) bends = PullTaut(space.mesh(), walk).points.size();
                      }) /
                      kBatch);
    state.SetIterationTime(seconds.back());
  }
  state.counters["portals"] = portals;
  state.counters["bends"] = static_cast<double>(bends);
  state.counters["seconds_per_portal"] = Summarize(seconds).median / portals;
}

/// From end to end of a crooked corridor.
void PullInCorridor(benchmark::State& state, std::size_t vertices) {
  const SyntheticCorridor corridor = MakeSyntheticCorridor(vertices, 1);
  const TautSpace space(BuildFreeSpace(corridor.world).value());
  std::optional<Walk> walk;
  TAUTLINE_CHECK(!space.Follow(corridor.way, walk));
  Pull(state, space, *walk);
}

/// A tour over random places of a map with many obstacles, each leg a shortest path.
void PullTour(benchmark::State& state, std::size_t vertices) {
  constexpr std::size_t kPlaces = 12;
  const TautSpace space(BuildFreeSpace(SyntheticMap({.vertices = vertices, .obstacles = vertices / 20})).value());
  Rng rng(3);
  const std::vector<Point> places = RandomFreePoints(rng, space, kPlaces);
  std::optional<Walk> walk{Walk(*space.Locate(places[0]))};
  for (std::size_t i = 1; i < kPlaces; ++i) {
    const auto leg = FindShortestOnward(space, Walk(*space.Locate(places[i - 1])), *space.Locate(places[i]));
    TAUTLINE_CHECK(leg && !space.Follow(leg->points, walk));
  }
  Pull(state, space, *walk);
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const auto with = [tiny](benchmark::internal::Benchmark* registered) {
    registered->Iterations(tiny ? 1 : 200)->UseManualTime()->Unit(benchmark::kMicrosecond);
  };
  for (const std::size_t vertices : {1'000, 10'000, 100'000}) {
    with(benchmark::RegisterBenchmark(("funnel/corridor/" + std::to_string(vertices)).c_str(), PullInCorridor,
                                      tiny ? 20 : vertices));
  }
  with(benchmark::RegisterBenchmark("funnel/tour/10000", PullTour, tiny ? 100 : 10'000));
}

}  // namespace tautline
