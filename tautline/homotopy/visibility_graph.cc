#include "tautline/homotopy/visibility_graph.h"

#include <algorithm>
#include <tuple>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {

namespace {

constexpr std::size_t kCornersPerReport = 256;

}  // namespace

SightList SeeFromAllCorners(const FreeMesh& mesh, const Corners& corners, const Watcher& watch) {
  SightList list;
  list.counts.reserve(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) {
    if (watch && c % kCornersPerReport == 0 &&
        !watch("visibility graph", static_cast<double>(c) / static_cast<double>(corners.size()))) {
      throw Stopped();
    }
    const std::vector<Sighting> seen = SeeFromCorner(mesh, corners, CornerId(c));
    list.sightings.insert(list.sightings.end(), seen.begin(), seen.end());
    list.counts.push_back(static_cast<std::int32_t>(seen.size()));
  }
  return list;
}

VisibilityGraph::VisibilityGraph(const Corners& corners, const SightList& sight) {
  TAUTLINE_CHECK(sight.counts.size() == corners.size());
  edges_.reserve(sight.sightings.size());
  first_.reserve(2 * corners.size() + 1);
  auto sighting = sight.sightings.begin();
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const CornerId from(c);
    first_.emplace_back(edges_.size());
    std::size_t left = 0;
    for (std::int32_t k = 0; k < sight.counts[c]; ++k, ++sighting) {
      edges_.push_back({from,
                        sighting->corner,
                        Distance(corners[from].point, corners[sighting->corner].point),
                        sighting->tail,
                        sighting->head,
                        {},
                        {}});
      if (sighting->tail == Side::kLeft) ++left;
    }
    first_.emplace_back(first_.back().index() + left);
  }
  first_.emplace_back(edges_.size());
  SortStances(corners);
  FindOnward(corners);
}

SightList VisibilityGraph::sight() const {
  SightList list;
  for (std::size_t c = 0; 2 * c < stances(); ++c) {
    const auto begin = static_cast<std::ptrdiff_t>(list.sightings.size());
    for (const TautEdge& edge : OutOf(CornerId(c))) list.sightings.push_back({edge.to, edge.tail, edge.head});
    std::sort(list.sightings.begin() + begin, list.sightings.end());
    list.counts.push_back(static_cast<std::int32_t>(list.sightings.size()) - static_cast<std::int32_t>(begin));
  }
  return list;
}

/// Sorts the edges of each corner by stance and direction, and pairs each edge with its reverse.
void VisibilityGraph::SortStances(const Corners& corners) {
  // Sight is symmetric. A corner's edges are still sorted by the corner that they lead to, so the edges into it, taken
  // in the order of the corners where they begin, are the reverses of its edges in this order.
  std::vector<std::size_t> next(corners.size());
  for (std::size_t c = 0; c < corners.size(); ++c) next[c] = first_[2 * c].index();
  std::vector<std::size_t> reverse;
  reverse.reserve(edges_.size());
  for (const TautEdge& edge : edges_) {
    const std::size_t back = next[edge.to.index()]++;
    TAUTLINE_CHECK(back < edges_.size() && edges_[back].to == edge.from && edges_[back].from == edge.to &&
                   edges_[back].tail == Opposite(edge.head));
    reverse.push_back(back);
  }
  std::vector<std::size_t> order(edges_.size());
  for (std::size_t e = 0; e < order.size(); ++e) order[e] = e;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const auto begin = order.begin() + first_[2 * c].value(), end = order.begin() + first_[2 * c + 2].value();
    std::sort(begin, end, [&](std::size_t i, std::size_t j) {
      const TautEdge &a = edges_[i], &b = edges_[j];
      if (a.tail != b.tail) return a.tail < b.tail;
      const int turn = Orientation(corners[a.from].point, corners[a.to].point, corners[b.to].point);
      if (turn != 0) return (turn > 0) == (a.tail == Side::kLeft);
      return a.to < b.to;
    });
  }
  std::vector<EdgeId> place(edges_.size());
  for (std::size_t e = 0; e < order.size(); ++e) place[order[e]] = EdgeId(e);
  std::vector<TautEdge> sorted;
  sorted.reserve(edges_.size());
  for (const std::size_t e : order) {
    sorted.push_back(edges_[e]);
    sorted.back().reverse = place[reverse[e]];
  }
  edges_ = std::move(sorted);
}

void VisibilityGraph::FindOnward(const Corners& corners) {
  onward_of_reverse_.resize(edges_.size());
  for (std::size_t s = 0; s < stances(); ++s) {
    const EdgeRange out = OutOf(StanceId(s)), in_reversed = OutOf(Opposite(StanceId(s)));
    // As the reverses of the edges that come in turn away from the obstacle, more and more turns are taut.
    EdgeId onward = out.last;
    for (EdgeId e = in_reversed.first; e < in_reversed.last; ++e) {
      TautEdge& in = edges_[edge(e).reverse.index()];
      const Point from = corners[in.from].point, here = corners[in.to].point;
      while (onward > out.first) {
        const EdgeId before(onward.value() - 1);
        if (!IsTautTurn(from, here, in.head, corners[edge(before).to].point)) break;
        onward = before;
      }
      in.onward = onward;
      onward_of_reverse_[e.index()] = onward;
    }
  }
}

EdgeRange VisibilityGraph::Onward(Point from, CornerId corner, Side head, const Corners& corners) const {
  EdgeRange range = OutOf(StanceOf(corner, head));
  const auto begin = edges_.begin() + range.first.value(), end = edges_.begin() + range.last.value();
  const auto onward = std::partition_point(begin, end, [&](const TautEdge& out) {
    return !IsTautTurn(from, corners[corner].point, head, corners[out.to].point);
  });
  range.first = EdgeId(static_cast<std::size_t>(onward - edges_.begin()));
  return range;
}

bool IsTautTurn(Point from, Point corner, Side head, Point to) {
  const int turn = Orientation(from, corner, to);
  return head == Side::kLeft ? turn > 0 : turn < 0;
}

}  // namespace tautline
