// The workspace as a place to be in: which points it holds, and the classes in which the robot and its cables get
// there.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_H_

#include <optional>
#include <vector>

#include "tautline/planners/cable_workspace/boundary.h"

namespace tautline {

/// Where a point lies with respect to a workspace.
enum class Containment { kOutside, kBoundary, kInside };

/// A valid boundary with what is inside, which holds no obstacle. Immutable; keeps all that it is made of by reference.
class WorkspaceRegion {
 public:
  /// O(triangles along the boundary).
  WorkspaceRegion(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary);

  /// Points within the tolerance of the space from the boundary are on it. O(n) for n corners of the boundary.
  Containment Classify(Point p) const;

  /// The ways from the first anchor's exit to p that stay in the workspace, up to deformation: none when p is outside
  /// (or on a stub, where no robot can be), one as a rule, and one from each side where the boundary touches itself.
  /// All end in the same triangle, one for each sector where blocked ground touches. O(n + triangles crossed).
  std::vector<Walk> WaysTo(Point p) const;

  /// The cable of an anchor to the end of a way from the first anchor: its class, from the anchor's exit on.
  Walk CableTo(std::size_t anchor, const Walk& way) const;

  /// The walk from one place of the workspace to another, by their ways.
  Walk Between(const Walk& from_way, const Walk& to_way) const;

  /// The ground.
  const CableGround& ground() const { return ground_; }
  /// The anchors.
  const Anchors& anchors() const { return anchors_; }
  /// The boundary.
  const WorkspaceBoundary& boundary() const { return boundary_; }

 private:
  /// How far away, metres, a piece of the boundary may be from which p is reached.
  double ReachOfWays(Point p, Containment position) const;

  /// Whether the boundary goes around the end of a way in the cover. The cables' pulls there turn by less than a half
  /// turn from one anchor to the next, and by a whole turn in all just when it does.
  bool GoesAround(const Walk& way) const;

  std::optional<Walk> WayAlong(std::size_t side, std::size_t segment, Point on_boundary, Point p) const;

  const CableGround& ground_;
  const Anchors& anchors_;
  const WorkspaceBoundary& boundary_;
  std::vector<Walk> to_anchor_;  ///< From the first anchor's exit, along the boundary.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_REGION_H_
