#include "tautline/geometry/simplify.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <unordered_map>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Vertices of all rings, in one array; each knows its neighbours along its ring.
struct Node {
  Point point;
  std::size_t previous = 0;
  std::size_t next = 0;
  std::size_t original_next = 0;
  std::size_t version = 0;  ///< Raised whenever a neighbour changes, so that old candidates are recognised.
  bool dropped = false;
};

struct Candidate {
  double area = 0;
  std::size_t node = 0;
  std::size_t version = 0;

  /// For a queue that serves the smallest area first, then the lowest index.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.area != b.area ? a.area > b.area : a.node > b.node;
  }
};

/// Buckets of vertices by square cells.
class VertexGrid {
 public:
  explicit VertexGrid(double cell_m) : cell_m_(cell_m) {}

  void Add(Point p, std::size_t node) { buckets_[KeyOf(CellOf(p.x), CellOf(p.y))].push_back(node); }

  void Remove(Point p, std::size_t node) {
    auto& bucket = buckets_[KeyOf(CellOf(p.x), CellOf(p.y))];
    bucket.erase(std::find(bucket.begin(), bucket.end(), node));
  }

  /// Calls visit(node) for all vertices in the cells that the box meets, and perhaps for others, until it returns
  /// false.
  template <class Visit>
  void ForEachNear(const Box& box, Visit visit) const {
    const std::int64_t left = CellOf(box.low.x), right = CellOf(box.high.x);
    const std::int64_t bottom = CellOf(box.low.y), top = CellOf(box.high.y);
    const double cells = static_cast<double>(right - left + 1) * static_cast<double>(top - bottom + 1);
    if (cells > static_cast<double>(buckets_.size())) {
      for (const auto& [key, bucket] : buckets_) {
        if (!VisitAll(bucket, visit)) return;
      }
      return;
    }
    for (std::int64_t x = left; x <= right; ++x) {
      for (std::int64_t y = bottom; y <= top; ++y) {
        const auto bucket = buckets_.find(KeyOf(x, y));
        if (bucket != buckets_.end() && !VisitAll(bucket->second, visit)) return;
      }
    }
  }

 private:
  template <class Visit>
  static bool VisitAll(const std::vector<std::size_t>& bucket, Visit visit) {
    return std::all_of(bucket.begin(), bucket.end(), visit);
  }

  std::int64_t CellOf(double coordinate) const { return static_cast<std::int64_t>(std::floor(coordinate / cell_m_)); }
  static std::size_t KeyOf(std::int64_t x, std::int64_t y) {
    return static_cast<std::size_t>(x) * 0x9e3779b97f4a7c15ULL + static_cast<std::size_t>(y);
  }

  double cell_m_;
  std::unordered_map<std::size_t, std::vector<std::size_t>> buckets_;
};

bool InClosedBox(const Box& box, Point p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

/// Of a triangle that runs counter-clockwise, or whose corners lie on one line.
bool InClosedTriangle(Point a, Point b, Point c, Point p) {
  return Orientation(a, b, p) >= 0 && Orientation(b, c, p) >= 0 && Orientation(c, a, p) >= 0;
}

/// A cell size at which a bucket holds few vertices.
double BucketSize(std::span<const PolygonWithHoles> polygons) {
  double length = 0;
  std::size_t count = 0;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) length += Distance(ring[i], ring[(i + 1) % ring.size()]);
    count += ring.size();
  };
  for (const PolygonWithHoles& polygon : polygons) {
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return count == 0 ? 1 : 4 * length / static_cast<double>(count);
}

class Simplifier {
 public:
  Simplifier(std::span<const PolygonWithHoles> polygons, double tolerance_m)
      : polygons_(polygons), tolerance_m_(tolerance_m), grid_(BucketSize(polygons)) {
    for (const PolygonWithHoles& polygon : polygons) {
      AddRing(polygon.outer);
      for (const Ring& hole : polygon.holes) AddRing(hole);
    }
  }

  std::vector<PolygonWithHoles> Run() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) Offer(i);
    while (!queue_.empty()) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      const Node& node = nodes_[candidate.node];
      if (!node.dropped && node.version == candidate.version && MayDrop(candidate.node)) Drop(candidate.node);
    }
    return Result();
  }

 private:
  void AddRing(const Ring& ring) {
    const std::size_t first = nodes_.size(), n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      Node node;
      node.point = ring[i];
      node.previous = first + (i + n - 1) % n;
      node.next = node.original_next = first + (i + 1) % n;
      grid_.Add(ring[i], nodes_.size());
      nodes_.push_back(node);
    }
  }

  Point At(std::size_t node) const { return nodes_[node].point; }

  /// Puts a vertex into the queue when the region turns inwards there.
  void Offer(std::size_t i) {
    const Node& node = nodes_[i];
    const Point a = At(node.previous), b = node.point, c = At(node.next);
    if (Orientation(a, b, c) > 0) return;
    queue_.push({std::fabs(Cross(b - a, c - a)), i, node.version});
  }

  bool MayDrop(std::size_t i) const {
    const Node& node = nodes_[i];
    if (nodes_[node.next].next == node.previous) return false;  // A triangle stays.
    return WithinTolerance(node.previous, node.next) && TriangleIsEmpty(i);
  }

  /// Whether all original vertices from `from` to `to` are near the straight edge between them.
  bool WithinTolerance(std::size_t from, std::size_t to) const {
    for (std::size_t i = nodes_[from].original_next; i != to; i = nodes_[i].original_next) {
      if (DistanceToSegment(At(i), At(from), At(to)) > tolerance_m_) return false;
    }
    return true;
  }

  /// Whether no vertex but its own corners lies in the triangle that dropping i adds.
  bool TriangleIsEmpty(std::size_t i) const {
    const std::size_t before = nodes_[i].previous, after = nodes_[i].next;
    const Point a = At(before), b = At(i), c = At(after);
    Box box;
    for (const Point p : {a, b, c}) box.Add(p);
    bool empty = true;
    grid_.ForEachNear(box, [&](std::size_t other) {
      const bool own = other == before || other == i || other == after;
      empty = own || !InClosedBox(box, At(other)) || !InClosedTriangle(a, c, b, At(other));
      return empty;
    });
    return empty;
  }

  void Drop(std::size_t i) {
    Node& node = nodes_[i];
    node.dropped = true;
    grid_.Remove(node.point, i);
    nodes_[node.previous].next = node.next;
    nodes_[node.next].previous = node.previous;
    for (const std::size_t neighbour : {node.previous, node.next}) {
      ++nodes_[neighbour].version;
      Offer(neighbour);
    }
  }

  std::vector<PolygonWithHoles> Result() const {
    std::vector<PolygonWithHoles> result;
    std::size_t next = 0;
    const auto take = [&](std::size_t size) {
      Ring ring;
      for (const std::size_t end = next + size; next < end; ++next) {
        if (!nodes_[next].dropped) ring.push_back(nodes_[next].point);
      }
      return ring;
    };
    for (const PolygonWithHoles& polygon : polygons_) {
      result.push_back({take(polygon.outer.size()), {}});
      for (const Ring& hole : polygon.holes) result.back().holes.push_back(take(hole.size()));
    }
    return result;
  }

  std::span<const PolygonWithHoles> polygons_;
  double tolerance_m_;
  VertexGrid grid_;
  std::vector<Node> nodes_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

std::vector<PolygonWithHoles> SimplifyOutwards(std::span<const PolygonWithHoles> polygons, double tolerance_m) {
  TAUTLINE_CHECK(tolerance_m > 0);
  return Simplifier(polygons, tolerance_m).Run();
}

}  // namespace tautline
