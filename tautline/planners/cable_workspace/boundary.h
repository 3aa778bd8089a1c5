// The boundary of the workspace of a robot that several cables move [Wang2018, Sec. III].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_H_

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tautline/planners/cable_workspace/cable_ground.h"

namespace tautline {

/// Why there is no workspace, or no answer in it.
enum class WorkspaceObstruction {
  kNone,
  kRobotBlocked,        ///< The robot, as the cables are laid, stands inside an obstacle or its clearance.
  kLaidCableBlocked,    ///< A cable as laid crosses an obstacle.
  kAnchorsUnconnected,  ///< No path leads from an anchor to the next one.
  kNoSuchClass,         ///< No path between two anchors has the word that is asked for.
  kNotClosed,           ///< The words do not multiply to the empty word.
  kCrossesItself,       ///< Two sides of the boundary cross, or one crosses itself.
  kNoArea,              ///< The boundary holds no area.
  kNoBoundary,          ///< No valid boundary is within the limit, or none that holds all tasks.
  kStartOutside,        ///< The start of a motion is not in the workspace.
  kGoalOutside,         ///< Its goal is not.
  kTaskOutside,         ///< A task is not.
  kPoseOutside,         ///< The pose that is asked about is not.
  kAnchorBlocked,       ///< In a future, an obstacle covers an anchor.
  kTooTangled,          ///< In a future, a side winds around obstacles more often than its word can be written.
};

/// The slug of docs/workspace.md: "boundary_crosses_itself", ...; "" for kNone.
std::string ToString(WorkspaceObstruction obstruction);

/// One side of the boundary: the shortest cable from an anchor to the next one in its class.
struct BoundarySide {
  TautPath path;  ///< From exit to exit of the two anchors, without their stubs.
  Walk walk;      ///< Its class.
};

/// A closed, null-homotopic and weakly simple boundary.
struct WorkspaceBoundary {
  std::vector<BoundarySide> sides;  ///< By anchor: from it to the next one. Their words multiply to the empty word.
  Ring ring;                        ///< All sides with the anchors' stubs, from the first anchor on.
  double length = 0;                ///< Of the ring, metres.
  double area = 0;                  ///< Inside, square metres.
};

/// What keeps a boundary from being valid: the sides that are at fault (one, or two that cross), and where.
struct BoundaryFault {
  WorkspaceObstruction obstruction = WorkspaceObstruction::kNone;  ///< What is wrong.
  std::vector<std::size_t> sides;     ///< By the anchors that they start from; of a laid cable its anchor.
  std::optional<Point> at;            ///< Where, if at a place, metres.
  std::string explanation;            ///< One sentence.
  std::vector<TautPath> curves = {};  ///< All sides as far as they are known, for a picture.
};

/// Closes a boundary from one walk per anchor to the next. Valid when the walks multiply to the trivial class, no two
/// sides cross (see CablesCross; weakly simple, that is) and some area is inside, more than the tolerance of the space
/// times the length. `paths`: the sides pulled taut, where
/// they are known already; by default they are pulled here. An anchor in the open has no side on which its curves end:
/// they are refused where their segments cross others, but may cross at a corner that both bend around. O(sides^2)
/// comparisons of walks.
tl::expected<WorkspaceBoundary, BoundaryFault> CloseBoundary(const CableGround& ground, const Anchors& anchors,
                                                             std::vector<Walk> walks, std::vector<TautPath> paths = {});

/// The walks of cables from their anchors to the robot, from `laid`: one polyline per anchor, robot first, anchor last.
/// Faults: kRobotBlocked, kLaidCableBlocked. O(triangles crossed).
tl::expected<std::vector<Walk>, BoundaryFault> FollowCables(const CableGround& ground, const Anchors& anchors,
                                                            std::span<const Polyline> laid);

/// The boundary for laid cables: side i is of the class reverse(cable i) * cable i+1. [Wang2018, Sec. IV-A]
tl::expected<WorkspaceBoundary, BoundaryFault> BoundaryOfCables(const CableGround& ground, const Anchors& anchors,
                                                                std::span<const Polyline> laid);

/// The boundary whose side i has the i-th word. Requires a word per anchor. Faults: kAnchorsUnconnected, kNoSuchClass
/// and those of CloseBoundary.
tl::expected<WorkspaceBoundary, BoundaryFault> BoundaryOfWords(const CableGround& ground, const Anchors& anchors,
                                                               std::span<const Word> words);

/// The islands at which the boundary bends, in the order in which it first meets them; walls have none.
std::vector<ObstacleId> TouchedIslands(const CableGround& ground, const WorkspaceBoundary& boundary);

/// The longest cable that an anchor needs in the workspace: where the robot is at another anchor, or, with clearance,
/// at its exit, since the taut length is convex in the cover. [Wang2018, Sec. IV-C.4]
struct LongestCable {
  double length = 0;         ///< With the anchor's own stub, metres.
  std::size_t farthest = 0;  ///< The anchor at whose exit the robot is then.
  TautPath path;             ///< The cable then, from exit to exit.
};

/// By anchor. O(anchors^2) taut curves.
std::vector<LongestCable> LongestCables(const CableGround& ground, const Anchors& anchors,
                                        const WorkspaceBoundary& boundary);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_H_
