// The constrained Delaunay triangulation with its locator, paired with CGAL's.
#include <benchmark/benchmark.h>

#include <string>

#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/synthetic_map.h"
#include "bench/triangulation_input.h"
#include "tautline/base/rng.h"
#ifdef TAUTLINE_BENCH_CGAL
#include "bench/peers/cgal_triangulation.h"
#endif

namespace tautline {
namespace {

constexpr std::size_t kLocated = 1000;

std::vector<Point> RandomPoints(const World& world) {
  Rng rng(7);
  const Point high = world.outline[2];
  std::vector<Point> points;
  for (std::size_t i = 0; i < kLocated; ++i) points.push_back({rng.Uniform(0, high.x), rng.Uniform(0, high.y)});
  return points;
}

/// Library and CGAL in turn: building, and locating a thousand random points.
void Triangulate(benchmark::State& state, std::size_t vertices) {
  const World world = SyntheticMap({.vertices = vertices, .obstacles = vertices / 20});
  const TriangulationInput input = InputOf(world);
  const std::vector<Point> sought = RandomPoints(world);
  std::vector<double> build, locate;
#ifdef TAUTLINE_BENCH_CGAL
  const CgalInput cgal_input(input.points, input.edges);
  std::vector<double> cgal_build, cgal_locate;
#endif
  for (auto _ : state) {
    Triangulation mesh;
    build.push_back(SecondsOf([&] { mesh = Triangulation::Build(input.points, input.edges); }));
    locate.push_back(SecondsOf([&] {
      for (const Point p : sought) benchmark::DoNotOptimize(mesh.Locate(p));
    }));
    state.SetIterationTime(build.back() + locate.back());
#ifdef TAUTLINE_BENCH_CGAL
    std::optional<CgalTriangulation> cgal;
    cgal_build.push_back(SecondsOf([&] { cgal.emplace(cgal_input); }));
    cgal_locate.push_back(SecondsOf([&] {
      for (const Point p : sought) benchmark::DoNotOptimize(cgal->Locate(p));
    }));
#endif
  }
  state.counters["vertices"] = static_cast<double>(input.points.size());
  state.counters["build"] = Summarize(build).median;
  state.counters["locate"] = Summarize(locate).median;
#ifdef TAUTLINE_BENCH_CGAL
  state.counters["cgal_build"] = Summarize(cgal_build).median;
  state.counters["cgal_locate"] = Summarize(cgal_locate).median;
#endif
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  for (const std::size_t vertices : {1'000, 3'000, 10'000, 30'000, 100'000}) {
    benchmark::RegisterBenchmark(("triangulation/" + std::to_string(vertices)).c_str(), Triangulate,
                                 tiny ? vertices / 100 + 20 : vertices)
        ->Iterations(tiny ? 1 : static_cast<std::int64_t>(9 + 100'000 / vertices))
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace tautline
