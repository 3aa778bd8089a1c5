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
    // In the lower quadrants swap x and y, in the right one of them after mirroring both. Without branches, which
    // nothing could predict.
    const std::uint32_t lower = top - 1, mirror = lower & (0 - right) & 0xffff;
    x ^= mirror;
    y ^= mirror;
    const std::uint32_t swap = (x ^ y) & lower;
    x ^= swap;
    y ^= swap;
  }
  return key;
}

}  // namespace

std::vector<std::int32_t> HilbertOrder(std::span<const Point> points) {
  const Box box = BoundingBox(points);
  const double extent = std::max({box.size().x, box.size().y, 1e-300});
  std::vector<std::uint64_t> keyed;  // The key above the position: one integer to compare.
  keyed.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point scaled = 65535 / extent * (points[i] - box.low);
    const std::uint64_t key = HilbertKey(static_cast<std::uint32_t>(scaled.x), static_cast<std::uint32_t>(scaled.y));
    keyed.push_back(key << 32 | i);
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::int32_t> order;
  order.reserve(points.size());
  for (const std::uint64_t key : keyed) order.push_back(static_cast<std::int32_t>(key & 0xffffffff));
  return order;
}

}  // namespace tautline
