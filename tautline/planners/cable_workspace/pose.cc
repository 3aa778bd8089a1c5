#include "tautline/planners/cable_workspace/pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The corner towards which a cable pulls, and the angle of its direction, from 0 to a whole turn.
struct Pull {
  double angle;
  Point towards;
};

/// Whether a comes before b counter-clockwise from the x axis. Exact, unlike the angles.
bool Before(Point robot, Point a, Point b) {
  const auto is_below = [robot](Point p) { return p.y < robot.y || (p.y == robot.y && p.x < robot.x); };
  if (is_below(a) != is_below(b)) return is_below(b);
  return Orientation(robot, a, b) > 0;
}

/// The widest gap, and whether all gaps are less than a half turn, by the corners themselves.
void FindGap(std::vector<Pull> pulls, Point robot, Pose& pose) {
  pose.largest_gap = 2 * std::numbers::pi;
  if (pulls.empty()) return;
  std::sort(pulls.begin(), pulls.end(),
            [robot](const Pull& a, const Pull& b) { return Before(robot, a.towards, b.towards); });
  pose.largest_gap = 0;
  pose.spans = true;
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    const bool last = i + 1 == pulls.size();
    const Pull& next = pulls[last ? 0 : i + 1];
    const double gap = next.angle - pulls[i].angle + (last ? 2 * std::numbers::pi : 0);
    pose.largest_gap = std::max(pose.largest_gap, gap);
    // Angles tell which neighbours are a half turn apart or so; the predicate tells whether it is less.
    const bool wide = gap > std::numbers::pi / 2;
    if (wide && (gap > 1.5 * std::numbers::pi || Orientation(robot, pulls[i].towards, next.towards) <= 0)) {
      pose.spans = false;
    }
  }
}

}  // namespace

Pose LookAtPose(const WorkspaceRegion& region, Point at) {
  Pose pose{.position = region.Classify(at)};
  const auto ways = region.WaysTo(at);
  if (ways.empty()) {
    pose.position = Containment::kOutside;
    return pose;
  }
  const Point robot = ways[0].at;
  std::vector<Pull> pulls;
  for (std::size_t i = 0; i < region.anchors().size(); ++i) {
    PoseCable cable{.path = region.ground().space().Pull(region.CableTo(i, ways[0]))};
    cable.length = cable.path.length + region.anchors()[i].stub_length;
    const Polyline& points = cable.path.points;
    if (points.size() > 1 && points[points.size() - 2] != robot) {
      const Point towards = points[points.size() - 2];
      cable.direction = (1 / Distance(robot, towards)) * (towards - robot);
      const double angle = std::atan2(cable.direction->y, cable.direction->x);
      pulls.push_back({angle < 0 ? angle + 2 * std::numbers::pi : angle, towards});
    }
    pose.cables.push_back(std::move(cable));
  }
  FindGap(std::move(pulls), robot, pose);
  const double margin = std::cos(pose.largest_gap / 2);
  pose.margin = pose.spans ? std::max(margin, 0.0) : std::min(margin, 0.0);
  const double tolerance = region.ground().space().tolerance();
  region.ground().space().mesh().ForEachBoundaryNear(
      Box{{robot.x - tolerance, robot.y - tolerance}, {robot.x + tolerance, robot.y + tolerance}},
      [&](Point a, Point b) {
        pose.touches_obstacle = pose.touches_obstacle || DistanceToSegment(robot, a, b) <= tolerance;
      });
  return pose;
}

}  // namespace tautline
