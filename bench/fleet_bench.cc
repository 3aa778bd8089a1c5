// Fleets: layouts checked, motions planned and played, from a hundred robots to ten thousand, paired with the procedure
// as it was printed.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>

#include "bench/memory.h"
#include "bench/peers/fleet_as_printed.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "tautline/base/check.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/driven_fleet.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/playback.h"

namespace tautline {
namespace {

constexpr std::uint64_t kSeed = 5;

struct Size {
  FleetInRowsOptions fleet;
  int passes = 1;
  bool with_peer = false;
};

/// The least time of some passes, under the name of a stage.
template <class Work>
double Stage(benchmark::State& state, const std::string& name, int passes, Work work) {
  const double seconds = SecondsOfEach(1, passes, [&](std::size_t) { work(); })[0];
  state.counters[name] = seconds;
  return seconds;
}

/// The bytes that a plan takes: kept, and at most while it is made.
void MeasureMemory(benchmark::State& state, const FleetGround& ground, const FleetLayout& layout) {
  ResetPeak();
  const std::size_t before = AllocatedBytes(), resident = PeakResidentBytes();
  const FleetPlan plan = PlanFleet(ground, layout).value();
  const auto kept = static_cast<double>(AllocatedBytes() - before);
  state.counters["kept_bytes"] = kept;
  state.counters["peak_bytes"] = static_cast<double>(PeakResidentBytes() - resident);
  state.counters["bytes_per_crossing"] = kept / static_cast<double>(std::max<std::size_t>(plan.passings.size(), 1));
}

void PlanAndPlay(benchmark::State& state, const Size& size) {
  Rng rng(kSeed);
  const Scene scene = FleetInRows(rng, size.fleet);
  for (auto _ : state) {
    std::optional<FleetGround> ground;
    FleetLayout layout;
    FleetPlan plan;
    std::optional<Playback> playback;
    double whole = Stage(state, "prepare", size.passes, [&] { ground = FleetGround::Prepare(scene).value(); });
    whole += Stage(state, "read", size.passes, [&] { layout = ReadLayout(*ground).value(); });
    whole += Stage(state, "check", size.passes, [&] { TAUTLINE_CHECK(CheckLayout(*ground, layout).none()); });
    whole += Stage(state, "play", size.passes, [&] { plan = PlanFleet(*ground, layout).value(); });
    state.SetIterationTime(whole);
    Stage(state, "plan", size.passes, [&] { benchmark::DoNotOptimize(PlanFleet(*ground, layout, {.play = false})); });
    Stage(state, "measure", 1, [&] { playback = Play(*ground, layout, plan.schedule, PassingsToKeep(plan)).value(); });
    TAUTLINE_CHECK(playback->matches());
    state.counters["robots"] = static_cast<double>(size.fleet.robots);
    state.counters["crossings"] = static_cast<double>(plan.passings.size());
    state.counters["detours"] = static_cast<double>(plan.detours.size());
    MeasureMemory(state, *ground, layout);
    if (!size.with_peer) continue;
    PrintedPlan printed;
    Stage(state, "printed", 1, [&] { printed = PlanAsPrinted(*ground, layout); });
    state.counters["printed_detours"] = static_cast<double>(printed.detours.size());
    TAUTLINE_CHECK(printed.passings.size() == plan.passings.size());
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  for (const std::size_t robots : {100, 316, 1'000, 3'162, 10'000}) {
    Size size{{.robots = tiny ? 12 : robots}, robots <= 1'000 && !tiny ? 5 : 1, true};
    benchmark::RegisterBenchmark(("fleet/robots/" + std::to_string(robots)).c_str(), PlanAndPlay, size)
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace tautline
