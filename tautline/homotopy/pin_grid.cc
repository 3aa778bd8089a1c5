#include "tautline/homotopy/pin_grid.h"

#include <cmath>

namespace tautline {

PinGrid::PinGrid(std::span<const Point> pins, std::span<const Point> places) {
  const Box box = places.empty() ? Box{{0, 0}, {1, 1}} : BoundingBox(places);
  const Point size = box.size();
  low_ = box.low;
  const double count = static_cast<double>(std::max<std::size_t>(pins.size(), 1));
  cell_ = std::max({std::sqrt(size.x * size.y / count), std::max(size.x, size.y) / count, 1e-9});
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  pins_.resize(cells);
  strings_.resize(cells);
  for (std::size_t i = 0; i < pins.size(); ++i) Add(PinId(i), pins[i]);
}

int PinGrid::Column(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - low_.x) / cell_), 0.0, static_cast<double>(columns_ - 1)));
}

int PinGrid::Row(double y) const {
  return static_cast<int>(std::clamp(std::floor((y - low_.y) / cell_), 0.0, static_cast<double>(rows_ - 1)));
}

std::size_t PinGrid::CellOf(Point p) const {
  return static_cast<std::size_t>(Row(p.y)) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(Column(p.x));
}

void PinGrid::Remove(PinId pin, Point at) {
  auto& there = pins_[CellOf(at)];
  there.erase(std::remove(there.begin(), there.end(), pin), there.end());
}

void PinGrid::Place(StringId string, std::span<const Point> line) {
  if (cells_of_.size() <= string.index()) cells_of_.resize(string.index() + 1);
  std::vector<std::uint32_t> now;
  for (std::size_t i = 1; i < line.size(); ++i) {
    ForEachCell(line[i - 1], line[i], line[i],
                [&](std::size_t cell) { now.push_back(static_cast<std::uint32_t>(cell)); });
  }
  std::sort(now.begin(), now.end());
  now.erase(std::unique(now.begin(), now.end()), now.end());
  auto& before = cells_of_[string.index()];
  if (now == before) return;
  for (const std::uint32_t cell : before) {
    if (std::binary_search(now.begin(), now.end(), cell)) continue;
    auto& there = strings_[cell];
    there.erase(std::remove(there.begin(), there.end(), string), there.end());
  }
  for (const std::uint32_t cell : now) {
    if (!std::binary_search(before.begin(), before.end(), cell)) strings_[cell].push_back(string);
  }
  before = std::move(now);
}

std::vector<StringId> PinGrid::StringsAlong(Point a, Point b) const {
  std::vector<StringId> strings;
  ForEachCell(a, b, b,
              [&](std::size_t cell) { strings.insert(strings.end(), strings_[cell].begin(), strings_[cell].end()); });
  std::sort(strings.begin(), strings.end());
  strings.erase(std::unique(strings.begin(), strings.end()), strings.end());
  return strings;
}

}  // namespace tautline
