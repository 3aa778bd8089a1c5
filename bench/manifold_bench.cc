// The manifold on a grid against the search over words as it is usually written, and against one sheet of cells.
#include <benchmark/benchmark.h>

#include <optional>
#include <string>

#include "apps/cli/parallel_ranges.h"
#include "bench/peers/word_string_manifold.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "tautline/base/check.h"

namespace tautline {
namespace {

/// A square of so many cells with square blocks at equal distances, the base beside the middle.
struct BlockField {
  int side = 100;
  int spacing = 25;
  int block = 5;
};

CellGround GroundOf(const BlockField& field) {
  OccupancyGrid grid = MakeGrid(field.side, field.side, CellState::kFree);
  for (int row = field.spacing; row + field.spacing <= field.side; row += field.spacing) {
    for (int column = field.spacing; column + field.spacing <= field.side; column += field.spacing) {
      for (int i = 0; i < field.block * field.block; ++i) {
        const int at_column = column - field.block / 2 + i % field.block;
        grid.cells[grid.index(at_column, row - field.block / 2 + i / field.block)] = CellState::kBlocked;
      }
    }
  }
  return CellGround(std::move(grid), {});
}

ManifoldOptions OptionsOf(const BlockField& field, double length) {
  return {.base = {field.side / 2 + field.block, field.side / 2 + field.block},
          .length_m = length,
          .max_vertices = std::int64_t{1} << 31,
          .max_bytes = std::int64_t{1} << 36};
}

/// Builds a manifold several times; with the peers once each.
void Build(benchmark::State& state, const BlockField& field, double length, bool word_strings) {
  const CellGround ground = GroundOf(field);
  const ManifoldOptions options = OptionsOf(field, length);
  std::size_t vertices = 0, bytes = 0;
  std::vector<double> seconds;
  for (auto _ : state) {
    std::optional<GridManifold> manifold;
    seconds.push_back(SecondsOf([&] { manifold = GridManifold::Build(ground, options); }));
    state.SetIterationTime(seconds.back());
    bytes = manifold->bytes();
    vertices = static_cast<std::size_t>(manifold->Count().vertices);
  }
  SearchedStates cells;
  const double plain = SecondsOf([&] { cells = SearchCells(ground, options); });
  const double rate = static_cast<double>(vertices) / Summarize(seconds).median;
  state.counters["vertices"] = static_cast<double>(vertices);
  state.counters["vertices_per_second"] = rate;
  state.counters["bytes_per_vertex"] = static_cast<double>(bytes) / static_cast<double>(vertices);
  state.counters["against_one_sheet"] = rate * plain / static_cast<double>(cells.states);
  if (!word_strings) return;
  SearchedStates states;
  const double peer = SecondsOf([&] { states = SearchWordStrings(ground, options); });
  TAUTLINE_CHECK(states.states == vertices);
  state.counters["against_word_strings"] = peer / Summarize(seconds).median;
}

/// One thread against two.
void BuildInTwo(benchmark::State& state, const BlockField& field, double length) {
  const CellGround ground = GroundOf(field);
  ManifoldOptions options = OptionsOf(field, length);
  cli::RangeThreads threads(2);
  std::vector<double> ones, twos;
  for (auto _ : state) {
    options.parallel = {};
    ones.push_back(SecondsOf([&] { benchmark::DoNotOptimize(GridManifold::Build(ground, options).pages()); }));
    options.parallel = [&](std::size_t count, const cli::RangeThreads::Work& work) { threads.Run(count, work); };
    twos.push_back(SecondsOf([&] { benchmark::DoNotOptimize(GridManifold::Build(ground, options).pages()); }));
    state.SetIterationTime(twos.back());
  }
  state.counters["two_threads"] = Summarize(ones).median / Summarize(twos).median;
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const auto with = [tiny](const std::string& name, int iterations, const auto& run) {
    benchmark::RegisterBenchmark(name.c_str(), run)
        ->Iterations(tiny ? 1 : iterations)
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  };
  const BlockField small;
  with("manifold/60_thousand", 20, [=](benchmark::State& s) { Build(s, small, tiny ? 20 : 63, true); });
  with("manifold/8_million", 3, [=](benchmark::State& s) { Build(s, small, tiny ? 20 : 142, true); });
  const double lengths[] = {55, 175, 550, 1750, 5500};
  for (int i = 0; i < 5; ++i) {
    const int side = static_cast<int>(2.2 * lengths[i]);
    const BlockField open{.side = tiny ? 100 : side, .spacing = tiny ? 50 : side / 2, .block = tiny ? 9 : side / 5};
    with("manifold/growth/1e" + std::to_string(4 + i), i < 3 ? 5 : 1,
         [=](benchmark::State& s) { Build(s, open, tiny ? 20 : lengths[i], false); });
  }
  const BlockField wide{.side = tiny ? 100 : 1500, .spacing = tiny ? 25 : 300, .block = 11};
  with("manifold/two_threads", 3, [=](benchmark::State& s) { BuildInTwo(s, wide, tiny ? 20 : 500); });
}

}  // namespace tautline
