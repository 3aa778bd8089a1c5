// Cable workspaces: all valid boundaries up to a length, paired with nested loops over the classes of all sides; how
// the time grows with anchors, obstacles and length.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/cable_rooms.h"
#include "bench/peers/boundary_loops.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "tautline/base/check.h"
#include "tautline/planners/cable_workspace/best.h"

namespace tautline {
namespace {

constexpr std::int64_t kMostCombinations = 100'000'000;
constexpr int kPasses = 3;

BoundaryList Find(const PreparedCableRoom& room, double limit) {
  BoundaryList list = FindBoundaries(room.ground, room.anchors, {.max_boundary = limit, .budget = 50'000'000});
  TAUTLINE_CHECK(list.complete);
  return list;
}

/// The library with its own classes, the peer without: it gets them listed.
void WithLoops(benchmark::State& state, double limit, std::int64_t most_combinations) {
  const PreparedCableRoom room(ThreeObstacleRoom());
  const auto sides = ListSides(room.ground, room.anchors, limit);
  for (auto _ : state) {
    BoundaryList list;
    LoopedBoundaries looped;
    const double seconds = SecondsOfEach(1, 20, [&](std::size_t) { list = Find(room, limit); })[0];
    state.SetIterationTime(seconds);
    const auto loop = [&](Multiply multiply) {
      return SecondsOf(
          [&] { looped = LoopOverSides(room.ground, room.anchors, sides, limit, multiply, most_combinations); });
    };
    state.counters["partial"] = loop(Multiply::kPartial);
    state.counters["whole"] = loop(Multiply::kWhole);
    TAUTLINE_CHECK(looped.gave_up || looped.boundaries.size() == list.boundaries.size());
    state.counters["gave_up"] = looped.gave_up;
    double classes = 0, possible = 1;
    for (const auto& side : sides) {
      classes += static_cast<double>(side.size());
      possible *= static_cast<double>(side.size());
    }
    state.counters["classes"] = classes;
    state.counters["possible"] = possible;
    state.counters["length"] = limit;
    state.counters["boundaries"] = static_cast<double>(list.boundaries.size());
  }
}

/// All boundaries that are longer than the shortest one by up to a share of it.
void Grow(benchmark::State& state, const RandomRoomOptions& options, double share) {
  const PreparedCableRoom room(RandomCableRoom(options));
  const double limit = (1 + share) * room.shortest;
  for (auto _ : state) {
    BoundaryList list;
    state.SetIterationTime(SecondsOfEach(1, kPasses, [&](std::size_t) { list = Find(room, limit); })[0]);
    state.counters["anchors"] = static_cast<double>(options.anchors);
    state.counters["obstacles"] = static_cast<double>(options.obstacles);
    state.counters["length"] = limit;
    state.counters["share"] = share;
    state.counters["boundaries"] = static_cast<double>(list.boundaries.size());
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const auto once = [](benchmark::internal::Benchmark* registered) {
    registered->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
  };
  for (const int limit : {1000, 1100, 1200, 1300}) {
    once(benchmark::RegisterBenchmark(("workspace/loops/" + std::to_string(limit)).c_str(), WithLoops,
                                      tiny ? 1000.0 : limit, tiny ? 1000 : kMostCombinations));
  }
  const auto grow = [&](const std::string& name, const RandomRoomOptions& options, double share) {
    const RandomRoomOptions small{.anchors = std::min<std::size_t>(options.anchors, 4),
                                  .obstacles = std::min<std::size_t>(options.obstacles, 3)};
    once(benchmark::RegisterBenchmark(("workspace/" + name).c_str(), Grow, tiny ? small : options, share));
  };
  for (const std::size_t anchors : {3, 4, 6, 8, 12, 16, 24}) {
    grow("anchors/" + std::to_string(anchors), {.anchors = anchors, .obstacles = 10}, 0.05);
  }
  for (const std::size_t obstacles : {3, 5, 10, 15, 20, 25, 30}) {
    grow("obstacles/" + std::to_string(obstacles), {.anchors = 8, .obstacles = obstacles}, 0.02);
  }
  for (const int percent : {1, 2, 3, 4, 5, 6, 8}) {
    grow("length/" + std::to_string(percent), {.anchors = 8, .obstacles = 20}, 0.01 * percent);
  }
}

}  // namespace tautline
