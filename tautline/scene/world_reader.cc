#include "tautline/scene/world_reader.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tautline/scene/obstacle_naming.h"
#include "tautline/scene/ring_check.h"

namespace tautline {
namespace {

/// A ring that bounds a region: three points or more, with an area, not crossing itself.
Ring ReadRing(const Document& value, const std::string& what, FieldReader& reader) {
  Ring ring = WithoutRepeats(reader.ReadPoints(value, what, 3));
  if (reader.ok()) reader.Check(RingFault(ring), value.position, what);
  return ring;
}

Circle ReadCircle(const Document& value, const std::string& what, FieldReader& reader) {
  if (!value.is(Document::Kind::kList) || value.items.size() != 3) {
    reader.Fail(value.position, what + " must be [x, y, radius], not " + Describe(value));
    return {};
  }
  const Point centre{reader.ReadNumber(value.items[0], what), reader.ReadNumber(value.items[1], what)};
  const Circle circle{centre, reader.ReadNumber(value.items[2], what + " radius")};
  if (reader.ok()) reader.Check(CircleFault(circle), value.position, what);
  return circle;
}

void ReadShape(const Document& value, const std::string& what, FieldReader& reader, Obstacle& obstacle) {
  const Document* polygon = value.Find("polygon");
  const Document* circle = value.Find("circle");
  reader.Check(ShapeCountFault(polygon != nullptr, circle != nullptr), value.position, what);
  if (!reader.ok()) return;
  if (polygon != nullptr) {
    obstacle.polygon = PolygonWithHoles{ReadRing(*polygon, what + ".polygon", reader), {}};
  } else {
    obstacle.circle = ReadCircle(*circle, what + ".circle", reader);
  }
}

Obstacle ReadObstacle(const Document& value, const std::string& what, FieldReader& reader) {
  Obstacle obstacle;
  if (!reader.IsMap(value, what)) return obstacle;
  reader.KnownKeys(value, what, {"name", "polygon", "circle", "representative"});
  if (const Document* name = value.Find("name")) obstacle.name = reader.ReadName(*name, what + ".name");
  ReadShape(value, what, reader, obstacle);
  if (const Document* point = value.Find("representative")) {
    obstacle.representative = reader.ReadPoint(*point, what + ".representative");
    if (reader.ok()) reader.Check(RepresentativeFault(obstacle), point->position, what + ".representative");
  }
  return obstacle;
}

/// Map obstacles keep the names of the map as far as the scene has not taken them.
void NameObstacles(World& world, ObstacleNaming& names) {
  for (Obstacle& obstacle : world.obstacles) {
    if (obstacle.from_map && !obstacle.name.empty()) obstacle.name = names.Variant(obstacle.name);
  }
  std::vector<std::string> all = ObstacleNames(world);
  for (std::size_t i = 0; i < all.size(); ++i) world.obstacles[i].name = std::move(all[i]);
}

void ReadObstacles(const Document& value, FieldReader& reader, ObstacleNaming& names, World& world) {
  const std::string what = "world.obstacles";
  if (!reader.IsList(value, what)) return;
  for (std::size_t i = 0; i < value.items.size() && reader.ok(); ++i) {
    world.obstacles.push_back(ReadObstacle(value.items[i], Element(what, i), reader));
    const std::string& name = world.obstacles.back().name;
    if (!name.empty() && !names.Take(name)) {
      reader.Fail(value.items[i].position, "two obstacles are named " + Quoted(name) + ": rename one");
    }
  }
}

void LoadMap(const Document& value, FieldReader& reader, const MapLoader& load_map, World& world) {
  const std::string name = reader.ReadText(value, "world.map");
  if (!reader.ok()) return;
  if (!load_map) return reader.Fail(value.position, "world.map cannot be opened here", ErrorCode::kUnsupported);
  auto map = load_map(name);
  if (!map) {
    if (map.error().code != ErrorCode::kUnreadable) return reader.Fail(map.error());
    return reader.Fail(value.position, "the map " + ToString(map.error()), ErrorCode::kUnreadable);
  }
  world.outline = std::move(map->outline);
  for (Obstacle& obstacle : map->obstacles) world.obstacles.push_back(std::move(obstacle));
  map->source.path = name;
  world.map = std::move(map->source);
  world.cells = std::move(map->cells);
}

}  // namespace

World ReadWorld(const Document& document, FieldReader& reader, const MapLoader& load_map) {
  World world;
  if (!reader.IsMap(document, "world")) return world;
  reader.KnownKeys(document, "world", {"map", "outline", "obstacles", "clearance", "snap"});
  const Document* map = document.Find("map");
  const Document* outline = document.Find("outline");
  if ((map == nullptr) == (outline == nullptr)) {
    reader.Fail(document.position, "world must have exactly one of 'map' and 'outline'");
  }
  if (const Document* value = document.Find("clearance")) {
    world.clearance = reader.ReadNonNegative(*value, "world.clearance");
  }
  if (const Document* value = document.Find("snap")) world.snap = reader.ReadNonNegative(*value, "world.snap");
  if (outline != nullptr) world.outline = ReadRing(*outline, "world.outline", reader);
  ObstacleNaming names;
  if (const Document* value = document.Find("obstacles")) ReadObstacles(*value, reader, names, world);
  if (map != nullptr) LoadMap(*map, reader, load_map, world);
  if (reader.ok()) NameObstacles(world, names);
  return world;
}

}  // namespace tautline
