#include "tautline/scene/check_world.h"

#include <algorithm>
#include <optional>
#include <string>

#include "tautline/geometry/grow.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/ring_check.h"

namespace tautline {
namespace {

/// A fault and the name of what has it.
struct Found {
  std::string what;
  Fault fault;
};

std::optional<Found> Named(const std::optional<Fault>& fault, const std::string& what) {
  if (!fault) return std::nullopt;
  return Found{what, *fault};
}

/// "world.obstacles[3] 'tank'".
std::string NameOf(const World& world, std::size_t index) {
  const std::string& name = world.obstacles[index].name;
  return "world.obstacles[" + std::to_string(index + 1) + "]" + (name.empty() ? "" : " '" + name + "'");
}

std::optional<Fault> PartFault(const std::optional<Fault>& fault, const char* part) {
  if (!fault) return std::nullopt;
  return Fault{part + fault->text, fault->code};
}

std::optional<Fault> PolygonFault(const PolygonWithHoles& polygon, bool from_map) {
  const auto check = from_map ? RingPointsFault : RingFault;
  if (auto fault = check(polygon.outer)) return fault;
  for (const Ring& hole : polygon.holes) {
    if (const auto fault = check(hole)) return PartFault(fault, " hole");
  }
  return from_map ? std::nullopt : HolesFault(polygon);
}

std::optional<Fault> ObstacleFault(const Obstacle& obstacle) {
  if (auto fault = ShapeCountFault(obstacle.polygon.has_value(), obstacle.circle.has_value())) return fault;
  if (obstacle.polygon) {
    if (auto fault = PolygonFault(*obstacle.polygon, obstacle.from_map)) return PartFault(fault, ".polygon");
  } else if (auto fault = CircleFault(*obstacle.circle)) {
    return PartFault(fault, ".circle");
  }
  return PartFault(RepresentativeFault(obstacle), ".representative");
}

std::optional<Fault> ArcErrorFault(double arc_error) {
  if (arc_error >= kSmallestArcError && arc_error <= 1) return std::nullopt;
  return Fault{" must lie between " + FormatNumber(kSmallestArcError) + " and 1, a share of the radius"};
}

/// The number of points before growth, and what growth adds.
struct PointCount {
  std::size_t points = 0;
  std::size_t grown = 0;
};

PointCount CountPoints(const World& world, const FreeSpaceOptions& options) {
  const auto sides = static_cast<std::size_t>(CircleSides(options.arc_error));
  // A corner grows a rectangle and a fan of a quarter turn or so.
  const std::size_t per_corner = 6 + sides / 4;
  PointCount count;
  const auto add = [&](const Ring& ring) {
    count.points += ring.size();
    count.grown += ring.size() * per_corner;
  };
  add(world.outline);
  for (const Obstacle& obstacle : world.obstacles) {
    if (obstacle.circle) {
      count.points += sides;
      count.grown += sides;
    }
    if (!obstacle.polygon) continue;
    add(obstacle.polygon->outer);
    std::for_each(obstacle.polygon->holes.begin(), obstacle.polygon->holes.end(), add);
  }
  return count;
}

std::optional<Found> SizeFault(const World& world, const FreeSpaceOptions& options) {
  const PointCount count = CountPoints(world, options);
  const auto too_many = [](std::size_t found, const std::string& which, std::size_t limit) {
    return Found{"world", Fault{" has " + std::to_string(found) + " " + which + ", more than " + std::to_string(limit) +
                                    ": simplify it (maps: --simplify METRES), or raise arc_error if you set it",
                                ErrorCode::kLimitExceeded}};
  };
  if (count.points > kMaxWorldPoints) return too_many(count.points, "corners", kMaxWorldPoints);
  const bool grows = options.clearance.value_or(world.clearance) > 0;
  if (grows && count.grown > kMaxGrownPoints) {
    return too_many(count.grown, "corners with its clearance", kMaxGrownPoints);
  }
  return std::nullopt;
}

std::optional<Found> FindFault(const World& world, const FreeSpaceOptions& options) {
  if (auto found = Named(NonNegativeFault(world.clearance), "world.clearance")) return found;
  if (options.clearance) {
    if (auto found = Named(NonNegativeFault(*options.clearance), "clearance")) return found;
  }
  if (auto found = Named(NonNegativeFault(world.snap), "world.snap")) return found;
  if (auto found = Named(ArcErrorFault(options.arc_error), "arc_error")) return found;
  if (auto found = SizeFault(world, options)) return found;
  if (auto found = Named(RingFault(world.outline), "world.outline")) return found;
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (const auto fault = ObstacleFault(world.obstacles[i])) return Named(fault, NameOf(world, i));
  }
  return std::nullopt;
}

}  // namespace

Expected<void> CheckWorld(const World& world, const FreeSpaceOptions& options) {
  if (world.outline.empty()) {
    return InvalidInput("the scene has no world; add `world: {outline: [[x, y], ...]}` or `world: {map: FILE}`",
                        "world");
  }
  const auto found = FindFault(world, options);
  if (!found) return {};
  return tl::unexpected<Error>(Error{found->fault.code, found->what + found->fault.text, ""});
}

}  // namespace tautline
