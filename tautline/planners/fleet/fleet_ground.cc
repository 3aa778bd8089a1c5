#include "tautline/planners/fleet/fleet_ground.h"

#include <algorithm>
#include <utility>

#include "tautline/geometry/predicates.h"
#include "tautline/scene/check_fleet.h"
#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"

namespace tautline {

Expected<FleetGround> FleetGround::Prepare(const Scene& scene, const Watcher& watch) {
  if (auto fleet = RequireFleet(scene); !fleet) return tl::unexpected(fleet.error());
  FleetGround ground;
  ground.robots_ = scene.fleet->robots;
  if (!scene.world.outline.empty()) {
    auto space = BuildFreeSpace(scene.world);
    if (!space) return tl::unexpected(space.error());
    try {
      ground.space_ = std::make_unique<const TautSpace>(*std::move(space), watch);
    } catch (const Stopped&) {
      return tl::unexpected(Error{ErrorCode::kStopped, "stopped while the world was prepared", ""});
    }
  }
  for (const FleetRobot& robot : ground.robots_) ground.points_.push_back(robot.start);
  for (const FleetRobot& robot : ground.robots_) ground.points_.push_back(robot.target);
  ground.tolerance_ = SamePointTolerance(BoundingBox(ground.points_));
  if (ground.space_) {
    ground.tolerance_ = std::max(ground.tolerance_, 2 * ground.space_->tolerance());
    for (const Corner& corner : ground.space_->corners().all()) ground.points_.push_back(corner.point);
  }
  std::vector<BoxIndex::Segment> segments;
  for (const Point p : ground.points_) segments.emplace_back(p, p);
  ground.index_ = std::make_unique<const BoxIndex>(segments);
  for (std::size_t k = 0; k < 2 * ground.size(); ++k) {
    const auto corner = ground.CornerNear(ground.points_[k]);
    if (!corner) continue;
    return InvalidInput(NameOf(ground, FleetNodeId(k)) + " is on the corner of an obstacle, at " +
                            ToText(ground.point(*corner)) + ": move it off, since a cable must be able to pass either",
                        scene.path);
  }
  return ground;
}

FleetNodeKind FleetGround::kind(FleetNodeId id) const {
  if (id.index() < robots_.size()) return FleetNodeKind::kStart;
  return id.index() < 2 * robots_.size() ? FleetNodeKind::kTarget : FleetNodeKind::kCorner;
}

RobotId FleetGround::robot_at(FleetNodeId id) const {
  return kind(id) == FleetNodeKind::kCorner ? RobotId() : RobotId(id.index() % robots_.size());
}

CornerId FleetGround::corner_at(FleetNodeId id) const {
  return kind(id) == FleetNodeKind::kCorner ? CornerId(id.index() - 2 * robots_.size()) : CornerId();
}

std::optional<FleetNodeId> FleetGround::NodeAt(Point at) const {
  const Point reach{tolerance_, tolerance_};
  std::optional<FleetNodeId> nearest;
  double least = tolerance_;
  index_->ForEachNear({at - reach, at + reach}, [&](std::size_t k) {
    const FleetNodeId node(k);
    // Robots' nodes come first, so that one beats a corner in the same place.
    const double distance = Distance(points_[k], at);
    if (distance > least || (nearest && distance == least && *nearest <= node)) return;
    nearest = node;
    least = distance;
  });
  return nearest;
}

std::optional<FleetNodeId> FleetGround::CornerNear(Point at) const {
  const Point reach{tolerance_, tolerance_};
  std::optional<FleetNodeId> corner;
  index_->ForEachNear({at - reach, at + reach}, [&](std::size_t k) {
    const FleetNodeId node(k);
    if (kind(node) == FleetNodeKind::kCorner && Distance(points_[k], at) <= tolerance_) corner = node;
  });
  return corner;
}

std::vector<FleetNodeId> FleetGround::NodesBetween(Point a, Point b) const {
  std::vector<FleetNodeId> nodes;
  index_->ForEachAlong(a, b, 0, [&](std::size_t k) {
    const Point p = points_[k];
    if (p != a && p != b && OnSegment(a, b, p)) nodes.emplace_back(k);
  });
  std::sort(nodes.begin(), nodes.end(), [&](FleetNodeId p, FleetNodeId q) {
    const double to_p = Distance(a, point(p)), to_q = Distance(a, point(q));
    return to_p != to_q ? to_p < to_q : p < q;
  });
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

std::string NameOf(const FleetGround& ground, FleetNodeId id) {
  switch (ground.kind(id)) {
    case FleetNodeKind::kStart:
      return "the start of " + ground.robot(ground.robot_at(id)).name;
    case FleetNodeKind::kTarget:
      return "the target of " + ground.robot(ground.robot_at(id)).name;
    case FleetNodeKind::kCorner:
      return "the corner (" + ShortNumber(ground.point(id).x) + ", " + ShortNumber(ground.point(id).y) + ")";
  }
  return "";
}

}  // namespace tautline
