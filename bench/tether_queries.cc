#include "bench/tether_queries.h"

#include <algorithm>
#include <utility>

#include "bench/free_points.h"
#include "tautline/homotopy/classes.h"

namespace tautline {
namespace {

std::size_t Draw(Rng& rng, std::size_t count) {
  return static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(count) - 1));
}

/// The shortest paths between all pairs of places.
class PathTable {
 public:
  PathTable(const TautSpace& space, const std::vector<Point>& places) : size_(places.size()), paths_(size_ * size_) {
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto path = FindShortestOnward(space, Walk(*space.Locate(places[i])), *space.Locate(places[j]));
        At(i, j) = path->points;
        At(j, i) = Polyline(path->points.rbegin(), path->points.rend());
      }
    }
  }

  const Polyline& Between(std::size_t i, std::size_t j) const { return paths_[i * size_ + j]; }

 private:
  Polyline& At(std::size_t i, std::size_t j) { return paths_[i * size_ + j]; }

  std::size_t size_;
  std::vector<Polyline> paths_;
};

Polyline Joined(Polyline first, const Polyline& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

std::vector<TetherQuery> RandomTetherQueries(Rng& rng, const TautSpace& space, const RandomQueryOptions& options) {
  std::vector<std::vector<TautPath>> cables;  // By robot.
  while (cables.size() < options.places) {
    const Point robot = RandomFreePoints(rng, space, 1)[0];
    auto classes = FindClasses(space, options.base, robot, {.max_length = options.length, .max_count = {}}).classes;
    if (!classes.empty()) cables.push_back(std::move(classes));
  }
  std::vector<Point> goals;
  while (goals.size() < options.places) {
    const Point goal = RandomFreePoints(rng, space, 1)[0];
    const auto nearest = FindClasses(space, options.base, goal, {.max_length = options.length, .max_count = 1});
    if (!nearest.classes.empty()) goals.push_back(goal);
  }
  std::vector<TetherQuery> queries;
  while (queries.size() < options.count) {
    const auto& cable = cables[Draw(rng, cables.size())];
    queries.push_back(
        {{options.base, options.length, cable[Draw(rng, cable.size())].points}, goals[Draw(rng, goals.size())]});
  }
  return queries;
}

std::vector<TetherQuery> BindingTetherQueries(Rng& rng, const TautSpace& space, const BindingQueryOptions& options) {
  constexpr double kMargin = 1.01;  // A tether that binds by a millimetre would measure rounding.
  const std::vector<Point> places = RandomFreePoints(rng, space, options.places);
  const PathTable table(space, places);
  std::vector<TetherQuery> queries;
  for (std::size_t draws = 1000 * options.count; draws > 0 && queries.size() < options.count; --draws) {
    const std::size_t base = Draw(rng, places.size()), over = Draw(rng, places.size());
    const std::size_t robot = Draw(rng, places.size()), goal = Draw(rng, places.size());
    if (base == over || over == robot || robot == goal || base == robot || base == goal) continue;
    const TautPath laid = Shorten(space, Joined(table.Between(base, over), table.Between(over, robot))).path;
    const double direct = Shorten(space, Joined(laid.points, table.Between(robot, goal))).path.length;
    const double needed = std::max(laid.length, Length(table.Between(base, goal)));
    if (direct < kMargin * needed) continue;
    const double length = needed + rng.Uniform(0.05, 0.95) * (direct - needed);
    queries.push_back({{places[base], length, laid.points}, places[goal]});
  }
  return queries;
}

}  // namespace tautline
