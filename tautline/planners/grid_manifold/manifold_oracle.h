// For tests: the manifold the slow and obvious way.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_ORACLE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_ORACLE_H_

#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/geometry/grid_sketch.h"
#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Cell (row, column) and word, as text, with the distance: Dijkstra over a map. Words are found by going through the
/// cells of each step, here independently of patches.
class ManifoldOracle {
 public:
  using State = std::tuple<int, int, std::string>;

  ManifoldOracle(const CellGround& ground, const ManifoldOptions& options) : ground_(ground) {
    step_ = options.connectivity == Connectivity::kEight ? 1 : 2;
    const double limit = options.length_m / ground.cell_m() + 1e-7;
    std::priority_queue<std::pair<double, State>, std::vector<std::pair<double, State>>, std::greater<>> queue;
    distance_[{options.base.row, options.base.column, ""}] = 0;
    queue.push({0, distance_.begin()->first});
    while (!queue.empty()) {
      const auto [distance, state] = queue.top();
      queue.pop();
      if (distance > distance_[state]) continue;
      for (int d = 0; d < kDirections; d += step_) {
        const auto to = Step(state, d);
        const double further = distance + (d % 2 == 0 ? 1 : std::numbers::sqrt2);
        if (!to || further > limit) continue;
        const auto [found, added] = distance_.try_emplace(*to, further);
        if (!added && found->second <= further) continue;
        found->second = further;
        queue.push({further, *to});
      }
    }
  }

  const std::map<State, double>& distances() const { return distance_; }

  std::int64_t Edges() const {
    std::int64_t ends = 0;
    for (const auto& [state, distance] : distance_) {
      for (int d = 0; d < kDirections; d += step_) {
        const auto to = Step(state, d);
        if (to && distance_.count(*to) > 0) ++ends;
      }
    }
    return ends / 2;
  }

  std::vector<std::int64_t> Multiplicity() const {
    std::map<std::pair<int, int>, std::size_t> cells;
    for (const auto& [state, distance] : distance_) ++cells[{std::get<0>(state), std::get<1>(state)}];
    std::vector<std::int64_t> counts;
    for (const auto& [cell, count] : cells) {
      if (counts.size() < count) counts.resize(count);
      ++counts[count - 1];
    }
    return counts;
  }

 private:
  /// A diagonal step goes by way of a free cell beside it.
  std::optional<State> Step(const State& state, int d) const {
    const auto& [row, column, text] = state;
    const int dx = kStepColumns[static_cast<std::size_t>(d)], dy = kStepRows[static_cast<std::size_t>(d)];
    const auto free = [&](int x, int y) { return ground_.IsFree({x, y}); };
    if (!free(column + dx, row + dy)) return std::nullopt;
    if (dx == 0 || dy == 0) return State{row + dy, column + dx, Cross(text, row, column, dx)};
    if (free(column + dx, row)) return State{row + dy, column + dx, Cross(text, row, column, dx)};
    if (free(column, row + dy)) return State{row + dy, column + dx, Cross(text, row + dy, column, dx)};
    return std::nullopt;
  }

  std::string Cross(std::string text, int row, int column, int dx) const {
    if (dx == 0) return text;
    std::vector<ObstacleId> crossed;
    for (const CellGround::Ray& ray : ground_.RaysBefore(std::max(column, column + dx))) {
      if (row > ray.above_row) crossed.push_back(ray.obstacle);
    }
    for (std::size_t i = 0; i < crossed.size(); ++i) {
      const ObstacleId island = dx > 0 ? crossed[i] : crossed[crossed.size() - 1 - i];
      const char letter = static_cast<char>((dx > 0 ? '\x01' : -'\x01') * (island.value() + 1));
      if (!text.empty() && text.back() == static_cast<char>(-letter)) {
        text.pop_back();
      } else {
        text.push_back(letter);
      }
    }
    return text;
  }

  const CellGround& ground_;
  int step_ = 1;
  std::map<State, double> distance_;
};

/// Free cells with single blocked ones, and now and then a bar; the base is free.
inline CellGround RandomGround(Rng& rng, GridCell& base) {
  const bool wide = rng.Uniform() < 0.2;  // With tiles that no wall and no ray comes near.
  const int rows = rng.UniformInt(1, wide ? 48 : 22), columns = rng.UniformInt(1, wide ? 48 : 22);
  OccupancyGrid grid = MakeGrid(columns, rows, CellState::kFree);
  const double share = rng.Uniform(0, wide ? 0.004 : 0.35);
  for (CellState& cell : grid.cells) cell = rng.Uniform() < share ? CellState::kBlocked : CellState::kFree;
  if (rng.Uniform() < 0.3) {
    const int row = rng.UniformInt(0, grid.rows - 1);
    for (int column = rng.UniformInt(0, grid.columns - 1); column < grid.columns - 1; ++column) {
      grid.cells[grid.index(column, row)] = CellState::kBlocked;
    }
  }
  base = {rng.UniformInt(0, grid.columns - 1), rng.UniformInt(0, grid.rows - 1)};
  grid.cells[grid.index(base.column, base.row)] = CellState::kFree;
  grid.cell_m = rng.Uniform() < 0.5 ? 1 : 0.1;
  return CellGround(std::move(grid), {});
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_ORACLE_H_
