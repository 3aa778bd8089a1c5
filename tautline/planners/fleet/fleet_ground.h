// Where a fleet stands: the free space, and the points that its cables can end at or bend around.
#ifndef TAUTLINE_PLANNERS_FLEET_FLEET_GROUND_H_
#define TAUTLINE_PLANNERS_FLEET_FLEET_GROUND_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/base/index.h"
#include "tautline/base/stop.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A robot of a fleet, by its position in the scene.
using RobotId = Index<struct RobotTag>;

/// A point that cables end at or bend around.
using FleetNodeId = Index<struct FleetNodeTag>;

/// What a node is.
enum class FleetNodeKind {
  kStart,   ///< Where a robot starts and is tied.
  kTarget,  ///< Where a robot shall end.
  kCorner,  ///< A corner of the free space.
};

/// A fleet and its world, prepared. Immutable; queries may run in several threads.
class FleetGround {
 public:
  /// Errors: those of RequireFleet and, where there is a world, of BuildFreeSpace; a start or target is, up
  /// to rounding, at a corner of the free space; kStopped when `watch` said stop.
  /// Cost: as TautSpace; without a world O(n log n) for n robots.
  [[nodiscard]] static Expected<FleetGround> Prepare(const Scene& scene, const Watcher& watch = {});

  /// The robots, by RobotId.
  const std::vector<FleetRobot>& robots() const { return robots_; }
  /// A robot.
  const FleetRobot& robot(RobotId id) const { return robots_[id.index()]; }
  /// How many robots.
  std::size_t size() const { return robots_.size(); }

  /// The free space; null for a fleet alone in the plane.
  const TautSpace* space() const { return space_.get(); }

  /// All nodes: the starts in the order of the robots, then the targets, then the corners by CornerId.
  std::size_t node_count() const { return points_.size(); }
  /// Where a node is.
  Point point(FleetNodeId id) const { return points_[id.index()]; }
  /// What a node is.
  FleetNodeKind kind(FleetNodeId id) const;
  /// The robot that starts or ends at a node; invalid for a corner.
  RobotId robot_at(FleetNodeId id) const;
  /// The corner at a node; invalid for a robot's.
  CornerId corner_at(FleetNodeId id) const;
  /// Where a robot starts.
  FleetNodeId start(RobotId id) const { return FleetNodeId(id.index()); }
  /// Where a robot shall end.
  FleetNodeId target(RobotId id) const { return FleetNodeId(robots_.size() + id.index()); }
  /// A corner as a node.
  FleetNodeId corner(CornerId id) const { return FleetNodeId(2 * robots_.size() + id.index()); }

  /// The node at a place, up to the rounding of printed coordinates; robots' before corners. O(1) expected.
  std::optional<FleetNodeId> NodeAt(Point at) const;

  /// The nodes strictly between two points on the straight segment that joins them, exactly, in order from a to b. O(1)
  /// expected for each.
  std::vector<FleetNodeId> NodesBetween(Point a, Point b) const;

  /// Calls visit(node) for every node in a box, and for others near it; perhaps several times.
  template <class Visit>
  void ForEachNodeNear(const Box& box, Visit visit) const {
    index_->ForEachNear(box, [&](std::size_t k) { visit(FleetNodeId(k)); });
  }

 private:
  FleetGround() = default;

  /// A corner that is one place with the point, up to rounding.
  std::optional<FleetNodeId> CornerNear(Point at) const;

  std::vector<FleetRobot> robots_;
  std::unique_ptr<const TautSpace> space_;
  std::vector<Point> points_;
  std::unique_ptr<const BoxIndex> index_;
  double tolerance_ = 0;
};

/// "the start of r1", "the target of r1" or "the corner (3, 4)".
std::string NameOf(const FleetGround& ground, FleetNodeId id);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_FLEET_GROUND_H_
