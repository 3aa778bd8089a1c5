// A grid of buckets over pins that move and strings between them. Internal to TautStrings.
#ifndef TAUTLINE_HOMOTOPY_PIN_GRID_H_
#define TAUTLINE_HOMOTOPY_PIN_GRID_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "tautline/homotopy/taut_strings.h"

namespace tautline {

/// Which pins and which strings are near something. What is outside of the box of the given places is kept at its rim.
class PinGrid {
 public:
  /// About as many cells as there are pins, over the box of `places`. O(n).
  PinGrid(std::span<const Point> pins, std::span<const Point> places);

  /// Where a pin stands from now on.
  void Add(PinId pin, Point at) { pins_[CellOf(at)].push_back(pin); }
  /// That it is gone from where it stood.
  void Remove(PinId pin, Point at);

  /// The cells that a string passes from now on. O(those of before + those of now).
  void Place(StringId string, std::span<const Point> line);

  /// Calls visit(pin) for all pins in the cells that the triangle touches, each once.
  template <class Visit>
  void ForEachPin(Point a, Point b, Point c, Visit visit) const {
    ForEachCell(a, b, c, [&](std::size_t cell) {
      for (const PinId pin : pins_[cell]) visit(pin);
    });
  }

  /// The strings that pass cells along a segment, in order, each once.
  std::vector<StringId> StringsAlong(Point a, Point b) const;

 private:
  std::size_t CellOf(Point p) const;
  int Column(double x) const;
  int Row(double y) const;
  template <class Visit>
  void ForEachCell(Point a, Point b, Point c, Visit visit) const;

  Point low_;
  double cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<PinId>> pins_;              ///< By cell.
  std::vector<std::vector<StringId>> strings_;        ///< By cell.
  std::vector<std::vector<std::uint32_t>> cells_of_;  ///< By StringId, in order.
};

// --- implementation of the template ---

template <class Visit>
void PinGrid::ForEachCell(Point a, Point b, Point c, Visit visit) const {
  // Rounding in the clipping below stays far under this share of a cell.
  const double pad = 1e-3 * cell_;
  const Point corners[3] = {a, b, c};
  const Box box = BoundingBox(corners);
  const int first = Column(box.low.x - pad), last = Column(box.high.x + pad);
  for (int column = first; column <= last; ++column) {
    // The cells at the rim reach out to infinity.
    const double left = column == 0 ? -1e300 : low_.x + column * cell_ - pad;
    const double right = column + 1 == columns_ ? 1e300 : low_.x + (column + 1) * cell_ + pad;
    double low = 1e300, high = -1e300;
    for (int k = 0; k < 3; ++k) {
      Point p = corners[k], q = corners[(k + 1) % 3];
      if (q.x < p.x) std::swap(p, q);
      if (q.x < left || p.x > right) continue;
      const double slope = q.x > p.x ? (q.y - p.y) / (q.x - p.x) : 0;
      const double y0 = p.x < left ? p.y + slope * (left - p.x) : p.y;
      const double y1 = q.x > right ? p.y + slope * (right - p.x) : q.y;
      low = std::min({low, y0, y1});
      high = std::max({high, y0, y1});
    }
    if (low > high) continue;
    const int last_row = Row(high + pad);
    for (int row = Row(low - pad); row <= last_row; ++row) {
      visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column));
    }
  }
}

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_PIN_GRID_H_
