#include "bench/peers/word_string_manifold.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numbers>
#include <queue>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace tautline {
namespace {

struct State {
  std::int32_t cell = 0;
  std::string word;

  friend bool operator==(const State&, const State&) = default;
  friend bool operator<(const State& a, const State& b) { return a.cell != b.cell ? a.cell < b.cell : a.word < b.word; }
};

struct StateHash {
  std::size_t operator()(const State& state) const {
    return std::hash<std::string>()(state.word) * 1'000'003 + static_cast<std::size_t>(state.cell);
  }
};

/// Appends the letters of a step, each a sign of the text: small for left to right, large for the inverse.
void Cross(const CellGround& ground, GridCell from, int d, std::string& word) {
  const int dx = kStepColumns[static_cast<std::size_t>(d)], dy = kStepRows[static_cast<std::size_t>(d)];
  if (dx == 0) return;
  const int row = ground.IsFree({from.column + dx, from.row}) ? from.row : from.row + dy;
  const auto rays = ground.RaysBefore(std::max(from.column, from.column + dx));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const CellGround::Ray& ray = rays[dx > 0 ? i : rays.size() - 1 - i];
    if (row <= ray.above_row) continue;
    const int island = ray.obstacle.value();
    const auto letter = static_cast<char>(dx > 0 ? 1 + island : 101 + island);
    const auto inverse = static_cast<char>(dx > 0 ? 101 + island : 1 + island);
    if (!word.empty() && word.back() == inverse) {
      word.pop_back();
    } else {
      word.push_back(letter);
    }
  }
}

double StepCells(int d) { return d % 2 == 0 ? 1 : std::numbers::sqrt2; }

}  // namespace

SearchedStates SearchWordStrings(const CellGround& ground, const ManifoldOptions& options) {
  using Entry = std::pair<double, State>;
  const double limit = options.length_m / ground.cell_m() * (1 + 1e-9);
  const int step = options.connectivity == Connectivity::kEight ? 1 : 2;
  std::unordered_map<State, double, StateHash> distances;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const State base{options.base.row * ground.columns() + options.base.column, ""};
  distances[base] = 0;
  queue.emplace(0, base);
  SearchedStates searched;
  while (!queue.empty()) {
    const auto [distance, state] = queue.top();
    queue.pop();
    if (distance > distances[state]) continue;
    ++searched.states;
    searched.distances += distance;
    const GridCell from{state.cell % ground.columns(), state.cell / ground.columns()};
    for (int d = 0; d < kDirections; d += step) {
      const double further = distance + StepCells(d);
      if (further > limit || !ground.CanStep(from, d)) continue;
      const auto k = static_cast<std::size_t>(d);
      State to{state.cell + kStepRows[k] * ground.columns() + kStepColumns[k], state.word};
      Cross(ground, from, d, to.word);
      const auto [found, added] = distances.try_emplace(to, further);
      if (!added && found->second <= further) continue;
      found->second = further;
      queue.emplace(further, std::move(to));
    }
  }
  return searched;
}

SearchedStates SearchCells(const CellGround& ground, const ManifoldOptions& options) {
  const double limit = options.length_m / ground.cell_m() * (1 + 1e-9);
  const int step = options.connectivity == Connectivity::kEight ? 1 : 2;
  const int columns = ground.columns();
  std::vector<double> distances(ground.grid().cells.size(), std::numeric_limits<double>::infinity());
  std::vector<std::vector<std::int32_t>> buckets(1);
  const std::int32_t base = options.base.row * columns + options.base.column;
  distances[static_cast<std::size_t>(base)] = 0;
  buckets[0].push_back(base);
  SearchedStates searched;
  for (std::size_t bucket = 0; bucket < buckets.size(); ++bucket) {
    const std::vector<std::int32_t> cells = std::move(buckets[bucket]);
    for (const std::int32_t cell : cells) {
      const double distance = distances[static_cast<std::size_t>(cell)];
      if (static_cast<std::size_t>(distance) != bucket) continue;  // It came nearer after it was put here.
      const GridCell from{cell % columns, cell / columns};
      for (int d = 0; d < kDirections; d += step) {
        const double further = distance + StepCells(d);
        if (further > limit || !ground.CanStep(from, d)) continue;
        const auto k = static_cast<std::size_t>(d);
        const std::int32_t to = cell + kStepRows[k] * columns + kStepColumns[k];
        double& value = distances[static_cast<std::size_t>(to)];
        if (further >= value) continue;
        const auto at = static_cast<std::size_t>(further);
        const bool waits = value != std::numeric_limits<double>::infinity() && static_cast<std::size_t>(value) == at;
        value = further;
        if (waits) continue;
        if (buckets.size() <= at) buckets.resize(at + 1);
        buckets[at].push_back(to);
      }
    }
  }
  for (const double distance : distances) {
    if (distance == std::numeric_limits<double>::infinity()) continue;
    ++searched.states;
    searched.distances += distance;
  }
  return searched;
}

}  // namespace tautline
