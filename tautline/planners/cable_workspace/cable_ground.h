// A world prepared for cables, and the winches that stand in it.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_GROUND_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_GROUND_H_

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "tautline/homotopy/socket.h"
#include "tautline/homotopy/taut_ground.h"

namespace tautline {

/// The world that the cables lie in.
using CableGround = TautGround;

/// The control points, in order around the outline. Socket::base is where the cable is tied, Socket::exit where it
/// enters the free space: on the boundary as a rule, where its triangle is the one that all walks from and to this
/// anchor start and end in.
using Anchors = std::vector<Socket>;

/// An anchor that cannot be one.
struct AnchorFault {
  std::size_t anchor = 0;  ///< By position.
  std::string text;        ///< Why, and how to mend it: one sentence without a full stop.
};

/// Places anchors on a ground. Fails where one stands inside an obstacle with no way out, where two stand in one place,
/// and where one stands on a point at which blocked ground touches, so that it has two sides. O(1) expected for each.
tl::expected<Anchors, AnchorFault> PlaceAnchors(const CableGround& ground, std::span<const Point> points);

/// The next anchor around the outline.
inline std::size_t NextAnchor(std::size_t i, std::size_t count) { return i + 1 == count ? 0 : i + 1; }

/// The walk that goes on from the end of one to the end of the other, in the class of both; it turns within the sector
/// where they meet. Requires that the second starts where the first ends, in one sector.
Walk Joined(const FreeMesh& mesh, const Walk& first, const Walk& second);

/// The walk from its end to its start.
Walk Reversed(const Walk& walk);

/// The walk along a taut curve from one anchor's exit to another's, ending in the triangle of the latter.
Walk WalkBetween(const CableGround& ground, const Socket& from, const Socket& to, const TautPath& path);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_GROUND_H_
