// A uniform grid of buckets over segments: which of them come near a box.
#ifndef TAUTLINE_GEOMETRY_BOX_INDEX_H_
#define TAUTLINE_GEOMETRY_BOX_INDEX_H_

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// Finds segments by place. A segment is stored in every cell that it may pass; a query visits each candidate at
/// least once, and perhaps several times.
class BoxIndex {
 public:
  /// The two ends of a segment, metres.
  using Segment = std::pair<Point, Point>;

  /// O(n) cells; long segments cost one entry per cell along them. Points are segments of length zero.
  explicit BoxIndex(std::span<const Segment> segments);

  /// Calls visit(position) for every segment whose cells meet the box. Repeats are possible.
  template <class Visit>
  void ForEachNear(const Box& box, Visit visit) const {
    const auto [first_column, last_column] = Columns(box.low.x, box.high.x);
    const auto [first_row, last_row] = Rows(box.low.y, box.high.y);
    for (int row = first_row; row <= last_row; ++row) {
      for (int column = first_column; column <= last_column; ++column) {
        const std::size_t cell = CellAt(column, row);
        for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(static_cast<std::size_t>(items_[k]));
      }
    }
  }

  /// As ForEachNear over the cells that the segment from a to b, widened by `margin`, passes.
  template <class Visit>
  void ForEachAlong(Point a, Point b, double margin, Visit visit) const {
    ForEachCell(a, b, margin, [&](std::size_t cell) {
      for (std::size_t k = begin_[cell]; k < begin_[cell + 1]; ++k) visit(static_cast<std::size_t>(items_[k]));
    });
  }

 private:
  std::pair<int, int> Columns(double low, double high) const;
  std::pair<int, int> Rows(double low, double high) const;
  std::size_t CellAt(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  template <class Visit>
  void ForEachCell(Point a, Point b, double margin, Visit visit) const;

  Point low_;
  double cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::size_t> begin_;
  std::vector<std::int32_t> items_;
};

// --- implementation of the template ---

template <class Visit>
void BoxIndex::ForEachCell(Point a, Point b, double margin, Visit visit) const {
  if (b.x < a.x) std::swap(a, b);
  // Rounding in the interpolation below stays far under this share of a cell.
  const double pad = margin + 1e-3 * cell_;
  const auto [first, last] = Columns(a.x - pad, b.x + pad);
  const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
  for (int column = first; column <= last; ++column) {
    double y0 = a.y, y1 = b.y;
    if (b.x > a.x) {
      const double left = std::clamp(low_.x + column * cell_ - pad, a.x, b.x);
      const double right = std::clamp(low_.x + (column + 1) * cell_ + pad, a.x, b.x);
      y0 = a.y + slope * (left - a.x);
      y1 = right == b.x ? b.y : a.y + slope * (right - a.x);
    }
    const auto [first_row, last_row] = Rows(std::min(y0, y1) - pad, std::max(y0, y1) + pad);
    for (int row = first_row; row <= last_row; ++row) visit(CellAt(column, row));
  }
}

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_BOX_INDEX_H_
