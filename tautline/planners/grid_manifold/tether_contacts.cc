#include "tautline/planners/grid_manifold/tether_contacts.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "tautline/geometry/disjoint_sets.h"

namespace tautline {
namespace {

constexpr std::int32_t kWall = -1;

GridCell Beside(GridCell cell, int direction) {
  const auto d = static_cast<std::size_t>(direction);
  return {cell.column + kStepColumns[d], cell.row + kStepRows[d]};
}

/// By cell, the island that it belongs to; kWall for all others.
std::vector<std::int32_t> IslandsByCell(const CellGround& ground) {
  const OccupancyGrid& grid = ground.grid();
  std::vector<std::int32_t> islands(grid.cells.size(), kWall);
  std::vector<GridCell> stack;
  const auto add = [&](GridCell cell, std::int32_t island) {
    if (!grid.contains(cell.column, cell.row) || ground.IsFree(cell)) return;
    std::int32_t& at = islands[grid.index(cell.column, cell.row)];
    if (at != kWall) return;
    at = island;
    stack.push_back(cell);
  };
  for (int column = 0; column < ground.columns(); ++column) {
    for (const CellGround::Ray& ray : ground.RaysBefore(column)) {
      add(ground.StartOf(ray), static_cast<std::int32_t>(ray.obstacle.value()));
      while (!stack.empty()) {
        const GridCell cell = stack.back();
        stack.pop_back();
        for (int d = 0; d < kDirections; ++d) add(Beside(cell, d), static_cast<std::int32_t>(ray.obstacle.value()));
      }
    }
  }
  return islands;
}

class ContactFinder {
 public:
  explicit ContactFinder(const GridManifold& manifold) : manifold_(manifold), ground_(manifold.ground()) {
    const OccupancyGrid& grid = ground_.grid();
    beside_.resize(grid.cells.size());
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        for (int d = 0; d < kDirections; ++d) {
          if (!ground_.IsFree(Beside({column, row}, d))) beside_[grid.index(column, row)] = true;
        }
      }
    }
  }

  std::vector<TetherContact> Find() {
    const std::vector<std::int32_t> islands = IslandsByCell(ground_);
    for (std::uint32_t page = 0; page < manifold_.pages(); ++page) {
      for (TileMask cells = manifold_.vertices(page); cells != 0; cells &= cells - 1) {
        const ManifoldVertex v{page, __builtin_ctzll(cells)};
        if (IsContact(v)) contacts_.push_back({.vertex = v, .obstacle = Touched(islands, manifold_.CellOf(v))});
      }
    }
    std::stable_sort(contacts_.begin(), contacts_.end(), [this](const TetherContact& a, const TetherContact& b) {
      return manifold_.distance(a.vertex) < manifold_.distance(b.vertex);
    });
    FindRuns();
    return std::move(contacts_);
  }

 private:
  bool IsBesideBlocked(GridCell cell) const { return beside_[ground_.grid().index(cell.column, cell.row)]; }

  bool IsContact(ManifoldVertex v) const {
    if (!IsBesideBlocked(manifold_.CellOf(v))) return false;
    const auto d = DirectionToBase(manifold_, v);
    return d && !IsBesideBlocked(Beside(manifold_.CellOf(v), *d));
  }

  std::optional<ObstacleId> Touched(const std::vector<std::int32_t>& islands, GridCell cell) const {
    for (int d = 0; d < kDirections; ++d) {
      const GridCell at = Beside(cell, d);
      if (!ground_.grid().contains(at.column, at.row)) continue;
      const std::int32_t island = islands[ground_.grid().index(at.column, at.row)];
      if (island != kWall) return ObstacleId(static_cast<std::size_t>(island));
    }
    return std::nullopt;
  }

  void FindRuns() {
    const auto key = [](ManifoldVertex v) { return std::uint64_t{v.page} * 64 + static_cast<std::uint64_t>(v.cell); };
    std::unordered_map<std::uint64_t, std::size_t> number_of;
    for (std::size_t i = 0; i < contacts_.size(); ++i) number_of[key(contacts_[i].vertex)] = i;
    DisjointSets runs(contacts_.size());
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      for (int d = 0; d < kDirections; ++d) {
        const auto to = manifold_.Step(contacts_[i].vertex, d);
        const auto found = to ? number_of.find(key(*to)) : number_of.end();
        if (found == number_of.end() || contacts_[found->second].obstacle != contacts_[i].obstacle) continue;
        runs.Unite(i, found->second);
      }
    }
    for (std::size_t i = 0; i < contacts_.size(); ++i) contacts_[i].run = runs.Find(i);
  }

  const GridManifold& manifold_;
  const CellGround& ground_;
  std::vector<bool> beside_;
  std::vector<TetherContact> contacts_;
};

}  // namespace

std::vector<TetherContact> FindTetherContacts(const GridManifold& manifold) { return ContactFinder(manifold).Find(); }

}  // namespace tautline
