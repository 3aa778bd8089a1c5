#include "tautline/geometry/box_index.h"

#include <cmath>

namespace tautline {
namespace {

/// The most cells that an index may have; a longer side of the grid would waste memory on empty cells.
constexpr double kMaxCells = 1 << 22;

std::pair<int, int> Range(double low, double high, double origin, double cell, int count) {
  const auto at = [&](double value) {
    return static_cast<int>(std::clamp(std::floor((value - origin) / cell), 0.0, static_cast<double>(count - 1)));
  };
  return {at(low), at(high)};
}

}  // namespace

BoxIndex::BoxIndex(std::span<const Segment> segments) {
  Box box;
  for (const auto& [a, b] : segments) {
    box.Add(a);
    box.Add(b);
  }
  if (box.empty()) box.Add({0, 0});
  low_ = box.low;
  const Point size = box.size();
  const double longest = std::max({size.x, size.y, 1e-300});
  const double cells = std::min(kMaxCells, 1.0 + static_cast<double>(segments.size()));
  cell_ =
      std::max(std::sqrt(std::max(size.x, 1e-6 * longest) * std::max(size.y, 1e-6 * longest) / cells), longest / 20000);
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const auto& [a, b] : segments) {
    ForEachCell(a, b, 0, [this](std::size_t cell) { ++begin_[cell + 1]; });
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  items_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    ForEachCell(segments[i].first, segments[i].second, 0,
                [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::int32_t>(i); });
  }
}

std::pair<int, int> BoxIndex::Columns(double low, double high) const {
  return Range(low, high, low_.x, cell_, columns_);
}

std::pair<int, int> BoxIndex::Rows(double low, double high) const { return Range(low, high, low_.y, cell_, rows_); }

}  // namespace tautline
