#include "tautline/scene/free_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"
#include "tautline/geometry/snap_rounding.h"

namespace tautline {
namespace {

World RandomWorld(Rng& rng, const Box& box) {
  World world;
  world.outline = RandomOutline(rng, box);
  world.snap = 0;
  for (PolygonWithHoles& polygon : RandomPolygons(rng, box)) {
    Obstacle obstacle;
    obstacle.name = "o" + std::to_string(world.obstacles.size() + 1);
    if (rng.UniformInt(0, 4) == 0) {
      obstacle.circle = Circle{RandomPoint(rng, box), box.size().x * rng.Uniform(0.01, 0.2)};
    } else {
      obstacle.polygon = std::move(polygon);
    }
    world.obstacles.push_back(std::move(obstacle));
  }
  return world;
}

std::vector<Ring> PolygonRings(const World& world) {
  std::vector<Ring> rings{world.outline};
  for (const Obstacle& obstacle : world.obstacles) {
    if (!obstacle.polygon) continue;
    rings.push_back(obstacle.polygon->outer);
    rings.insert(rings.end(), obstacle.polygon->holes.begin(), obstacle.polygon->holes.end());
  }
  return rings;
}

bool InBlockedPolygon(const World& world, Point p) {
  if (!ContainsPoint(world.outline, p)) return true;
  return std::any_of(world.obstacles.begin(), world.obstacles.end(), [p](const Obstacle& obstacle) {
    if (!obstacle.polygon || !ContainsPoint(obstacle.polygon->outer, p)) return false;
    return std::none_of(obstacle.polygon->holes.begin(), obstacle.polygon->holes.end(), [p](const Ring& hole) {
      const Winding winding = WindingNumber(hole, p);
      return !winding.on_boundary && winding.number != 0;
    });
  });
}

/// The distance from p to what a world blocks before growth, by looking at everything: to its straight parts and to
/// its discs, of which the greatest radius is at `radius`.
struct BlockedDistance {
  double straight = 1e300;
  double disc = 1e300;  ///< Negative inside.
  double radius = 0;    ///< Of the nearest disc.
};

BlockedDistance DistanceToBlocked(const World& world, Point p) {
  BlockedDistance distance;
  for (const Ring& ring : PolygonRings(world)) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      distance.straight = std::min(distance.straight, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  }
  if (InBlockedPolygon(world, p)) distance.straight = -distance.straight;
  for (const Obstacle& obstacle : world.obstacles) {
    if (!obstacle.circle) continue;
    distance.disc = std::min(distance.disc, Distance(p, obstacle.circle->centre) - obstacle.circle->radius);
    distance.radius = std::max(distance.radius, obstacle.circle->radius);
  }
  return distance;
}

int FreeCount(const FreeSpace& space, Point p) {
  int sum = 0;
  for (const FreeComponent& component : space.components) {
    int winding = WindingNumber(component.outer.points, p).number;
    for (const BoundaryRing& hole : component.holes) winding += WindingNumber(hole.points, p).number;
    EXPECT_TRUE(winding == 0 || winding == 1);
    sum += winding;
  }
  return sum;
}

/// Somewhere in the box, or near the boundary of the free space.
Point SamplePoint(Rng& rng, const FreeSpace& space) {
  const int kind = rng.UniformInt(0, 3);
  if (kind == 0 || space.components.empty()) return RandomPoint(rng, space.box);
  const auto pick = [&rng](const auto& list) -> const auto& {
    return list[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(list.size()) - 1))];
  };
  const FreeComponent& component = pick(space.components);
  const bool outer = component.holes.empty() || rng.UniformInt(0, 1) == 0;
  const Ring& ring = outer ? component.outer.points : pick(component.holes).points;
  const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point on = Lerp(ring[i], ring[(i + 1) % ring.size()], kind == 1 ? 0 : rng.Uniform());
  const double angle = rng.Uniform(0, 7);
  return on + std::pow(10, rng.Uniform(-11, 0)) * space.box.size().x * Point{std::cos(angle), std::sin(angle)};
}

TEST(FreeSpace, AgreesWithDistancesOnRandomWorlds) {
  const std::int64_t count = ScaledTestCount(35000);
  std::int64_t solved = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box = RandomBox(rng);
    World world = RandomWorld(rng, box);
    world.clearance = rng.UniformInt(0, 3) == 0 ? 0 : box.size().x * std::pow(10, rng.Uniform(-4, -1));
    const FreeSpaceOptions options{.arc_error = std::pow(10, rng.Uniform(-3, 0)), .clearance = {}};
    const Expected<FreeSpace> space = BuildFreeSpace(world, options);
    if (!space) continue;
    ++solved;
    for (int k = 0; k < 24; ++k) {
      const Point p = SamplePoint(rng, *space);
      const BlockedDistance distance = DistanceToBlocked(world, p);
      const double clearance = world.clearance, slack = 16 * space->grid;
      const double straight_limit = clearance * (1 + options.arc_error);
      const double disc_limit = straight_limit + distance.radius * options.arc_error;
      if (std::min(distance.straight, distance.disc) < clearance - (clearance > 0 ? 0 : slack)) {
        ASSERT_EQ(FreeCount(*space, p), 0) << "too small at " << p.x << " " << p.y;
      } else if (distance.straight > straight_limit + slack && distance.disc > disc_limit + slack) {
        ASSERT_EQ(FreeCount(*space, p), 1) << "too large at " << p.x << " " << p.y;
      }
    }
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(solved, count / 2);
}

}  // namespace
}  // namespace tautline
