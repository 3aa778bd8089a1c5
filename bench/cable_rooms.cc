#include "bench/cable_rooms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/base/rng.h"
#include "tautline/planners/cable_workspace/best.h"

namespace tautline {
namespace {

constexpr double kSide = 200;  // Metres.
constexpr double kApart = 6;   // Metres.
constexpr double kGrowth = 1.02;

void AddObstacle(World& world, Ring ring) {
  Obstacle obstacle;
  obstacle.name = "o" + std::to_string(world.obstacles.size() + 1);
  obstacle.polygon = PolygonWithHoles{std::move(ring), {}};
  world.obstacles.push_back(std::move(obstacle));
}

Ring Star(Rng& rng, Point centre, double radius) {
  constexpr int kCorners = 6;
  Ring ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = (i + rng.Uniform(0, 0.5)) / kCorners * 2 * std::numbers::pi;
    ring.push_back(centre + radius * rng.Uniform(0.5, 1) * Point{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

double ShortestBoundary(const CableGround& ground, const Anchors& anchors) {
  for (double limit = 4 * kSide;; limit *= kGrowth) {
    const BoundaryList list = FindBoundaries(ground, anchors, {.max_boundary = limit});
    TAUTLINE_CHECK(list.complete);
    double shortest = std::numeric_limits<double>::infinity();
    for (const WorkspaceBoundary& boundary : list.boundaries) shortest = std::min(shortest, boundary.length);
    if (!list.boundaries.empty()) return shortest;
  }
}

}  // namespace

CableRoom ThreeObstacleRoom() {
  CableRoom room;
  room.world.outline = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
  AddObstacle(room.world, {{40, 130}, {60, 125}, {75, 145}, {60, 165}, {38, 155}});
  AddObstacle(room.world, {{140, 110}, {170, 120}, {150, 145}});
  AddObstacle(room.world, {{80, 40}, {125, 40}, {125, 75}, {115, 75}, {115, 52}, {90, 52}, {90, 70}, {80, 70}});
  room.anchors = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
  return room;
}

CableRoom RandomCableRoom(const RandomRoomOptions& options) {
  CableRoom room;
  room.world.outline = {{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}};
  Rng rng(options.seed);
  std::vector<std::pair<Point, double>> discs;
  while (discs.size() < options.obstacles) {
    const double radius = rng.Uniform(4, 10), margin = radius + kApart;
    const Point centre{rng.Uniform(margin, kSide - margin), rng.Uniform(margin, kSide - margin)};
    const double to_wall = std::min({centre.x, centre.y, kSide - centre.x, kSide - centre.y});
    if (to_wall > options.band) continue;
    const bool apart = std::all_of(discs.begin(), discs.end(), [&](const std::pair<Point, double>& disc) {
      return Distance(disc.first, centre) > disc.second + margin;
    });
    if (!apart) continue;
    discs.emplace_back(centre, radius);
    AddObstacle(room.world, Star(rng, centre, radius));
  }
  for (std::size_t i = 0; i < options.anchors; ++i) {
    const double along = 4 * static_cast<double>(i) / static_cast<double>(options.anchors);
    const auto wall = static_cast<std::size_t>(along);
    const Ring& outline = room.world.outline;
    room.anchors.push_back(Lerp(outline[wall], outline[(wall + 1) % 4], along - static_cast<double>(wall)));
  }
  return room;
}

PreparedCableRoom::PreparedCableRoom(const CableRoom& room)
    : ground(CableGround::Prepare(room.world).value()),
      anchors(PlaceAnchors(ground, room.anchors).value()),
      shortest(ShortestBoundary(ground, anchors)) {}

}  // namespace tautline
