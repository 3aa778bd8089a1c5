#include "tautline/geometry/snap_rounding.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"
#include "tautline/geometry/box_index.h"

namespace tautline {
namespace {

using Node = SnapGrid::Node;
// Wide enough for products of three coordinate differences: 3 * 41 bits and a sign.
__extension__ using Wide = __int128;

Wide Cross(Node a, Node b, Node c) {
  return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
}

int Sign(Wide value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

bool ProperlyCross(const GridSegment& s, const GridSegment& t) {
  return Sign(Cross(s.from, s.to, t.from)) * Sign(Cross(s.from, s.to, t.to)) < 0 &&
         Sign(Cross(t.from, t.to, s.from)) * Sign(Cross(t.from, t.to, s.to)) < 0;
}

/// numerator / denominator rounded to the nearest integer, halves up. Requires denominator > 0.
std::int64_t RoundedQuotient(Wide numerator, Wide denominator) {
  const Wide twice = 2 * numerator + denominator;
  Wide quotient = twice / (2 * denominator);
  if (quotient * 2 * denominator > twice) --quotient;
  return static_cast<std::int64_t>(quotient);
}

/// The grid node whose pixel contains the crossing of s and t. Requires a proper crossing.
Node CrossingNode(const GridSegment& s, const GridSegment& t) {
  const Wide from = Cross(t.from, t.to, s.from), to = Cross(t.from, t.to, s.to);
  Wide numerator = from, denominator = from - to;
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  return {s.from.x + RoundedQuotient(numerator * (s.to.x - s.from.x), denominator),
          s.from.y + RoundedQuotient(numerator * (s.to.y - s.from.y), denominator)};
}

/// Whether the segment meets the pixel of `node`: the square of side 1 around it with its left and lower sides,
/// without its right and upper ones. Coordinates are doubled so that corners are integers.
bool MeetsPixel(const GridSegment& s, Node node) {
  const Node a{2 * (s.from.x - node.x), 2 * (s.from.y - node.y)}, b{2 * (s.to.x - node.x), 2 * (s.to.y - node.y)};
  if (std::max(a.x, b.x) < -1 || std::min(a.x, b.x) > 1 || std::max(a.y, b.y) < -1 || std::min(a.y, b.y) > 1) {
    return false;
  }
  const int lower_left = Sign(Cross(a, b, {-1, -1})), upper_right = Sign(Cross(a, b, {1, 1}));
  const int lower_right = Sign(Cross(a, b, {1, -1})), upper_left = Sign(Cross(a, b, {-1, 1}));
  const int least = std::min({lower_left, upper_right, lower_right, upper_left});
  const int greatest = std::max({lower_left, upper_right, lower_right, upper_left});
  // Separating axes: the box test above and the segment's normal. A segment that only touches a corner counts when
  // that corner belongs to the pixel. (Ends are nodes, never on a pixel's sides.)
  if (least < 0 && greatest > 0) return true;
  return lower_left == 0;
}

Point ToDouble(Node node) { return {static_cast<double>(node.x), static_cast<double>(node.y)}; }

std::vector<BoxIndex::Segment> ToDoubles(std::span<const GridSegment> segments) {
  std::vector<BoxIndex::Segment> doubles;
  doubles.reserve(segments.size());
  for (const GridSegment& s : segments) doubles.emplace_back(ToDouble(s.from), ToDouble(s.to));
  return doubles;
}

/// All nodes whose pixels hold an end of a segment or a proper crossing of two, sorted.
std::vector<Node> HotNodes(std::span<const GridSegment> segments) {
  std::vector<Node> hot;
  hot.reserve(2 * segments.size());
  const std::vector<BoxIndex::Segment> doubles = ToDoubles(segments);
  const BoxIndex index(doubles);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    hot.push_back(segments[i].from);
    hot.push_back(segments[i].to);
    index.ForEachAlong(doubles[i].first, doubles[i].second, 0, [&](std::size_t j) {
      if (j < i && ProperlyCross(segments[i], segments[j])) hot.push_back(CrossingNode(segments[i], segments[j]));
    });
  }
  std::sort(hot.begin(), hot.end());
  hot.erase(std::unique(hot.begin(), hot.end()), hot.end());
  return hot;
}

}  // namespace

SnapGrid::SnapGrid(const Box& box) {
  const double extent = std::max({box.size().x, box.size().y, 1e-200});
  const double greatest =
      std::max({std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y), extent});
  // 2^39 spacings from the centre to the side leave a factor of two for whoever goes a little beyond the box.
  int extent_exponent = 0, greatest_exponent = 0;
  std::frexp(extent, &extent_exponent);
  std::frexp(greatest, &greatest_exponent);
  spacing_ = std::ldexp(1.0, std::max(extent_exponent - 40, greatest_exponent - 51));
  centre_x_ = std::llround(box.centre().x / spacing_);
  centre_y_ = std::llround(box.centre().y / spacing_);
}

SnapGrid::Node SnapGrid::Round(Point p) const {
  const Node node{std::llround(p.x / spacing_) - centre_x_, std::llround(p.y / spacing_) - centre_y_};
  TAUTLINE_CHECK(std::max(std::abs(node.x), std::abs(node.y)) <= kLimit);
  return node;
}

Point SnapGrid::ToPoint(Node node) const {
  return {static_cast<double>(node.x + centre_x_) * spacing_, static_cast<double>(node.y + centre_y_) * spacing_};
}

std::vector<std::vector<SnapGrid::Node>> SnapRound(std::span<const GridSegment> segments) {
  const std::vector<Node> hot = HotNodes(segments);
  std::vector<BoxIndex::Segment> places;
  places.reserve(hot.size());
  for (const Node node : hot) places.emplace_back(ToDouble(node), ToDouble(node));
  const BoxIndex index(places);
  std::vector<std::vector<Node>> chains;
  chains.reserve(segments.size());
  for (const GridSegment& s : segments) {
    const auto along = [&s](Node node) {
      return static_cast<Wide>(node.x - s.from.x) * (s.to.x - s.from.x) +
             static_cast<Wide>(node.y - s.from.y) * (s.to.y - s.from.y);
    };
    std::vector<Node> chain;
    index.ForEachAlong(ToDouble(s.from), ToDouble(s.to), 1, [&](std::size_t k) {
      if (MeetsPixel(s, hot[k])) chain.push_back(hot[k]);
    });
    std::sort(chain.begin(), chain.end(), [&](Node a, Node b) {
      const Wide at_a = along(a), at_b = along(b);
      return at_a != at_b ? at_a < at_b : a < b;
    });
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    TAUTLINE_CHECK(chain.front() == s.from && chain.back() == s.to);
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace tautline
