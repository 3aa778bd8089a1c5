#include "tautline/geometry/ring_index.h"

#include <algorithm>
#include <bit>

#include "tautline/geometry/predicates.h"

namespace tautline {

RingIndex::RingIndex(std::span<const Point> ring) : ring_(ring) {
  while (leaves_ < ring.size()) leaves_ *= 2;
  boxes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    boxes_[leaves_ + i].Add(ring[i]);
    boxes_[leaves_ + i].Add(At(i + 1));
  }
  for (std::size_t node = leaves_ - 1; node > 0; --node) {
    for (const std::size_t child : {2 * node, 2 * node + 1}) {
      if (boxes_[child].empty()) continue;
      boxes_[node].Add(boxes_[child].low);
      boxes_[node].Add(boxes_[child].high);
    }
  }
}

Winding RingIndex::WindingAt(Point p) const {
  Winding winding;
  AddWinding(1, p, winding);
  return winding;
}

void RingIndex::AddWinding(std::size_t node, Point p, Winding& winding) const {
  const Box& box = boxes_[node];
  if (box.empty() || winding.on_boundary || p.y < box.low.y || p.y > box.high.y || p.x > box.high.x) return;
  // The edges under a node: those of its leftmost leaf up to those of its rightmost.
  const std::size_t run = leaves_ / std::bit_floor(node);
  const std::size_t first = node * run - leaves_, last = std::min(first + run, ring_.size());
  if (p.x < box.low.x) {
    winding.number += (At(first).y <= p.y ? 1 : 0) - (At(last).y <= p.y ? 1 : 0);
  } else if (node >= leaves_) {
    const Point a = At(first), b = At(first + 1);
    if (OnSegment(a, b, p)) {
      winding = {0, true};
    } else if ((a.y <= p.y) != (b.y <= p.y) && Orientation(a, b, p) * (a.y < b.y ? 1 : -1) > 0) {
      winding.number += a.y < b.y ? 1 : -1;
    }
  } else {
    AddWinding(2 * node, p, winding);
    AddWinding(2 * node + 1, p, winding);
  }
}

bool RingIndex::IsCrossedBy(Point a, Point b) const {
  Box box;
  box.Add(a);
  box.Add(b);
  return IsCrossedBy(1, a, b, box);
}

bool RingIndex::IsCrossedBy(std::size_t node, Point a, Point b, const Box& box) const {
  const Box& mine = boxes_[node];
  if (mine.high.x < box.low.x || box.high.x < mine.low.x || mine.high.y < box.low.y || box.high.y < mine.low.y) {
    return false;
  }
  if (node >= leaves_) return CrossProperly(At(node - leaves_), At(node - leaves_ + 1), a, b);
  return IsCrossedBy(2 * node, a, b, box) || IsCrossedBy(2 * node + 1, a, b, box);
}

}  // namespace tautline
