#include "tautline/homotopy/visibility_graph.h"

#include <algorithm>
#include <tuple>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {

VisibilityGraph::VisibilityGraph(const FreeMesh& mesh, const Corners& corners) : first_{0} {
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const CornerId from(c);
    for (const Sighting& sighting : SeeFromCorner(mesh, corners, from)) {
      edges_.push_back({from, sighting.corner, Distance(corners[from].point, corners[sighting.corner].point),
                        sighting.tail, sighting.head});
    }
    first_.push_back(edges_.size());
  }
  reverse_.reserve(edges_.size());
  for (const TautEdge& edge : edges_) {
    // Sight is symmetric; seen from the other end, left and right change places. Sightings are sorted by corner, tail.
    const auto out = OutOf(edge.to);
    const auto found =
        std::lower_bound(out.begin(), out.end(), std::tuple(edge.from, Opposite(edge.head)),
                         [](const TautEdge& e, const auto& key) { return std::tie(e.to, e.tail) < key; });
    TAUTLINE_CHECK(found != out.end() && found->to == edge.from && found->tail == Opposite(edge.head));
    reverse_.emplace_back(static_cast<std::size_t>(&*found - edges_.data()));
  }
}

bool IsTautTurn(Point from, Point corner, Side head, Point to) {
  const int turn = Orientation(from, corner, to);
  return head == Side::kLeft ? turn > 0 : turn < 0;
}

}  // namespace tautline
