#include "tautline/planners/contact_free/path_lattice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

class LatticeBuilder {
 public:
  LatticeBuilder(const TautSpace& space, double step_m) : space_(space), step_(step_m) {
    const Box& box = space.free_space().box;
    low_ = box.low;
    columns_ = static_cast<int>(std::ceil(box.size().x / step_));
    rows_ = static_cast<int>(std::ceil(box.size().y / step_));
    node_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), PathNodeId());
  }

  JoinedGraph Build(Place from, Place to) {
    AddPoints();
    AddEdges();
    const PathNodeId first = AddEnd(from);
    const PathNodeId last = from.point == to.point ? first : AddEnd(to);
    if (first != last && Distance(from.point, to.point) <= 2 * step_) Join(first, last);
    return {PathGraph(std::move(points_), std::move(edges_)), first, last};
  }

 private:
  PathNodeId& At(int column, int row) {
    return node_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }

  PathNodeId Add(Place place) {
    points_.push_back(place.point);
    places_.push_back(place);
    return PathNodeId(points_.size() - 1);
  }

  void AddPoints() {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (const auto place = space_.Locate(low_ + step_ * Point{column + 0.5, row + 0.5})) {
          At(column, row) = Add(*place);
        }
      }
    }
  }

  void AddEdges() {
    constexpr std::pair<int, int> kForward[] = {{1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        for (const auto& [dx, dy] : kForward) {
          if (column + dx < 0 || column + dx >= columns_ || row + dy >= rows_) continue;
          Join(At(column, row), At(column + dx, row + dy));
        }
      }
    }
  }

  PathNodeId AddEnd(Place place) {
    const PathNodeId end = Add(place);
    const Point cell = (1 / step_) * (place.point - low_);
    const int column = static_cast<int>(std::lround(cell.x)), row = static_cast<int>(std::lround(cell.y));
    for (int y = std::max(0, row - 2); y < std::min(rows_, row + 2); ++y) {
      for (int x = std::max(0, column - 2); x < std::min(columns_, column + 2); ++x) Join(end, At(x, y));
    }
    return end;
  }

  void Join(PathNodeId a, PathNodeId b) {
    if (!a.valid() || !b.valid() || points_[a.index()] == points_[b.index()]) return;
    if (IsFreeSegment(space_, places_[a.index()], points_[b.index()])) edges_.emplace_back(a, b);
  }

  const TautSpace& space_;
  double step_;
  Point low_;
  int columns_ = 0, rows_ = 0;
  std::vector<PathNodeId> node_;  ///< By cell; invalid where it is blocked.
  std::vector<Point> points_;
  std::vector<Place> places_;
  std::vector<PathGraph::Edge> edges_;
};

}  // namespace

bool IsFreeSegment(const TautSpace& space, Place from, Point to) {
  Walk walk(from);
  return !WalkNearly(space.mesh(), to, space.tolerance(), walk);
}

Expected<void> CheckLatticeStep(const TautSpace& space, double step_m) {
  const Point size = space.free_space().box.size();
  if (!(step_m > 0)) return InvalidInput("the step of the lattice must be larger than 0", "step");
  if (std::ceil(size.x / step_m) * std::ceil(size.y / step_m) > static_cast<double>(kMostLatticePoints)) {
    return InvalidInput("a step of " + Metres(step_m) + " gives more than " + std::to_string(kMostLatticePoints) +
                            " lattice points; give a larger one",
                        "step");
  }
  return {};
}

Expected<JoinedGraph> BuildPathLattice(const TautSpace& space, Point from, Point to, double step_m) {
  if (const auto checked = CheckLatticeStep(space, step_m); !checked) return tl::unexpected(checked.error());
  const auto first = space.Locate(from), last = space.Locate(to);
  if (!first || !last) return InvalidInput("an end of the path is not in the free space", "");
  return LatticeBuilder(space, step_m).Build(*first, *last);
}

}  // namespace tautline
