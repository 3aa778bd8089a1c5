#include "tautline/planners/cable_workspace/cable_ground.h"

#include <string>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/scene/number_text.h"

namespace tautline {

namespace {

/// Where a cable is tied. Corners of the free space are rounded to a grid, so that an anchor at a corner is off it by
/// rounding, perhaps in a triangle that has none of the walls there: it is put where it is meant to be.
std::optional<Socket> FindAnchor(const CableGround& ground, Point p) {
  auto socket = FindSocket(ground.space(), ground.ungrown(), p);
  if (!socket) return std::nullopt;
  const auto place = ground.space().mesh().MoveOntoBoundary(socket->exit.point, ground.space().tolerance());
  if (!place) return socket;
  if (socket->stub_length > 0) return Socket{socket->base, *place, Distance(socket->base, place->point)};
  return Socket{place->point, *place, 0};
}

}  // namespace

tl::expected<Anchors, AnchorFault> PlaceAnchors(const CableGround& ground, std::span<const Point> points) {
  Anchors anchors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto socket = FindAnchor(ground, points[i]);
    if (!socket) {
      return tl::unexpected(AnchorFault{
          i,
          ToText(points[i]) + " stands inside an obstacle or outside: move it onto the boundary of the free ground"});
    }
    if (ground.space().mesh().Sectors(socket->exit).size() > 1) {
      return tl::unexpected(AnchorFault{i, ToText(points[i]) +
                                               " stands where blocked ground touches, so that its cable could leave to "
                                               "either side: move it a little to the side that is meant"});
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (Distance(anchors[k].exit.point, socket->exit.point) > 2 * ground.space().tolerance()) continue;
      return tl::unexpected(AnchorFault{i, ToText(points[i]) + " stands where cables.anchors[" + std::to_string(k + 1) +
                                               "] stands: give each winch a place of its own"});
    }
    anchors.push_back(*socket);
  }
  return anchors;
}

Walk Joined(const FreeMesh& mesh, const Walk& first, const Walk& second) {
  TAUTLINE_CHECK(first.at == second.from);
  Walk walk = first;
  TAUTLINE_CHECK(TurnInto(mesh, second.sleeve.front(), walk));
  for (const TriangleId step : second.sleeve.triangles()) walk.sleeve.Step(step);
  walk.at = second.at;
  walk.rooted = true;
  return walk;
}

Walk Reversed(const Walk& walk) {
  Walk reversed = walk;
  reversed.sleeve = walk.sleeve.Reversed();
  std::swap(reversed.from, reversed.at);
  reversed.rooted = true;
  return reversed;
}

Walk WalkBetween(const CableGround& ground, const Socket& from, const Socket& to, const TautPath& path) {
  Walk start(from.exit);
  start.rooted = true;
  std::optional<Walk> walk = start;
  TAUTLINE_CHECK(!ground.space().Follow(path.points, walk));
  TAUTLINE_CHECK(walk->at == to.exit.point);
  TAUTLINE_CHECK(TurnInto(ground.space().mesh(), to.exit.triangle, *walk));
  return *walk;
}

}  // namespace tautline
