#include "tautline/planners/grid_manifold/map_cells.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tautline/scene/number_text.h"
#include "tautline/scene/obstacle_naming.h"

namespace tautline {
namespace {

/// Ground that reaches so far into a cell still only touches it, in cells: what rounding and snapping may leave.
constexpr double kTouching = 1e-6;

/// Blocks the cells of a lattice that are not wholly free.
class Rasterizer {
 public:
  Rasterizer(const FreeSpace& space, OccupancyGrid grid) : grid_(std::move(grid)) {
    cosine_ = std::cos(grid_.yaw_rad), sine_ = grid_.yaw_rad == 0 ? 0 : std::sin(grid_.yaw_rad);
    if (grid_.yaw_rad == 0) cosine_ = 1;
    touching_ = std::max(kTouching, BoundaryTolerance(space) / grid_.cell_m);
    crossings_.resize(static_cast<std::size_t>(grid_.rows));
    for (const FreeComponent& component : space.components) {
      AddRing(component.outer.points);
      for (const BoundaryRing& hole : component.holes) AddRing(hole.points);
    }
  }

  OccupancyGrid Make() {
    std::fill(grid_.cells.begin(), grid_.cells.end(), CellState::kBlocked);
    for (int row = 0; row < grid_.rows; ++row) FreeCentres(row);
    for (const auto& [a, b] : edges_) BlockAlong(a, b);
    return std::move(grid_);
  }

 private:
  void AddRing(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = LocalOf(ring[i]), b = LocalOf(ring[(i + 1) % ring.size()]);
      edges_.emplace_back(a, b);
      AddCrossings(a, b);
    }
  }

  Point LocalOf(Point p) const {
    const Point d = p - grid_.origin;
    return {(cosine_ * d.x + sine_ * d.y) / grid_.cell_m, (cosine_ * d.y - sine_ * d.x) / grid_.cell_m};
  }

  /// Where an edge crosses the lines through the centres of the rows.
  void AddCrossings(Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const int first = std::max(0, static_cast<int>(std::ceil(a.y - 0.5)));
    for (int row = first; row < grid_.rows && row + 0.5 < b.y; ++row) {
      const double x = a.x + (b.x - a.x) * ((row + 0.5 - a.y) / (b.y - a.y));
      crossings_[static_cast<std::size_t>(row)].push_back(x);
    }
  }

  /// Frees the cells of a row whose centres lie between an odd crossing and the next.
  void FreeCentres(int row) {
    auto& at = crossings_[static_cast<std::size_t>(row)];
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(at[i] - 0.5)));
      for (int column = from; column < grid_.columns && column + 0.5 < at[i + 1]; ++column) {
        grid_.cells[grid_.index(column, row)] = CellState::kFree;
      }
    }
  }

  /// Blocks the cells that an edge passes through: those under its share of each row.
  void BlockAlong(Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const int last = std::min(grid_.rows - 1, static_cast<int>(std::floor(b.y)));
    for (int row = std::max(0, static_cast<int>(std::floor(a.y))); row <= last; ++row) {
      const double low = std::max(a.y, row + touching_), high = std::min(b.y, row + 1 - touching_);
      if (low > high) continue;
      const auto x_at = [&](double y) { return a.y == b.y ? a.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)); };
      double x0 = x_at(low), x1 = a.y == b.y ? b.x : x_at(high);
      if (x1 < x0) std::swap(x0, x1);
      const int from = std::max(0, static_cast<int>(std::floor(x0 + touching_)));
      const int to = std::min(grid_.columns - 1, static_cast<int>(std::ceil(x1 - touching_)) - 1);
      // An edge along a side lies in neither of its cells: then `to` is before `from`, or the cell is only touched.
      for (int column = from; column <= to; ++column) {
        if (x1 <= column + touching_ || x0 >= column + 1 - touching_) continue;
        grid_.cells[grid_.index(column, row)] = CellState::kBlocked;
      }
    }
  }

  OccupancyGrid grid_;
  double cosine_ = 1, sine_ = 0, touching_ = 0;
  std::vector<std::pair<Point, Point>> edges_;  ///< In cells, from the lower left corner of the grid.
  std::vector<std::vector<double>> crossings_;  ///< By row.
};

Expected<OccupancyGrid> Lattice(const World& world, const FreeSpace& space, const MapCellsOptions& options) {
  OccupancyGrid grid;
  if (world.cells && (!options.resolution_m || *options.resolution_m == world.cells->cell_m)) {
    grid = *world.cells;
    return grid;
  }
  if (!options.resolution_m) {
    return InvalidInput("this world has no cells of its own; give the side of a cell, as in --resolution 0.1");
  }
  grid.cell_m = *options.resolution_m;
  grid.origin = space.box.low;
  const Point size = space.box.size();
  // A side that is a whole number of cells but for rounding gets no cell more.
  const auto count = [&](double length) { return std::max(1.0, std::ceil(length / grid.cell_m - kTouching)); };
  const double columns = count(size.x), rows = count(size.y);
  if (!(columns * rows <= static_cast<double>(kMostGroundCells))) {
    return tl::unexpected<Error>({ErrorCode::kLimitExceeded,
                                  "cells of " + FormatNumber(grid.cell_m) + " m make " + ShortNumber(columns) + " x " +
                                      ShortNumber(rows) + " of them, more than 400 million: give a larger --resolution",
                                  ""});
  }
  grid.columns = static_cast<int>(columns), grid.rows = static_cast<int>(rows);
  grid.cells.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  return grid;
}

/// Whether the cells of the map say all about the ground.
bool IsPlainMap(const World& world, const MapCellsOptions& options) {
  if (!world.cells || world.clearance != 0 || (world.map && world.map->simplify != 0)) return false;
  if (options.resolution_m && *options.resolution_m != world.cells->cell_m) return false;
  return std::all_of(world.obstacles.begin(), world.obstacles.end(), [](const Obstacle& o) { return o.from_map; });
}

}  // namespace

Expected<CellGround> MakeCellGround(const World& world, const MapCellsOptions& options) {
  if (options.resolution_m && !(*options.resolution_m > 0 && std::isfinite(*options.resolution_m))) {
    return InvalidInput("the side of a cell must be a number larger than 0", "--resolution");
  }
  std::vector<IslandName> names;
  if (IsPlainMap(world, options)) {
    const std::vector<std::string> given = ObstacleNames(world);
    for (std::size_t i = 0; i < given.size(); ++i) names.push_back({given[i], RepresentativeOf(world.obstacles[i])});
    const CellState unknown = options.unknown_free ? CellState::kFree : CellState::kBlocked;
    return CellGround(ResolveUnknown(*world.cells, unknown), names);
  }
  const auto space = BuildFreeSpace(world);
  if (!space) return tl::unexpected(space.error());
  auto grid = Lattice(world, *space, options);
  if (!grid) return tl::unexpected(grid.error());
  for (const Island& island : space->islands) names.push_back({island.name, island.representative});
  return CellGround(Rasterizer(*space, *std::move(grid)).Make(), names);
}

}  // namespace tautline
