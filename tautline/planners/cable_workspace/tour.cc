#include "tautline/planners/cable_workspace/tour.h"

#include <algorithm>
#include <string>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/cable_workspace/exact_tour.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"
#include "tautline/planners/cable_workspace/tour_bound.h"
#include "tautline/planners/cable_workspace/tour_search.h"

namespace tautline {
namespace {

/// Tasks named in an explanation.
constexpr std::size_t kMostNamed = 5;

/// More rounds for a task have no end.
constexpr std::int64_t kMostRounds = 1'000'000'000;

/// Rounds of the bound: its steps are long too small by then.
constexpr int kBoundRounds = 4000;

/// Shares of the work, for the watcher.
constexpr double kDistancesDone = 0.4;
constexpr double kBoundDone = 0.6;

/// The places of a tour by the nodes of TourDistances, with the ways there.
struct Places {
  std::vector<std::vector<Walk>> ways;
  std::vector<std::size_t> chosen;  ///< The way that is taken.
  bool ambiguous = false;           ///< Some place has several.

  const Walk& Way(std::size_t node) const { return ways[node][chosen[node]]; }
};

OutsideFault TasksOutside(const WorkspaceRegion& region, const TourStops& stops, std::vector<std::size_t> tasks) {
  OutsideFault fault{WorkspaceObstruction::kTaskOutside, std::move(tasks), ""};
  for (std::size_t i = 0; i < std::min(fault.tasks.size(), kMostNamed); ++i) {
    const std::size_t task = fault.tasks[i];
    if (i > 0) fault.explanation += "; ";
    fault.explanation += ExplainOutside(region.boundary(), "task " + std::to_string(task + 1), stops.tasks[task]);
  }
  if (fault.tasks.size() > kMostNamed) {
    fault.explanation += "; and " + std::to_string(fault.tasks.size() - kMostNamed) + " more";
  }
  return fault;
}

tl::expected<Places, OutsideFault> FindPlaces(const WorkspaceRegion& region, const TourStops& stops) {
  Places places;
  std::vector<std::size_t> outside;
  for (std::size_t i = 0; i < stops.tasks.size(); ++i) {
    places.ways.push_back(region.WaysTo(stops.tasks[i]));
    if (places.ways.back().empty()) outside.push_back(i);
  }
  places.ways.push_back(region.WaysTo(stops.start));
  places.ways.push_back(stops.goal ? region.WaysTo(*stops.goal) : places.ways.back());
  const auto fault = [&](WorkspaceObstruction obstruction, const std::string& what, Point at) {
    return tl::unexpected(OutsideFault{obstruction, {}, ExplainOutside(region.boundary(), what, at)});
  };
  const std::size_t start = stops.tasks.size();
  if (places.ways[start].empty()) return fault(WorkspaceObstruction::kStartOutside, "the start", stops.start);
  if (places.ways[start + 1].empty()) return fault(WorkspaceObstruction::kGoalOutside, "the goal", *stops.goal);
  if (!outside.empty()) return tl::unexpected(TasksOutside(region, stops, std::move(outside)));
  for (const std::vector<Walk>& ways : places.ways) {
    const std::span<const Walk> from(places.ways[start].data(), 1);
    places.chosen.push_back(ways.size() == 1 ? 0 : ShortestPath(region, from, ways).to);
    places.ambiguous = places.ambiguous || ways.size() > 1;
  }
  return places;
}

/// Distances by the chosen ways, and the least over all ways, which differ where a place has several.
struct Distances {
  TourDistances chosen;
  TourDistances least;
  bool stopped = false;
};

Distances Measure(const WorkspaceRegion& region, const Places& places, const Watcher& watch) {
  const std::size_t tasks = places.ways.size() - 2;
  Distances distances{TourDistances(tasks), TourDistances(tasks)};
  const FreeMesh& mesh = region.ground().space().mesh();
  const auto length = [&](const Walk& from, const Walk& to) { return PullTaut(mesh, region.Between(from, to)).length; };
  for (std::size_t i = 0; i < places.ways.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(places.ways.size());
    distances.stopped = distances.stopped || (watch && !watch("distances", kDistancesDone * share * (2 - share)));
    for (std::size_t k = i + 1; k < places.ways.size(); ++k) {
      // Who stopped the search gets a tour all the same, by distances as the crow flies: no path is shorter.
      const double straight = Distance(places.Way(i).at, places.Way(k).at);
      const double chosen = distances.stopped ? straight : length(places.Way(i), places.Way(k));
      double least = chosen;
      if (places.ambiguous && !distances.stopped) {
        for (const Walk& from : places.ways[i]) {
          for (const Walk& to : places.ways[k]) least = std::min(least, length(from, to));
        }
      }
      distances.chosen.Set(i, k, chosen);
      distances.least.Set(i, k, least);
    }
  }
  return distances;
}

struct Order {
  std::vector<std::size_t> tasks;
  double bound = 0;
  bool stopped = false;
};

Order FindOrder(const Distances& distances, const TourOptions& options, Rng& rng) {
  Order order{.stopped = distances.stopped};
  const std::size_t tasks = distances.chosen.tasks();
  if (tasks <= std::min(options.most_exact, kMostExactTasks) && !order.stopped) {
    order.tasks = FindExactTour(distances.chosen);
    order.bound = TourLength(distances.least, FindExactTour(distances.least));
    return order;
  }
  double share = kDistancesDone;
  const KeepGoing keep_going = [&] {
    order.stopped = order.stopped || (options.watch && !options.watch("tour", share));
    return !order.stopped;
  };
  order.tasks = NearestNeighbourTour(distances.chosen);
  order.tasks = ImproveTour(distances.chosen, std::move(order.tasks), {}, rng);
  order.bound = BoundTour(distances.least, {.known_length = TourLength(distances.chosen, order.tasks),
                                            .rounds = order.stopped ? 1 : kBoundRounds,
                                            .keep_going = order.stopped ? KeepGoing{} : keep_going});
  const std::int64_t rounds = std::min(options.rounds_per_task, kMostRounds) * static_cast<std::int64_t>(tasks);
  std::int64_t round = 0;
  const KeepGoing keep_searching = [&] {
    share = kBoundDone + (1 - kBoundDone) * static_cast<double>(++round) / static_cast<double>(rounds);
    return keep_going();
  };
  order.tasks = ImproveTour(
      distances.chosen, std::move(order.tasks),
      {.rounds = rounds, .good_enough = order.bound * (1 + kLengthTolerance), .keep_going = keep_searching}, rng);
  return order;
}

/// A round tour is as long backwards: of the two orders the first as in a dictionary.
void Normalise(std::vector<std::size_t>& order) {
  if (!order.empty() && order.back() < order.front()) std::reverse(order.begin(), order.end());
}

void AddLegs(const WorkspaceRegion& region, const Places& places, Tour& tour) {
  const TautSpace& space = region.ground().space();
  std::size_t at = tour.order.size();
  std::vector<std::size_t> nodes = tour.order;
  nodes.push_back(tour.order.size() + 1);
  Polyline points{places.Way(at).at};
  for (const std::size_t next : nodes) {
    TautPath leg = space.Pull(region.Between(places.Way(at), places.Way(next)));
    points.insert(points.end(), leg.points.begin() + 1, leg.points.end());
    tour.legs.push_back(std::move(leg));
    at = next;
  }
  tour.path = space.MakePath(std::move(points));
}

}  // namespace

tl::expected<Tour, OutsideFault> PlanTour(const WorkspaceRegion& region, const TourStops& stops,
                                          const TourOptions& options, Rng& rng) {
  const auto places = FindPlaces(region, stops);
  if (!places) return tl::unexpected(places.error());
  Order order = FindOrder(Measure(region, *places, options.watch), options, rng);
  Tour tour{.order = std::move(order.tasks), .stopped = order.stopped};
  if (!stops.goal || *stops.goal == stops.start) Normalise(tour.order);
  AddLegs(region, *places, tour);
  tour.optimal = order.bound >= tour.path.length * (1 - kLengthTolerance);
  tour.bound = tour.optimal ? tour.path.length : order.bound;
  tour.outside = FirstOutside(region, tour.path.points);
  return tour;
}

}  // namespace tautline
