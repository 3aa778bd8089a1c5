#include "tautline/geometry/hilbert_order.h"

#include <algorithm>
#include <utility>

#include "tautline/geometry/polygon.h"

namespace tautline {
namespace {

/// The distance along the Hilbert curve of order 16 of the cell (x, y), both below 2^16.
std::uint32_t HilbertKey(std::uint32_t x, std::uint32_t y) {
  std::uint32_t key = 0;
  for (std::uint32_t side = 1U << 15; side > 0; side >>= 1) {
    const std::uint32_t right = (x & side) != 0 ? 1 : 0;
    const std::uint32_t top = (y & side) != 0 ? 1 : 0;
    key = 4 * key + ((3 * right) ^ top);
    if (top == 0) {
      if (right == 1) {
        x = 0xffff - x;
        y = 0xffff - y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

}  // namespace

std::vector<std::int32_t> HilbertOrder(std::span<const Point> points) {
  const Box box = BoundingBox(points);
  const double extent = std::max({box.size().x, box.size().y, 1e-300});
  std::vector<std::pair<std::uint32_t, std::int32_t>> keyed;
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point scaled = 65535 / extent * (points[i] - box.low);
    keyed.emplace_back(HilbertKey(static_cast<std::uint32_t>(scaled.x), static_cast<std::uint32_t>(scaled.y)),
                       static_cast<std::int32_t>(i));
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::int32_t> order;
  order.reserve(points.size());
  for (const auto& [key, position] : keyed) order.push_back(position);
  return order;
}

}  // namespace tautline
