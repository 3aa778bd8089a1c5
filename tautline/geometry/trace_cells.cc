#include "tautline/geometry/trace_cells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// The directions of travel along the lattice, counter-clockwise: east, north, west, south.
constexpr std::array<std::pair<int, int>, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

constexpr int Left(int direction) { return (direction + 1) % 4; }
constexpr int Right(int direction) { return (direction + 3) % 4; }

struct Lattice {
  int i = 0;
  int j = 0;

  friend bool operator==(const Lattice&, const Lattice&) = default;
};

Lattice Step(Lattice p, int direction) {
  const auto [di, dj] = kSteps[static_cast<std::size_t>(direction)];
  return {p.i + di, p.j + dj};
}

/// The cell to the left of the lattice edge that leaves p in a direction, by its lower left corner.
Lattice CellLeft(Lattice p, int direction) {
  constexpr std::array<std::pair<int, int>, 4> kOffsets{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  const auto [di, dj] = kOffsets[static_cast<std::size_t>(direction)];
  return {p.i + di, p.j + dj};
}

Lattice CellRight(Lattice p, int direction) { return CellLeft(p, Right(direction)); }

/// Follows the boundary of the blocked cells with the blocked side on the left.
class Tracer {
 public:
  explicit Tracer(const OccupancyGrid& grid)
      : grid_(grid), label_(grid.cells.size(), kNone), used_(grid.cells.size()) {}

  std::vector<PolygonWithHoles> Run() {
    for (int row = 0; row < grid_.rows; ++row) {
      for (int column = 0; column < grid_.columns; ++column) VisitCell({column, row});
    }
    return std::move(polygons_);
  }

 private:
  static constexpr std::int32_t kNone = -1;

  bool Blocked(Lattice cell) const {
    return grid_.contains(cell.i, cell.j) && grid_.at(cell.i, cell.j) == CellState::kBlocked;
  }

  /// Every ring has an edge that runs east, with a blocked cell above and a free one below. The lowest such cell of a
  /// component in scan order lies on its outer boundary, so that the outer ring is found before the holes.
  void VisitCell(Lattice cell) {
    if (!Blocked(cell)) return;
    if (label_[grid_.index(cell.i, cell.j)] == kNone) {
      Flood(cell);
      polygons_.push_back({Trace(cell), {}});
      return;
    }
    const Lattice below{cell.i, cell.j - 1};
    if (Blocked(below) || used_[grid_.index(cell.i, cell.j)]) return;
    const auto label = static_cast<std::size_t>(label_[grid_.index(cell.i, cell.j)]);
    polygons_[label].holes.push_back(Trace(cell));
  }

  /// Labels the 8-connected component of the cell.
  void Flood(Lattice seed) {
    const auto label = static_cast<std::int32_t>(polygons_.size());
    stack_.assign(1, seed);
    label_[grid_.index(seed.i, seed.j)] = label;
    while (!stack_.empty()) {
      const Lattice cell = stack_.back();
      stack_.pop_back();
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) Label({cell.i + di, cell.j + dj}, label);
      }
    }
  }

  void Label(Lattice cell, std::int32_t label) {
    if (!Blocked(cell) || label_[grid_.index(cell.i, cell.j)] != kNone) return;
    label_[grid_.index(cell.i, cell.j)] = label;
    stack_.push_back(cell);
  }

  /// The ring through the south side of a cell.
  Ring Trace(Lattice cell) {
    Ring ring;
    Lattice p = cell;
    int direction = 0;
    do {
      if (direction == 0) used_[grid_.index(p.i, p.j)] = true;
      p = Step(p, direction);
      const int next = Turn(p, direction);
      if (next != direction) ring.push_back(LatticePoint(grid_, p.i, p.j));
      direction = next;
    } while (p != cell || direction != 0);
    return ring;
  }

  /// The direction in which the boundary goes on from p. Where two blocked cells meet diagonally it turns right, to
  /// the other one of them.
  int Turn(Lattice p, int direction) const {
    if (Blocked(CellRight(p, direction))) return Right(direction);
    return Blocked(CellLeft(p, direction)) ? direction : Left(direction);
  }

  const OccupancyGrid& grid_;
  std::vector<std::int32_t> label_;  ///< Of a blocked cell: the index of its polygon.
  std::vector<bool> used_;           ///< Whether a ring already runs along the south side of the cell.
  std::vector<PolygonWithHoles> polygons_;
  std::vector<Lattice> stack_;
};

}  // namespace

std::vector<PolygonWithHoles> TraceBlockedCells(const OccupancyGrid& grid) {
  TAUTLINE_CHECK(grid.cells.size() == static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  return Tracer(grid).Run();
}

std::size_t CountTracedCorners(const OccupancyGrid& grid) {
  const auto blocked = [&grid](int column, int row) {
    return grid.contains(column, row) && grid.at(column, row) == CellState::kBlocked;
  };
  std::size_t corners = 0;
  for (int j = 0; j <= grid.rows; ++j) {
    bool low_left = false, high_left = false;
    for (int i = 0; i <= grid.columns; ++i) {
      const bool low = blocked(i, j - 1), high = blocked(i, j);
      const int count = low + high + low_left + high_left;
      if (count % 2 == 1) ++corners;
      if (count == 2 && low != high && low == high_left) corners += 2;
      low_left = low;
      high_left = high;
    }
  }
  return corners;
}

}  // namespace tautline
