// Free space of worlds that touch, overlap, degenerate and lie far from the origin, against looking at everything.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fuzz/byte_source.h"
#include "fuzz/check_answer.h"
#include "fuzz/lattice_world.h"
#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/scene/brute_free_space.h"
#include "tautline/scene/free_space.h"

namespace tautline::fuzz {
namespace {

/// Every ring of the free space, outer rings first within their components.
std::vector<Ring> RingsOfSpace(const FreeSpace& space) {
  std::vector<Ring> rings;
  for (const FreeComponent& component : space.components) {
    rings.push_back(component.outer.points);
    for (const BoundaryRing& hole : component.holes) rings.push_back(hole.points);
  }
  return rings;
}

/// No two edges cross, and no vertex is straight.
void CheckEdges(const std::vector<Ring>& rings) {
  struct Edge {
    Point from, to;
  };
  std::vector<Edge> edges;
  for (const Ring& ring : rings) {
    TAUTLINE_CHECK(ring.size() >= 3);
    TAUTLINE_CHECK(DropCollinear(ring) == ring);
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
  }
  constexpr std::size_t kMostEdges = 400;  // More only cost time.
  if (edges.size() > kMostEdges) return;
  for (const Edge& a : edges) {
    for (const Edge& b : edges) {
      TAUTLINE_CHECK(!CrossProperly(a.from, a.to, b.from, b.to));
    }
  }
}

void CheckAreas(const World& world, const FreeSpace& space) {
  const double outline = std::fabs(SignedArea(world.outline)), extent = Norm(space.box.size());
  const double rounding = 1e-13 * extent * extent;  // Of SignedArea; of slivers, that is more than their area.
  double sum = 0;
  for (const FreeComponent& component : space.components) {
    double area = SignedArea(component.outer.points);
    TAUTLINE_CHECK(area > -rounding);
    for (const BoundaryRing& hole : component.holes) {
      TAUTLINE_CHECK(hole.obstacle.valid());
      TAUTLINE_CHECK(SignedArea(hole.points) < rounding);
      area += SignedArea(hole.points);
    }
    TAUTLINE_CHECK(std::fabs(area - component.area) <= rounding);
    TAUTLINE_CHECK(component.area > 0);
    sum += component.area;
  }
  TAUTLINE_CHECK(sum <= outline * (1 + 1e-9) + 16 * extent * (space.grid + world.snap));
}

/// Points in free and blocked ground, away from what rounding and joining may move.
void CheckPoints(const World& world, const FreeSpace& space, double arc_error, Lattice& lattice) {
  const double slack = 16 * space.grid + 8 * world.snap;
  const double limit = world.clearance * (1 + arc_error);
  for (int i = 0; i < 48; ++i) {
    const Point p = lattice.At(lattice.bytes().Byte() / 16.0, lattice.bytes().Byte() / 16.0);
    const BlockedDistance distance = DistanceToBlocked(world, p);
    if (std::min(distance.straight, distance.disc) < world.clearance - slack) {
      TAUTLINE_CHECK(FreeCount(space, p) == 0);
    } else if (distance.straight > limit + slack && distance.disc > limit + distance.radius * arc_error + slack) {
      TAUTLINE_CHECK(FreeCount(space, p) == 1);
    }
  }
}

void CheckIslands(const FreeSpace& space) {
  for (const Island& island : space.islands) {
    TAUTLINE_CHECK(!island.members.empty() && island.name.starts_with(island.members[0]));
    TAUTLINE_CHECK(!ComponentOf(space, island.representative));
  }
}

/// A lattice, from millimetres at the edge of the range of coordinates to kilometres.
Lattice AnyLattice(ByteSource& bytes) {
  const double spacing = bytes.Pick({1.0, 1e-3, 1e-2, 0.1, 7.3, 1e3, 1e5});
  const Point origin = bytes.Pick({Point{0, 0}, {9.9e6 - 1e5, -9.8e6}, {1e6 / 3, 1e5 / 7}, {-8.4e6, 8e6 + 1e-3}});
  return {bytes, spacing, origin};
}

void Run(ByteSource bytes) {
  Lattice lattice = AnyLattice(bytes);
  World world = AnyWorld(lattice);
  world.clearance = lattice.spacing() * bytes.Pick({0.0, 0.5, 0.0, 1.0, 0.25, 0.001, 1 / 3.0});
  world.snap = bytes.Pick({1e-6, 0.0, 1e-4 * lattice.spacing(), 0.1 * lattice.spacing()});
  const FreeSpaceOptions options{.arc_error = bytes.Pick({0.01, 0.1, 1.0}), .clearance = {}};
  const auto space = BuildFreeSpace(world, options);
  CheckAnswer(space);
  if (!space) return;
  CheckAreas(world, *space);
  CheckEdges(RingsOfSpace(*space));
  CheckIslands(*space);
  CheckPoints(world, *space, options.arc_error, lattice);
}

}  // namespace
}  // namespace tautline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tautline::fuzz::Run(tautline::fuzz::ByteSource({data, size}));
  return 0;
}
