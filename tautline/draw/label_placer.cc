#include "tautline/draw/label_placer.h"

#include <algorithm>
#include <array>

namespace tautline {
namespace {

constexpr double kGap = 4;  // Pixels between a label and what it names.
constexpr double kDiscouragedCost = 6;

bool Within(const Box& inner, const Box& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x &&
         inner.high.y <= outer.high.y;
}

/// Narrows [from, to] to where start + t * delta is within [low, high].
bool ClipAxis(double start, double delta, double low, double high, double& from, double& to) {
  if (delta == 0) return start >= low && start <= high;
  const double t0 = (low - start) / delta, t1 = (high - start) / delta;
  from = std::max(from, std::min(t0, t1));
  to = std::min(to, std::max(t0, t1));
  return from <= to;
}

}  // namespace

bool Overlap(const Box& a, const Box& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

bool Meets(const Box& box, Point a, Point b) {
  double from = 0, to = 1;
  return ClipAxis(a.x, b.x - a.x, box.low.x, box.high.x, from, to) &&
         ClipAxis(a.y, b.y - a.y, box.low.y, box.high.y, from, to);
}

void LabelPlacer::TakeLine(std::span<const Point> line) {
  for (std::size_t i = 1; i < line.size(); ++i) lines_.push_back({line[i - 1], line[i]});
}

double LabelPlacer::Cost(const Box& box) const {
  double cost = Within(box, frame_) ? 0 : 2 * kOverlap;
  for (const Box& taken : taken_) {
    if (Overlap(box, taken)) cost += kOverlap;
  }
  for (const Box& discouraged : discouraged_) {
    if (Overlap(box, discouraged)) cost += kDiscouragedCost;
  }
  for (const Segment& line : lines_) {
    if (Meets(box, line.a, line.b)) cost += kCrossing;
  }
  return cost;
}

LabelPlacer::Place LabelPlacer::FindBeside(const Box& around, Point size) const {
  const Point middle = around.centre();
  const double right = around.high.x + kGap + 0.5 * size.x, left = around.low.x - kGap - 0.5 * size.x;
  const double above = around.low.y - kGap - 0.5 * size.y, below = around.high.y + kGap + 0.5 * size.y;
  const std::array<Point, 12> centres = {{{right, middle.y},
                                          {left, middle.y},
                                          {middle.x, above},
                                          {middle.x, below},
                                          {right, above},
                                          {right, below},
                                          {left, above},
                                          {left, below},
                                          {right - 0.3 * size.x, above},
                                          {left + 0.3 * size.x, above},
                                          {right - 0.3 * size.x, below},
                                          {left + 0.3 * size.x, below}}};
  return FindAt(centres, size);
}

LabelPlacer::Place LabelPlacer::FindAt(std::span<const Point> centres, Point size, double later) const {
  Place best{{}, 1e300};
  double penalty = 0;
  for (const Point centre : centres) {
    const Box box{centre - 0.5 * size, centre + 0.5 * size};
    const double cost = Cost(box) + penalty;
    if (cost < best.cost) best = {box, cost};
    penalty += later;
  }
  return best;
}

}  // namespace tautline
