// The manifold on a grid against the search over words as it is usually written, and against one sheet of cells.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// How often the search over words is run: it takes much longer than all the rest.
enum class WordStrings { kNever, kOnce, kEachTime };

/// Builds a manifold several times, in turn with the peers.
void Build(benchmark::State& state, const BlockField& field, double length, WordStrings word_strings) {
  const CellGround ground = GroundOf(field);
  const ManifoldOptions options = OptionsOf(field, length);
  SearchedStates cells, states;
  std::size_t vertices = 0, bytes = 0;
  std::vector<double> seconds, plain, words;
  for (auto _ : state) {
    CellGround own = ground;
    std::optional<GridManifold> manifold;
    seconds.push_back(SecondsOf([&] { manifold = GridManifold::Build(std::move(own), options); }));
    state.SetIterationTime(seconds.back());
    bytes = manifold->bytes();
    if (vertices == 0) vertices = static_cast<std::size_t>(manifold->Count().vertices);
    manifold.reset();
    plain.push_back(SecondsOf([&] { cells = SearchCells(ground, options); }));
    if (word_strings == WordStrings::kNever || (word_strings == WordStrings::kOnce && !words.empty())) continue;
    words.push_back(SecondsOf([&] { states = SearchWordStrings(ground, options); }));
  }
  const auto count = static_cast<double>(vertices);
  const double own = Summarize(seconds).median;
  state.counters["vertices"] = count;
  state.counters["seconds"] = own;
  state.counters["vertices_per_second"] = count / own;
  state.counters["bytes_per_vertex"] = static_cast<double>(bytes) / count;
  state.counters["cells_per_second"] = static_cast<double>(cells.states) / Summarize(plain).median;
  state.counters["against_one_sheet"] = count / own * Summarize(plain).median / static_cast<double>(cells.states);
  if (words.empty()) return;
  TAUTLINE_CHECK(states.states == vertices);
  state.counters["word_strings"] = Summarize(words).median;
  state.counters["against_word_strings"] = Summarize(words).median / own;
}

/// One thread against two, in turn. Two threads wait for each other, so here the wall clock counts, and of each kind
/// the quickest: what other programs do meanwhile is no property of ours.
void BuildInTwo(benchmark::State& state, const BlockField& field, double length) {
  const CellGround ground = GroundOf(field);
  ManifoldOptions options = OptionsOf(field, length);
  cli::RangeThreads threads(2);
  std::vector<double> ones, twos;
  const auto measure = [&](std::vector<double>& seconds) {
    CellGround own = ground;
    const double start = WallSeconds();
    const GridManifold manifold = GridManifold::Build(std::move(own), options);
    seconds.push_back(WallSeconds() - start);
    benchmark::DoNotOptimize(manifold.pages());
  };
  for (auto _ : state) {
    options.parallel = {};
    measure(ones);
    options.parallel = [&](std::size_t count, const cli::RangeThreads::Work& work) { threads.Run(count, work); };
    measure(twos);
    state.SetIterationTime(twos.back());
  }
  const double one = *std::min_element(ones.begin(), ones.end()), two = *std::min_element(twos.begin(), twos.end());
  state.counters["one"] = one;
  state.counters["two"] = two;
  state.counters["two_threads"] = one / two;
}

/// What two threads would take if none ever waited for a processor: each piece of work goes to the thread that is free
/// first, and their times are taken one piece after the other.
void ScheduleInTwo(benchmark::State& state, const BlockField& field, double length) {
  const CellGround ground = GroundOf(field);
  ManifoldOptions options = OptionsOf(field, length);
  double saved = 0;
  options.parallel = [&saved](std::size_t count, const cli::RangeThreads::Work& work) {
    const std::size_t piece = std::max<std::size_t>(1, count / 16);
    double first = 0, second = 0;
    for (std::size_t begin = 0; begin < count; begin += piece) {
      double& free = first <= second ? first : second;
      free += SecondsOf([&] { work(begin, std::min(count, begin + piece)); });
    }
    saved += std::min(first, second);
  };
  std::vector<double> ratios;
  for (auto _ : state) {
    CellGround own = ground;
    saved = 0;
    const double one =
        SecondsOf([&] { benchmark::DoNotOptimize(GridManifold::Build(std::move(own), options).pages()); });
    state.SetIterationTime(one);
    ratios.push_back(one / (one - saved));
  }
  state.counters["two_threads"] = Summarize(ratios).median;
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
  with("manifold/60_thousand", 40,
       [=](benchmark::State& s) { Build(s, small, tiny ? 20 : 66, WordStrings::kEachTime); });
  with("manifold/8_million", 5, [=](benchmark::State& s) { Build(s, small, tiny ? 20 : 140, WordStrings::kOnce); });
  const double lengths[] = {70, 222, 700, 2210, 7000};
  const int iterations[] = {60, 30, 15, 5, 1};
  for (int i = 0; i < 5; ++i) {
    const int side = static_cast<int>(2.2 * lengths[i]);
    const BlockField open{.side = tiny ? 100 : side, .spacing = tiny ? 50 : side / 2, .block = tiny ? 9 : side / 5};
    with("manifold/growth/1e" + std::to_string(4 + i), iterations[i],
         [=](benchmark::State& s) { Build(s, open, tiny ? 20 : lengths[i], WordStrings::kNever); });
  }
  with("manifold/two_threads/wall", 15, [=](benchmark::State& s) { BuildInTwo(s, small, tiny ? 20 : 140); });
  with("manifold/two_threads/schedule", 5, [=](benchmark::State& s) { ScheduleInTwo(s, small, tiny ? 20 : 140); });
}

}  // namespace tautline
