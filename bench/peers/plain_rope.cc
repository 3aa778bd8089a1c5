#include "bench/peers/plain_rope.h"

#include <algorithm>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

bool Holds(const Ring& ring, Point p) {
  bool inside = false;
  for (std::size_t i = 0, k = ring.size() - 1; i < ring.size(); k = i++) {
    const Point a = ring[i], b = ring[k];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

}  // namespace

void PlainRope::Step(Point to, int sweeps) {
  nodes_.back() = to;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t i = nodes_.size() - 1; i-- > 0;) {
      const Point along = nodes_[i] - nodes_[i + 1];
      const double length = Norm(along);
      if (length <= link_m_) continue;
      const Point excess = (1 - link_m_ / length) * along;
      const bool first = i == 0, last = i + 2 == nodes_.size();
      if (!first) nodes_[i] = nodes_[i] - (last ? 1.0 : 0.5) * excess;
      if (!last) nodes_[i + 1] = nodes_[i + 1] + (first ? 1.0 : 0.5) * excess;
    }
    for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) PushOut(nodes_[i]);
  }
}

void PlainRope::PushOut(Point& node) const {
  for (const Ring& ring : obstacles_) {
    if (!Holds(ring, node)) continue;
    Point nearest = ring[0];
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point p = NearestOnSegment(node, ring[i], ring[(i + 1) % ring.size()]);
      if (Distance(p, node) < Distance(nearest, node)) nearest = p;
    }
    node = nearest;
  }
}

std::size_t PlainRope::LinksThroughObstacles() const {
  std::size_t count = 0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    const auto crosses = [&](const Ring& ring) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (CrossProperly(nodes_[i - 1], nodes_[i], ring[k], ring[(k + 1) % ring.size()])) return true;
      }
      return false;
    };
    count += std::any_of(obstacles_.begin(), obstacles_.end(), crosses) ? 1 : 0;
  }
  return count;
}

double PlainRope::WorstStretch() const {
  double worst = 0;
  for (std::size_t i = 1; i < nodes_.size(); ++i) {
    worst = std::max(worst, Distance(nodes_[i - 1], nodes_[i]) / link_m_);
  }
  return worst;
}

}  // namespace tautline
