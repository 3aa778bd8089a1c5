#include "tautline/planners/grid_manifold/cell_ground.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/tile_relaxation.h"

namespace tautline {
namespace {

constexpr std::int32_t kNone = -1;
/// Of a cell: what rounding leaves of a coordinate on a side.
constexpr double kOnSide = 1e-9;

/// The islands of blocked cells: by cell its island, and by island its highest cell, the first of those.
struct CellIslands {
  std::vector<std::int32_t> of_cell;
  std::vector<GridCell> top;
};

/// Marks the blocked cells joined to `start` and says whether they reach the border.
class IslandFinder {
 public:
  explicit IslandFinder(const OccupancyGrid& grid) : grid_(grid) { islands_.of_cell.assign(grid.cells.size(), kNone); }

  CellIslands Find() {
    std::vector<bool> seen(grid_.cells.size());
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) {
        if (grid_.at(column, row) == CellState::kFree || seen[grid_.index(column, row)]) continue;
        Collect({column, row}, seen);
        if (!touches_border_) AddIsland();
      }
    }
    return std::move(islands_);
  }

 private:
  void Collect(GridCell start, std::vector<bool>& seen) {
    cells_.assign(1, start);
    seen[grid_.index(start.column, start.row)] = true;
    touches_border_ = false;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const GridCell cell = cells_[i];
      touches_border_ = touches_border_ || cell.column == 0 || cell.row == 0 || cell.column == grid_.columns - 1 ||
                        cell.row == grid_.rows - 1;
      for (std::size_t d = 0; d < kDirections; ++d) {
        const GridCell beside{cell.column + kStepColumns[d], cell.row + kStepRows[d]};
        if (!grid_.contains(beside.column, beside.row)) continue;
        const std::size_t index = grid_.index(beside.column, beside.row);
        if (seen[index] || grid_.cells[index] == CellState::kFree) continue;
        seen[index] = true;
        cells_.push_back(beside);
      }
    }
  }

  void AddIsland() {
    const auto island = static_cast<std::int32_t>(islands_.top.size());
    GridCell top = cells_[0];
    for (const GridCell cell : cells_) {
      islands_.of_cell[grid_.index(cell.column, cell.row)] = island;
      if (cell.row > top.row || (cell.row == top.row && cell.column < top.column)) top = cell;
    }
    islands_.top.push_back(top);
  }

  const OccupancyGrid& grid_;
  CellIslands islands_;
  std::vector<GridCell> cells_;
  bool touches_border_ = false;
};

}  // namespace

CellGround::CellGround(OccupancyGrid grid, std::span<const IslandName> names) : grid_(std::move(grid)) {
  free_cells_ = CountCells(grid_, CellState::kFree);
  TAUTLINE_CHECK(CountCells(grid_, CellState::kUnknown) == 0);
  const CellIslands islands = IslandFinder(grid_).Find();
  std::vector<bool> named(islands.top.size());
  // The ray runs between the two columns of centres on its sides; a centre on it counts as being to its right.
  const auto add = [&](std::string name, double x, int row) {
    rays_.push_back({static_cast<int>(std::ceil(x - 0.5)), row, x, ObstacleId(names_.size())});
    names_.push_back(std::move(name));
  };
  for (const IslandName& name : names) {
    const auto cell = CellAt(name.representative);
    const std::int32_t island = cell ? islands.of_cell[grid_.index(cell->column, cell->row)] : kNone;
    if (island == kNone || named[static_cast<std::size_t>(island)]) continue;
    named[static_cast<std::size_t>(island)] = true;
    add(name.name, LocalOf(name.representative).x, cell->row);
  }
  std::size_t unnamed = 0;
  for (std::size_t i = 0; i < islands.top.size(); ++i) {
    if (!named[i]) add("cells" + std::to_string(++unnamed), islands.top[i].column + 0.5, islands.top[i].row);
  }
  std::stable_sort(rays_.begin(), rays_.end(), [](const Ray& a, const Ray& b) {
    return std::pair(a.column, a.x) < std::pair(b.column, b.x);  // Equal ones by ObstacleId.
  });
  first_ray_.assign(static_cast<std::size_t>(grid_.columns) + 1, 0);
  for (const Ray& ray : rays_) ++first_ray_[static_cast<std::size_t>(std::min(ray.column, grid_.columns - 1)) + 1];
  for (std::size_t i = 1; i < first_ray_.size(); ++i) first_ray_[i] += first_ray_[i - 1];
}

std::span<const CellGround::Ray> CellGround::RaysBefore(int column) const {
  const auto first = static_cast<std::size_t>(first_ray_[static_cast<std::size_t>(column)]);
  const auto last = static_cast<std::size_t>(first_ray_[static_cast<std::size_t>(column) + 1]);
  return std::span<const Ray>(rays_).subspan(first, last - first);
}

/// In cells, from the lower left corner of the grid.
Point CellGround::LocalOf(Point p) const {
  const Point d = p - grid_.origin;
  if (grid_.yaw_rad == 0) return {d.x / grid_.cell_m, d.y / grid_.cell_m};
  const double c = std::cos(grid_.yaw_rad), s = std::sin(grid_.yaw_rad);
  return {(c * d.x + s * d.y) / grid_.cell_m, (c * d.y - s * d.x) / grid_.cell_m};
}

GridCell CellGround::StartOf(const Ray& ray) const {
  return {std::clamp(static_cast<int>(std::floor(ray.x + kOnSide)), 0, columns() - 1), ray.above_row};
}

std::optional<GridCell> CellGround::CellAt(Point p) const {
  const Point local = LocalOf(p);
  const auto in = [](double at, int count) -> std::optional<int> {
    if (!(at >= -kOnSide && at <= count + kOnSide)) return std::nullopt;
    return std::clamp(static_cast<int>(std::floor(at + kOnSide)), 0, count - 1);
  };
  const auto column = in(local.x, grid_.columns), row = in(local.y, grid_.rows);
  if (!column || !row) return std::nullopt;
  return GridCell{*column, *row};
}

Point CellGround::CentreOf(GridCell cell) const {
  const Point local{(cell.column + 0.5) * grid_.cell_m, (cell.row + 0.5) * grid_.cell_m};
  if (grid_.yaw_rad == 0) return grid_.origin + local;
  const double c = std::cos(grid_.yaw_rad), s = std::sin(grid_.yaw_rad);
  return grid_.origin + Point{c * local.x - s * local.y, s * local.x + c * local.y};
}

bool CellGround::CanStep(GridCell from, int direction) const {
  const auto d = static_cast<std::size_t>(direction);
  if (!IsFree(from) || !IsFree({from.column + kStepColumns[d], from.row + kStepRows[d]})) return false;
  return d % 2 == 0 || IsFree({from.column + kStepColumns[d], from.row}) ||
         IsFree({from.column, from.row + kStepRows[d]});
}

}  // namespace tautline
