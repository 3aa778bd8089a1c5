#include "tautline/planners/grid_manifold/find_way.h"

#include <algorithm>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace tautline {
namespace {

std::uint64_t KeyOf(ManifoldVertex v) { return std::uint64_t{v.page} << 6 | static_cast<std::uint64_t>(v.cell); }

ManifoldVertex VertexOf(std::uint64_t key) {
  return {static_cast<std::uint32_t>(key >> 6), static_cast<int>(key & 63)};
}

/// A* over the vertices that it meets: a way through a large manifold meets few of them.
class WaySearch {
 public:
  WaySearch(const OpenGround& open, const Destination& destination) : open_(open), destination_(destination) {}

  std::vector<ManifoldVertex> From(ManifoldVertex start) {
    Offer(KeyOf(start), KeyOf(start), 0);
    const int step = open_.manifold().atlas().connectivity() == Connectivity::kEight ? 1 : 2;
    while (!queue_.empty()) {
      const std::uint64_t key = std::get<3>(queue_.top());
      queue_.pop();
      Label& label = labels_[key];
      if (label.done) continue;
      label.done = true;
      const ManifoldVertex v = VertexOf(key);
      if (destination_.holds(v)) return WayTo(key);
      const LatticeDistance so_far = label.distance;
      for (int d = 0; d < kDirections; d += step) {
        if (const auto to = open_.Step(v, d)) Offer(KeyOf(*to), key, so_far + StepLength(d));
      }
    }
    return {};
  }

 private:
  struct Label {
    LatticeDistance distance = kUnreached;
    std::uint64_t before = 0;
    bool done = false;
  };
  /// Estimate, how much of it is ahead, cell, key: of equally good ones the same however the pages are numbered.
  using Entry = std::tuple<std::int64_t, LatticeDistance, std::int64_t, std::uint64_t>;

  void Offer(std::uint64_t key, std::uint64_t before, LatticeDistance distance) {
    Label& label = labels_[key];
    if (distance >= label.distance) return;
    const LatticeDistance ahead = destination_.remaining(VertexOf(key));
    if (ahead == kUnreached) return;
    label = {distance, before, false};
    const GridCell cell = open_.manifold().CellOf(VertexOf(key));
    queue_.push({std::int64_t{distance} + ahead, ahead, std::int64_t{cell.row} << 32 | cell.column, key});
  }

  std::vector<ManifoldVertex> WayTo(std::uint64_t key) {
    std::vector<ManifoldVertex> way{VertexOf(key)};
    for (; labels_[key].before != key; key = labels_[key].before) way.push_back(VertexOf(labels_[key].before));
    std::reverse(way.begin(), way.end());
    return way;
  }

  const OpenGround& open_;
  const Destination& destination_;
  std::unordered_map<std::uint64_t, Label> labels_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// The way between two cells without walls.
LatticeDistance WithoutWalls(GridCell a, GridCell b, Connectivity connectivity) {
  const int columns = std::abs(a.column - b.column), rows = std::abs(a.row - b.row);
  if (connectivity == Connectivity::kFour) return (columns + rows) * kStraightStep;
  const int diagonal = std::min(columns, rows);
  return diagonal * kDiagonalStep + (std::max(columns, rows) - diagonal) * kStraightStep;
}

}  // namespace

Destination ToVertex(const GridManifold& manifold, ManifoldVertex target) {
  const GridCell cell = manifold.CellOf(target);
  return {.remaining =
              [&manifold, cell](ManifoldVertex v) {
                return WithoutWalls(manifold.CellOf(v), cell, manifold.atlas().connectivity());
              },
          .holds = [target](ManifoldVertex v) { return v == target; }};
}

std::vector<ManifoldVertex> FindWay(const OpenGround& open, ManifoldVertex start, const Destination& destination) {
  return WaySearch(open, destination).From(start);
}

}  // namespace tautline
