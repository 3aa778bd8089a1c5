#include "tautline/planners/grid_manifold/best_base.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/deadlocks.h"

namespace tautline {
namespace {

bool IsBesideWall(const CellGround& ground, GridCell cell) {
  for (std::size_t d = 0; d < kDirections; d += 2) {
    if (!ground.IsFree({cell.column + kStepColumns[d], cell.row + kStepRows[d]})) return true;
  }
  return false;
}

/// The candidate of the square whose lower left cell is `corner`.
std::optional<GridCell> CandidateOf(const CellGround& ground, BaseCandidates kind, GridCell corner, int stride) {
  std::optional<GridCell> best;
  int least = 0;
  for (int row = corner.row; row < std::min(corner.row + stride, ground.rows()); ++row) {
    for (int column = corner.column; column < std::min(corner.column + stride, ground.columns()); ++column) {
      const GridCell cell{column, row};
      if (!ground.IsFree(cell) || (kind == BaseCandidates::kWalls && !IsBesideWall(ground, cell))) continue;
      const int dx = 2 * (column - corner.column) - stride + 1, dy = 2 * (row - corner.row) - stride + 1;
      const int apart = dx * dx + dy * dy;
      if (best && apart >= least) continue;
      best = cell;
      least = apart;
    }
  }
  return best;
}

}  // namespace

std::vector<GridCell> CandidateBases(const CellGround& ground, BaseCandidates kind, int stride) {
  TAUTLINE_CHECK(stride >= 1);
  std::vector<GridCell> candidates;
  for (int row = 0; row < ground.rows(); row += stride) {
    for (int column = 0; column < ground.columns(); column += stride) {
      if (const auto cell = CandidateOf(ground, kind, {column, row}, stride)) candidates.push_back(*cell);
    }
  }
  return candidates;
}

BaseTrial TryBase(const CellGround& ground, GridCell base, const BaseTrialOptions& options) {
  const GridManifold manifold = GridManifold::Build(ground, {.base = base,
                                                             .length_m = options.length_m,
                                                             .connectivity = options.connectivity,
                                                             .max_vertices = options.max_vertices,
                                                             .max_bytes = options.max_bytes});
  BaseTrial trial{.base = base, .complete = manifold.stop() == ManifoldStop::kNone};
  for (const std::uint32_t count : manifold.Multiplicity()) {
    trial.cells += count > 0 ? 1 : 0;
    trial.vertices += count;
  }
  if (!options.deadlocks || !trial.complete) return trial;
  const DeadlockAreas areas(manifold);
  trial.deadlocks = static_cast<std::int64_t>(areas.deadlocks().size());
  trial.closed = areas.closed_vertices();
  trial.lost = areas.LostCells();
  return trial;
}

std::vector<BaseTrial> RankBases(std::span<const BaseTrial> trials, BaseObjective objective) {
  std::vector<BaseTrial> ranked;
  std::int64_t most = 0;
  for (const BaseTrial& trial : trials) {
    if (!trial.complete) continue;
    ranked.push_back(trial);
    most = std::max(most, trial.cells);
  }
  const auto key = [&](const BaseTrial& trial) {
    const bool counts = static_cast<double>(trial.cells) >= kLeastReachShare * static_cast<double>(most);
    return objective == BaseObjective::kArea ? std::tuple(0, -trial.cells, -trial.vertices, trial.job)
                                             : std::tuple(counts ? 0 : 1, trial.closed, -trial.cells, trial.job);
  };
  std::sort(ranked.begin(), ranked.end(), [&](const BaseTrial& a, const BaseTrial& b) { return key(a) < key(b); });
  return ranked;
}

}  // namespace tautline
