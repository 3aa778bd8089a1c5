#include "apps/answers/show_answer.h"

#include <utility>

namespace tautline {
namespace {

Json MapJson(const MapSource& map) {
  Json json;
  json["path"] = map.path;
  json["kind"] = map.kind;
  if (map.columns > 0) {
    json["columns"] = map.columns;
    json["rows"] = map.rows;
    json["resolution"] = map.resolution;
    json["cells"] = {{"free", map.free_cells}, {"blocked", map.blocked_cells}, {"unknown", map.unknown_cells}};
  }
  json["origin"] = {map.origin.x, map.origin.y};
  if (map.origin_yaw != 0) json["origin_yaw"] = map.origin_yaw;
  json["geographic"] = map.geographic;
  if (map.skipped_features > 0) json["skipped_features"] = map.skipped_features;
  if (map.simplify > 0) json["simplify"] = map.simplify;
  return json;
}

Json ToJson(const Scene& scene, const FreeSpace& space) {
  const JsonValues values(space);
  Json json;
  json["command"] = "show";
  json["status"] = "solved";
  if (scene.world.map) json["map"] = MapJson(*scene.world.map);
  json["box"] = {values.Of(space.box.low), values.Of(space.box.high)};
  json["clearance"] = space.clearance;
  json["snap"] = space.snap;
  json["area"] = FreeArea(space);
  json["components"] = Json::array();
  for (const FreeComponent& component : space.components) {
    json["components"].push_back(
        {{"area", component.area}, {"holes", component.holes.size()}, {"vertices", VertexCount(component)}});
  }
  json["obstacles"] = Json::array();
  for (const Island& island : space.islands) {
    json["obstacles"].push_back({{"name", island.name},
                                 {"members", island.members},
                                 {"area", island.area},
                                 {"representative", values.Of(island.representative)}});
  }
  json["merges"] = Json::array();
  for (const Merge& merge : space.merges) {
    json["merges"].push_back({{"members", merge.members}, {"into", merge.with_wall ? "wall" : merge.members[0]}});
  }
  json["snaps"] = Json::array();
  for (const Snap& snap : space.snaps) {
    json["snaps"].push_back({{"obstacle", snap.obstacle},
                             {"onto", snap.onto},
                             {"from", {snap.from.x, snap.from.y}},
                             {"to", {snap.to.x, snap.to.y}}});
  }
  return json;
}

}  // namespace

Expected<ShowAnswer> AnswerShow(const Scene& scene) {
  auto space = BuildFreeSpace(scene.world);
  if (!space) return tl::unexpected(space.error());
  Json json = ToJson(scene, *space);
  return ShowAnswer{std::move(*space), std::move(json)};
}

std::size_t VertexCount(const FreeComponent& component) {
  std::size_t count = component.outer.points.size();
  for (const BoundaryRing& hole : component.holes) count += hole.points.size();
  return count;
}

double FreeArea(const FreeSpace& space) {
  double area = 0;
  for (const FreeComponent& component : space.components) area += component.area;
  return area;
}

}  // namespace tautline
