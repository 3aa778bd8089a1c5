#include "tautline/scene/free_space.h"

#include <algorithm>
#include <map>
#include <set>

#include "tautline/geometry/grow.h"
#include "tautline/geometry/overlay.h"
#include "tautline/geometry/snap_rounding.h"
#include "tautline/geometry/snap_vertices.h"
#include "tautline/scene/check_world.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/obstacle_naming.h"

namespace tautline {
namespace {

/// Source numbers: the wall is 0 while snapping, so that obstacles are moved onto it; obstacle k is k + 1.
constexpr std::int32_t kWallSource = 0;

Ring Oriented(const Ring& ring, bool counter_clockwise) {
  Ring oriented = ring;
  if ((SignedArea(ring) > 0) != counter_clockwise) std::reverse(oriented.begin(), oriented.end());
  return oriented;
}

/// Every boundary with blocked ground on its left: the outline clockwise, obstacles counter-clockwise, their holes
/// clockwise.
std::vector<SourcedRing> BlockedRings(const World& world, double arc_error) {
  std::vector<SourcedRing> rings{{Oriented(world.outline, false), kWallSource}};
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    const Obstacle& obstacle = world.obstacles[i];
    const auto source = static_cast<std::int32_t>(i + 1);
    if (obstacle.circle) {
      rings.push_back({CircumscribedPolygon(obstacle.circle->centre, obstacle.circle->radius, arc_error), source});
      continue;
    }
    rings.push_back({Oriented(obstacle.polygon->outer, true), source});
    for (const Ring& hole : obstacle.polygon->holes) rings.push_back({Oriented(hole, false), source});
  }
  return rings;
}

/// Drops the vertices that growth leaves out, or rounding would open slits between a ring and its growth.
void ShareEdgesWithGrowth(std::vector<SourcedRing>& rings) {
  for (SourcedRing& ring : rings) ring.points = DropStraight(ring.points);
}

/// The rings that cover blocked ground inside the outline, with growth.
std::vector<CoverRing> CoverRings(const World& world, const std::vector<SourcedRing>& rings, double growth,
                                  double arc_error) {
  std::vector<CoverRing> cover;
  for (const SourcedRing& ring : rings) {
    const std::int32_t source = ring.source - 1;  // The wall's 0 becomes CoverRing::kWall.
    if (ring.source != kWallSource) cover.push_back({ring.points, source});
    if (growth <= 0) continue;
    const Obstacle* obstacle = source < 0 ? nullptr : &world.obstacles[static_cast<std::size_t>(source)];
    if (obstacle != nullptr && obstacle->circle) {
      const auto [centre, radius] = *obstacle->circle;
      cover.push_back({CircumscribedPolygon(centre, radius + growth, arc_error), source});
      continue;
    }
    for (Ring& piece : GrowthPieces(ring.points, growth, arc_error)) cover.push_back({std::move(piece), source});
  }
  return cover;
}

/// The spacing of the grid that the overlay of the rings will be on, or a coarser one.
double GridSpacing(const std::vector<SourcedRing>& rings, double clearance, double arc_error) {
  Box box;
  for (const SourcedRing& ring : rings) {
    for (const Point p : ring.points) box.Add(p);
  }
  const double reach = (1 + 2 * arc_error) * clearance;
  return SnapGrid({box.low - Point{reach, reach}, box.high + Point{reach, reach}}).spacing();
}

std::string NameOf(const std::vector<std::string>& names, std::int32_t snap_source) {
  return snap_source == kWallSource ? "wall" : names[static_cast<std::size_t>(snap_source - 1)];
}

/// Turns an overlay into components and islands.
class Assembler {
 public:
  Assembler(const World& world, const std::vector<std::string>& names, Overlay overlay, FreeSpace& space)
      : world_(world), names_(names), overlay_(std::move(overlay)), space_(space) {}

  void Assemble() {
    CollectIslands();
    AddSplitPieces();
    CollectComponents();
    MendRepresentatives();
  }

 private:
  void CollectIslands();
  void AddSplitPieces();
  void CollectComponents();
  void MendRepresentatives();

  const World& world_;
  const std::vector<std::string>& names_;  ///< Of the obstacles.
  Overlay overlay_;
  FreeSpace& space_;
  std::vector<ObstacleId> island_of_blocked_;
};

void Assembler::CollectIslands() {
  // Sources come in the order of the scene, so the first of a component names it, and islands and merges keep that
  // order.
  std::map<std::int32_t, std::vector<std::string>> members;
  std::vector<std::int32_t> components;
  island_of_blocked_.assign(static_cast<std::size_t>(overlay_.blocked_count), ObstacleId());
  for (std::size_t source = 0; source < overlay_.blocked_of_source.size(); ++source) {
    const std::int32_t component = overlay_.blocked_of_source[source];
    if (component < 0) continue;
    if (members[component].empty()) {
      components.push_back(component);
      if (component != overlay_.wall) {
        island_of_blocked_[static_cast<std::size_t>(component)] = ObstacleId(space_.islands.size());
        space_.islands.push_back({names_[source], RepresentativeOf(world_.obstacles[source]), {}, 0});
      }
    }
    members[component].push_back(names_[source]);
  }
  for (const std::int32_t component : components) {
    const std::vector<std::string>& names = members[component];
    const bool with_wall = component == overlay_.wall;
    if (with_wall || names.size() > 1) space_.merges.push_back({names, with_wall});
    if (!with_wall) space_.islands[island_of_blocked_[static_cast<std::size_t>(component)].index()].members = names;
  }
}

/// An obstacle whose ground is parted, where it has no width, is several islands: the further ones are called after it.
void Assembler::AddSplitPieces() {
  std::set<std::string> names;
  for (std::size_t i = 0; i < island_of_blocked_.size(); ++i) {
    const std::int32_t source = overlay_.source_of_blocked[i];
    if (island_of_blocked_[i].valid() || static_cast<std::int32_t>(i) == overlay_.wall || source < 0) continue;
    if (names.empty()) names.insert(names_.begin(), names_.end());
    const std::string& parted = names_[static_cast<std::size_t>(source)];
    std::string name;
    for (int k = 2; name.empty() || !names.insert(name).second; ++k) name = parted + "_" + std::to_string(k);
    island_of_blocked_[i] = ObstacleId(space_.islands.size());
    space_.islands.push_back({name, overlay_.inside_of_blocked[i], {parted}, 0});
  }
}

/// A representative that lies in another piece of its obstacle, or that joining has left outside, is replaced.
void Assembler::MendRepresentatives() {
  std::vector<int> windings(space_.islands.size(), 0);
  const auto add = [&](const BoundaryRing& ring) {
    if (!ring.obstacle.valid()) return;
    const Winding winding = WindingNumber(ring.points, space_.islands[ring.obstacle.index()].representative);
    constexpr int kFarOff = 1 << 20;
    windings[ring.obstacle.index()] += winding.on_boundary ? kFarOff : winding.number;
  };
  for (const FreeComponent& component : space_.components) {
    add(component.outer);
    std::for_each(component.holes.begin(), component.holes.end(), add);
  }
  for (std::size_t i = 0; i < island_of_blocked_.size(); ++i) {
    const ObstacleId island = island_of_blocked_[i];
    if (!island.valid() || windings[island.index()] == -1) continue;
    space_.islands[island.index()].representative = overlay_.inside_of_blocked[i];
  }
}

void Assembler::CollectComponents() {
  space_.components.resize(static_cast<std::size_t>(overlay_.free_count));
  for (OverlayRing& ring : overlay_.rings) {
    const double area = ring.area;
    const ObstacleId island = island_of_blocked_[static_cast<std::size_t>(ring.blocked)];
    if (island.valid()) space_.islands[island.index()].area -= area;
    FreeComponent& component = space_.components[static_cast<std::size_t>(ring.free)];
    component.area += area;
    BoundaryRing boundary{std::move(ring.points), island};
    if (area > 0) {
      component.outer = std::move(boundary);
    } else {
      component.holes.push_back(std::move(boundary));
    }
  }
  std::stable_sort(space_.components.begin(), space_.components.end(),
                   [](const FreeComponent& a, const FreeComponent& b) { return a.area > b.area; });
}

bool Holds(const FreeComponent& component, Point p) {
  if (!ContainsPoint(component.outer.points, p)) return false;
  return std::none_of(component.holes.begin(), component.holes.end(), [p](const BoundaryRing& hole) {
    const Winding winding = WindingNumber(hole.points, p);
    return !winding.on_boundary && winding.number != 0;
  });
}

bool Touches(const BoundaryRing& ring, Point p, double tolerance) {
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    if (DistanceToSegment(p, ring.points[i], ring.points[(i + 1) % ring.points.size()]) <= tolerance) return true;
  }
  return false;
}

bool Touches(const FreeComponent& component, Point p, double tolerance) {
  return Touches(component.outer, p, tolerance) ||
         std::any_of(component.holes.begin(), component.holes.end(),
                     [&](const BoundaryRing& hole) { return Touches(hole, p, tolerance); });
}

}  // namespace

Expected<FreeSpace> BuildFreeSpace(const World& world, const FreeSpaceOptions& options) {
  if (const auto checked = CheckWorld(world, options); !checked) return tl::unexpected(checked.error());
  FreeSpace space;
  space.box = BoundingBox(world.outline);
  space.clearance = options.clearance.value_or(world.clearance);
  space.snap = world.snap;
  const std::vector<std::string> names = ObstacleNames(world);
  std::vector<SourcedRing> rings = BlockedRings(world, options.arc_error);
  const double spacing = GridSpacing(rings, space.clearance, options.arc_error);
  if (world.snap > 0) {
    for (const VertexMove& move : SnapVertices(rings, world.snap)) {
      if (Distance(move.from, move.to) <= spacing) continue;
      space.snaps.push_back({NameOf(names, move.source), move.from, move.to, NameOf(names, move.onto)});
    }
  }
  // A few grid spacings more, so that rounding to the grid cannot make the growth too small.
  const double growth = space.clearance > 0 ? space.clearance + 4 * spacing : 0;
  if (growth > 0) ShareEdgesWithGrowth(rings);
  const Ring domain = rings[0].points;
  const std::vector<CoverRing> cover = CoverRings(world, rings, growth, options.arc_error);
  Overlay overlay = ComputeOverlay(domain, cover, static_cast<std::int32_t>(world.obstacles.size()));
  if (overlay.free_count == 0) {
    return InvalidInput("no free ground is left inside the outline: the obstacles" +
                            std::string(space.clearance > 0 ? " and the clearance" : "") +
                            " cover all of it; lower the clearance or check the units",
                        "world");
  }
  space.grid = overlay.grid;
  Assembler(world, names, std::move(overlay), space).Assemble();
  return space;
}

double BoundaryTolerance(const FreeSpace& space) {
  constexpr double kRounding = 1e-6;  // A printed decimal less than what people write.
  // Growth is up to 6 spacings more than the clearance; printed coordinates are rounded by up to 10.
  constexpr double kSpacings = 16;
  return std::max(std::min(space.snap, kRounding), kSpacings * space.grid);
}

Point RepresentativeOf(const Obstacle& obstacle) {
  if (obstacle.representative) return *obstacle.representative;
  return obstacle.circle ? obstacle.circle->centre : InteriorPoint(*obstacle.polygon);
}

std::string BlockedText(const FreeSpace& space) {
  if (space.clearance <= 0) return "inside an obstacle or a wall";
  return "inside an obstacle or a wall, or closer to one than the clearance of " + Metres(space.clearance);
}

std::vector<std::string> NamesOf(const FreeSpace& space) {
  std::vector<std::string> names;
  for (const Island& island : space.islands) names.push_back(island.name);
  return names;
}

std::optional<std::size_t> ComponentOf(const FreeSpace& space, Point p, double tolerance) {
  const auto find = [&](auto holds) -> std::optional<std::size_t> {
    const auto found = std::find_if(space.components.begin(), space.components.end(), holds);
    if (found == space.components.end()) return std::nullopt;
    return static_cast<std::size_t>(found - space.components.begin());
  };
  const auto inside = find([p](const FreeComponent& component) { return Holds(component, p); });
  if (inside || tolerance <= 0) return inside;
  return find([&](const FreeComponent& component) { return Touches(component, p, tolerance); });
}

}  // namespace tautline
