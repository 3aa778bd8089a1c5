// Where a robot was, and how often: a count for each cell of a grid.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_VISIT_MAP_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_VISIT_MAP_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// Counts by cell. [Shimada2024, Figs. 8, 9]
class VisitMap {
 public:
  /// Covers a box with cells of `cell_m` metres, larger ones where there would be more than 512 in a row. Requires a
  /// box that is not empty and a positive cell.
  VisitMap(const Box& box, double cell_m) : low_(box.low) {
    constexpr double kMostCells = 512;
    cell_m_ = std::max(cell_m, std::max(box.size().x, box.size().y) / kMostCells);
    columns_ = CellsIn(box.size().x);
    rows_ = CellsIn(box.size().y);
    counts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  }

  /// Counts a visit; one outside of the box counts in the nearest cell.
  void Add(Point p) {
    const auto column = static_cast<std::size_t>(Clamped((p.x - low_.x) / cell_m_, columns_));
    const auto row = static_cast<std::size_t>(Clamped((p.y - low_.y) / cell_m_, rows_));
    ++counts_[row * static_cast<std::size_t>(columns_) + column];
  }

  /// The lower left corner of the first cell.
  Point low() const { return low_; }
  /// The side of a cell, metres.
  double cell_m() const { return cell_m_; }
  /// Cells in a row.
  int columns() const { return columns_; }
  /// Rows, from the lowest y on.
  int rows() const { return rows_; }
  /// Row by row.
  const std::vector<std::int64_t>& counts() const { return counts_; }
  /// Instead of those that were counted. Requires as many.
  void set_counts(std::vector<std::int64_t> counts) { counts_ = std::move(counts); }

 private:
  int CellsIn(double length_m) const { return std::max(1, static_cast<int>(std::ceil(length_m / cell_m_ - 1e-9))); }
  static int Clamped(double cell, int count) { return static_cast<int>(std::clamp(cell, 0.0, count - 1.0)); }

  Point low_;
  double cell_m_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::int64_t> counts_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_VISIT_MAP_H_
