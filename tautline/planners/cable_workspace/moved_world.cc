#include "tautline/planners/cable_workspace/moved_world.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "tautline/scene/check_tether.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/obstacle_naming.h"

namespace tautline {
namespace {

/// What is wrong with the start of a path of an obstacle that has been moved by `offset` before, if anything.
std::optional<std::string> StartFault(const World& world, const Obstacle& obstacle, Point start, Point offset) {
  const double tolerance = SamePointTolerance(BoundingBox(world.outline));
  if (obstacle.representative) {
    const Point representative = *obstacle.representative + offset;
    if (Distance(start, representative) <= tolerance) return std::nullopt;
    return "must start where its representative is by then, at " + ToText(representative) + ", not at " + ToText(start);
  }
  if (DistanceToObstacle(obstacle, start - offset) <= tolerance) return std::nullopt;
  return "must start inside of the obstacle, where it is by then, not at " + ToText(start);
}

void Translate(Ring& ring, Point by) {
  for (Point& p : ring) p = p + by;
}

/// Rounding may push a representative out of an obstacle that is very thin. Then the free space chooses another.
void Translate(Obstacle& obstacle, Point representative, Point by) {
  if (obstacle.circle) obstacle.circle->centre = obstacle.circle->centre + by;
  if (obstacle.polygon) {
    Translate(obstacle.polygon->outer, by);
    for (Ring& hole : obstacle.polygon->holes) Translate(hole, by);
  }
  obstacle.representative = representative + by;
  if (!StrictlyInsideObstacle(obstacle, *obstacle.representative)) obstacle.representative.reset();
}

}  // namespace

std::string FutureName(std::size_t future) { return "futures[" + std::to_string(future + 1) + "]"; }

std::string MoveName(std::size_t future, std::size_t move) {
  return FutureName(future) + ".moves[" + std::to_string(move + 1) + "]";
}

bool StrictlyInsideObstacle(const Obstacle& obstacle, Point p) {
  return obstacle.polygon ? StrictlyInside(*obstacle.polygon, p)
                          : Distance(obstacle.circle->centre, p) < obstacle.circle->radius;
}

double DistanceToObstacle(const Obstacle& obstacle, Point p) {
  if (obstacle.circle) return std::max(0.0, Distance(obstacle.circle->centre, p) - obstacle.circle->radius);
  if (StrictlyInside(*obstacle.polygon, p)) return 0;
  double distance = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      distance = std::min(distance, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  };
  look_at(obstacle.polygon->outer);
  std::for_each(obstacle.polygon->holes.begin(), obstacle.polygon->holes.end(), look_at);
  return distance;
}

Expected<MovedWorld> MoveObstacles(const World& world, const Future& moves, std::size_t future) {
  const std::vector<std::string> names = ObstacleNames(world);
  MovedWorld moved{.world = world, .offsets = {}, .representatives = {}, .steps = {}};
  moved.offsets.resize(world.obstacles.size());
  for (const Obstacle& obstacle : world.obstacles) moved.representatives.push_back(RepresentativeOf(obstacle));
  for (std::size_t i = 0; i < moves.moves.size(); ++i) {
    const auto& [name, path] = moves.moves[i];
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      return InvalidInput("there is no obstacle '" + name + "': name one of world.obstacles", MoveName(future, i));
    }
    const auto which = static_cast<std::size_t>(found - names.begin());
    if (path.empty()) return InvalidInput("path has 0 points: it needs 1 or more", MoveName(future, i));
    if (const auto fault = PointsFault(path)) {
      return tl::unexpected<Error>(Error{fault->code, "path" + fault->text, MoveName(future, i)});
    }
    const Point before = moved.offsets[which];
    if (const auto fault = StartFault(world, world.obstacles[which], path[0], before)) {
      return InvalidInput("the path of '" + name + "' " + *fault, MoveName(future, i));
    }
    for (std::size_t k = 1; k < path.size(); ++k) {
      moved.steps.push_back({which, before + (path[k] - path[0]), i});
    }
    if (path.size() > 1) moved.offsets[which] = moved.steps.back().offset;
  }
  for (std::size_t i = 0; i < moved.offsets.size(); ++i) {
    if (moved.offsets[i] != Point{}) {
      Translate(moved.world.obstacles[i], moved.representatives[i], moved.offsets[i]);
    }
  }
  return moved;
}

}  // namespace tautline
