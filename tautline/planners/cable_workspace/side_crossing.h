// Whether walks between anchors cross: decided by triangles alone.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// Whether the taut curves of two walks cross, rather than touch or share a part. A crossing is one that no deformation
/// within the two classes removes: the walks share triangles, and at the two ends of what they share they part to
/// opposite sides. The ends of walks must lie on the boundary of the free space: there the cover, a disc, has them in
/// one cyclic order, and two curves cross exactly when their ends alternate. An end in the open crosses nothing. With
/// `a` and `b` the same walk: whether it crosses itself. Exact. O(n) expected for n triangles that are not shared, and
/// O(shared) per shared run.
bool CablesCross(const TautSpace& space, const Walk& a, const Walk& b);

/// Whether a walk that ends in this place ends on the boundary, so that it can be said to cross others. O(1).
bool EndsOnBoundary(const TautSpace& space, const Place& place);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_SIDE_CROSSING_H_
