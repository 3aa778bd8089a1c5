// What touches the cable, and when it began.
#include <algorithm>

#include "tautline/cable/cable.h"

namespace tautline {
void Cable::FindContacts(StepResult& result) {
  const std::size_t before = contacts_.size();
  std::vector<VertexId> held;
  for (const Strand& link : links_) {
    for (const TautPoint& bend : link.bends) {
      held.push_back(bend.vertex);
      if (std::binary_search(held_.begin(), held_.end(), bend.vertex)) continue;
      if (std::find(held.begin(), held.end() - 1, bend.vertex) != held.end() - 1) continue;
      contacts_.push_back({ContactKind::kObstacle, time_s_, bend.point, bend.vertex});
    }
  }
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  held_ = std::move(held);
  FindRobotContact(result);
  result.touches_obstacle = !held_.empty();
  result.new_contacts = contacts_.size() - before;
}

void Cable::FindRobotContact(StepResult& result) {
  const auto under = UnderRobot();
  if (under && !on_cable_) contacts_.push_back({ContactKind::kRobot, time_s_, *under, {}});
  on_cable_ = under.has_value();
  result.touches_robot = on_cable_;
}

/// The cable is tied to the robot's centre, so its end is always under the robot: only what comes back after the cable
/// has left the disc is driven over.
std::optional<Point> Cable::UnderRobot() const {
  const Point robot = nodes_.back().point;
  const double radius = options_.robot_radius_m, reach = radius + options_.link_length_m;
  bool left = false;
  std::optional<Point> nearest;
  const auto look = [&](Point a, Point b) {  // From b, nearer to the robot along the cable, to a.
    const Point near = NearestOnSegment(robot, a, b);
    if (left && Distance(near, robot) <= radius && (!nearest || Distance(near, robot) < Distance(*nearest, robot))) {
      nearest = near;
    }
    if (Distance(a, robot) > radius) left = true;
  };
  const double far = 1.01 * reach;
  for (std::size_t i = links_.size(); i-- > 0;) {
    const Point away = nodes_[i].point - robot;
    if (left && Dot(away, away) > far * far) continue;
    Point from = nodes_[i + 1].point;
    for (std::size_t k = links_[i].bends.size(); k-- > 0; from = links_[i].bends[k].point) {
      look(links_[i].bends[k].point, from);
    }
    look(nodes_[i].point, from);
  }
  return nearest;
}

}  // namespace tautline
