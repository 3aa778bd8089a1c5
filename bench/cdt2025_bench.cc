// The maps of scenes/maps/cdt2025: preparation, classes, tethered plans; paired with the h-augmented graph.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>

#include "bench/bench_scene.h"
#include "bench/peers/grid_cover.h"
#include "bench/peers/h_augmented_graph.h"
#include "bench/program.h"
#include "bench/stopwatch.h"
#include "bench/tether_queries.h"
#include "tautline/base/check.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {
namespace {

constexpr std::uint64_t kSeed = 2025;

struct Sizes {
  int rounds = 5;
  std::size_t queries = 1000;
  std::size_t places = 30;
  std::size_t graph_queries = 200;
  std::size_t grid_queries = 10;
};

TetherPlanner PlannerOf(const BenchScene& scene) { return TetherPlanner::Prepare(scene.world).value(); }

void Prepare(benchmark::State& state, const std::string& name) {
  const BenchScene scene = ReadCdt2025(name);
  for (auto _ : state) benchmark::DoNotOptimize(PlannerOf(scene));
}

/// A peer for classes: the textbook's, and better ones.
struct PeerKind {
  const char* name;
  SightLines lines;
  Guess guess;
};

constexpr std::array kPeers{PeerKind{"dijkstra", SightLines::kAll, Guess::kNothing},
                            PeerKind{"a_star", SightLines::kAll, Guess::kStraight},
                            PeerKind{"a_star_exact", SightLines::kAll, Guess::kExact},
                            PeerKind{"a_star_exact_bitangents", SightLines::kBitangents, Guess::kExact}};

/// A graph with the base and the goals of a map connected to it.
struct ConnectedGraph {
  ConnectedGraph(const TautSpace& space, SightLines lines, const BenchScene& scene)
      : graph(space, lines), base(graph.Connect(scene.tether.base)) {
    for (const Point goal : scene.goals) goals.push_back(graph.Connect(goal));
  }

  HAugmentedGraph graph;
  HAugmentedGraph::Terminal base;
  std::vector<HAugmentedGraph::Terminal> goals;
};

struct ClassQuestion {
  std::string map;
  std::optional<std::size_t> count;  ///< k shortest; nothing: all within the tether.
};

/// The mean over the goals of the least times of several rounds.
class GoalTimes {
 public:
  explicit GoalTimes(std::size_t goals) : least_(goals, 1e300) {}

  template <class Work>
  void Round(Work work) {
    const auto seconds = SecondsOfEach(least_.size(), 1, work);
    for (std::size_t i = 0; i < least_.size(); ++i) least_[i] = std::min(least_[i], seconds[i]);
  }

  Summary summary() const { return Summarize(least_); }

 private:
  std::vector<double> least_;
};

/// Classes to each of the map's goals: the mean over the goals, library and peers in turn.
void Classes(benchmark::State& state, const ClassQuestion& question, const Sizes& sizes) {
  const BenchScene scene = ReadCdt2025(question.map);
  const TetherPlanner planner = PlannerOf(scene);
  const ConnectedGraph all(planner.space(), SightLines::kAll, scene);
  const ConnectedGraph bitangents(planner.space(), SightLines::kBitangents, scene);
  const std::size_t goals = scene.goals.size();
  ClassOptions options;
  PeerOptions peer_options;
  if (question.count) {
    options.max_count = static_cast<std::int64_t>(*question.count);
    peer_options.max_count = *question.count;
  } else {
    options.max_length = scene.tether.length;
    peer_options.max_length = scene.tether.length;
  }
  std::vector<ClassList> lists(goals);
  std::vector<PeerClassList> peer_lists(goals);
  GoalTimes library(goals);
  std::vector<GoalTimes> peers(kPeers.size(), library);
  const auto round = [&] {
    for (int pass = 0; pass < 4; ++pass) {
      library.Round(
          [&](std::size_t i) { lists[i] = FindClasses(planner.space(), scene.tether.base, scene.goals[i], options); });
    }
    for (std::size_t k = 0; k < kPeers.size(); ++k) {
      peer_options.guess = kPeers[k].guess;
      const ConnectedGraph& graph = kPeers[k].lines == SightLines::kAll ? all : bitangents;
      peers[k].Round(
          [&](std::size_t i) { peer_lists[i] = graph.graph.FindClasses(graph.base, graph.goals[i], peer_options); });
      for (std::size_t i = 0; i < goals; ++i) {
        TAUTLINE_CHECK(!peer_lists[i].gave_up && peer_lists[i].classes.size() == lists[i].classes.size());
      }
    }
  };
  // One question over and over, as many benchmarks do: branches are foreseen and caches warm.
  const auto repeated = [&](std::size_t i) {
    return SecondsOfEach(1, 4 * sizes.rounds, [&](std::size_t) {
      lists[i] = FindClasses(planner.space(), scene.tether.base, scene.goals[i], options);
    })[0];
  };
  for (auto _ : state) {
    for (int i = 0; i < sizes.rounds; ++i) round();
    state.SetIterationTime(library.summary().mean);
    double again = 0;
    for (std::size_t i = 0; i < goals; ++i) again += repeated(i);
    state.counters["repeated"] = again / static_cast<double>(goals);
    state.counters["worst"] = library.summary().worst;
    double classes = 0;
    for (const ClassList& list : lists) classes += static_cast<double>(list.classes.size());
    state.counters["classes"] = classes / static_cast<double>(goals);
    for (std::size_t k = 0; k < kPeers.size(); ++k) {
      state.counters[std::string("h_augmented_") + kPeers[k].name] = peers[k].summary().mean;
    }
  }
}

/// The times of a peer that first finds all tethers of a base, and then a motion among them.
struct PeerTimes {
  std::vector<double> tethers, search, total;
  std::size_t states = 0;
  bool gave_up = false;

  void Add(double tethers_seconds, double search_seconds) {
    tethers.push_back(tethers_seconds);
    search.push_back(search_seconds);
    total.push_back(tethers_seconds + search_seconds);
  }

  void Report(benchmark::State& state, const std::string& name) const {
    state.counters[name] = Summarize(total).median;
    state.counters[name + "_tethers"] = Summarize(tethers).median;
    state.counters[name + "_search"] = Summarize(search).median;
    state.counters[name + "_states"] = static_cast<double>(states) / static_cast<double>(total.size());
    state.counters[name + "_gave_up"] = gave_up;
  }
};

void AskGraph(const HAugmentedGraph& graph, const Rays& rays, const TetherQuery& query, PeerTimes& times) {
  const auto base = graph.Connect(query.tether.base), goal = graph.Connect(query.goal);
  const HAugmentedGraph::Start start{graph.Connect(query.tether.laid->back()), rays.WordOf(*query.tether.laid)};
  std::optional<HAugmentedGraph::Cover> cover;
  PeerMotion motion;
  const double first = SecondsOf([&] { cover = graph.MakeCover(base, goal, {.max_length = query.tether.length}); });
  times.Add(first, SecondsOf([&] { motion = graph.Plan(*cover, start, {}); }));
  times.states += cover->states.size() + motion.states;
  times.gave_up = times.gave_up || cover->gave_up || motion.gave_up;
}

/// Nothing where one of the points lies in a blocked cell. The tether is given the 8 % that a grid needs.
void AskGrid(const GridCover& grid, const Rays& rays, const TetherQuery& query, PeerTimes& times) {
  const auto base = grid.CentreAt(query.tether.base), robot = grid.CentreAt(query.tether.laid->back()),
             goal = grid.CentreAt(query.goal);
  if (!base || !robot || !goal) return;
  Polyline laid{*base};
  laid.insert(laid.end(), query.tether.laid->begin(), query.tether.laid->end());
  laid.push_back(*robot);
  std::optional<GridCover::Tethers> tethers;
  GridCover::Motion motion;
  const double first =
      SecondsOf([&] { tethers = grid.MakeTethers(*base, {.max_length = 1.0824 * query.tether.length}); });
  times.Add(first, SecondsOf([&] { motion = grid.Plan(*tethers, {*robot, rays.WordOf(laid), *goal}, {}); }));
  times.states += tethers->states.size() + motion.states;
  times.gave_up = times.gave_up || tethers->gave_up || motion.gave_up;
}

/// Tethered plans for random robots, cables and goals; then the peers on the first of the same questions.
void PlanQueries(benchmark::State& state, const std::string& name, const Sizes& sizes) {
  const BenchScene scene = ReadCdt2025(name);
  const TetherPlanner planner = PlannerOf(scene);
  const Rays& rays = planner.space().rays();
  const HAugmentedGraph graph(planner.space(), SightLines::kAll);
  const Point size = planner.space().free_space().box.size();
  const GridCover grid(planner.space(), std::max(size.x, size.y) / 250);
  Rng rng(kSeed);
  const auto queries = RandomTetherQueries(
      rng, planner.space(),
      {.base = scene.tether.base, .length = scene.tether.length, .places = sizes.places, .count = sizes.queries});
  std::size_t bound = 0;
  const auto ask = [&](std::size_t i) {
    const PlanResult result = planner.Plan(queries[i].tether, queries[i].goal);
    TAUTLINE_CHECK(result.motion);
    if (result.rejected) ++bound;
  };
  for (auto _ : state) {
    PeerTimes graph_times, grid_times;
    std::vector<double> same_questions;
    for (std::size_t i = 0; i < std::min(queries.size(), sizes.graph_queries); ++i) {
      same_questions.push_back(SecondsOf([&] { ask(i); }));
      AskGraph(graph, rays, queries[i], graph_times);
    }
    bound = 0;
    const Summary library = Summarize(SecondsOfEach(queries.size(), sizes.rounds, ask));
    for (std::size_t i = 0; i < std::min(queries.size(), sizes.grid_queries); ++i) {
      AskGrid(grid, rays, queries[i], grid_times);
    }
    state.SetIterationTime(library.median);
    state.counters["p99"] = library.p99;
    state.counters["worst"] = library.worst;
    state.counters["queries"] = static_cast<double>(queries.size());
    state.counters["binding"] = static_cast<double>(bound) / static_cast<double>(queries.size()) / sizes.rounds;
    state.counters["same_questions"] = Summarize(same_questions).median;
    graph_times.Report(state, "h_augmented");
    grid_times.Report(state, "grid");
  }
}

}  // namespace

void RegisterBenchmarks(bool tiny) {
  const Sizes sizes = tiny ? Sizes{1, 4, 2, 2, 1} : Sizes{};
  for (const std::string name : {"maze", "mess"}) {
    benchmark::RegisterBenchmark((name + "/prepare").c_str(), Prepare, name)->Unit(benchmark::kMillisecond);
    const auto once = [](auto* registered) {
      registered->Iterations(1)->UseManualTime()->Unit(benchmark::kMicrosecond);
    };
    once(benchmark::RegisterBenchmark((name + "/classes_up_to_length").c_str(), Classes, ClassQuestion{name, {}},
                                      sizes));
    for (const std::size_t k : {std::size_t{5}, std::size_t{50}}) {
      once(benchmark::RegisterBenchmark((name + "/shortest_classes/" + std::to_string(k)).c_str(), Classes,
                                        ClassQuestion{name, k}, sizes));
    }
    once(benchmark::RegisterBenchmark((name + "/plan").c_str(), PlanQueries, name, sizes));
  }
}

}  // namespace tautline
