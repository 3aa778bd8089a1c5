// `tautline show`: what was understood of a scene.
#include <fmt/format.h>

#include <memory>

#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/exit_status.h"
#include "apps/cli/json_values.h"
#include "tautline/draw/draw_show.h"
#include "tautline/scene/free_space.h"

namespace tautline::cli {
namespace {

/// Entries of a long list that are printed in full.
constexpr std::size_t kMostLines = 20;

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

/// A line for each entry, or the first of them and how many more there are.
template <class Entries, class ToLine>
void AddLines(const Entries& entries, ToLine to_line, std::string& text) {
  for (std::size_t i = 0; i < entries.size() && i < kMostLines; ++i) text += "  " + to_line(entries[i]) + "\n";
  if (entries.size() > kMostLines) {
    text += fmt::format("  ... and {} more (--json lists all)\n", entries.size() - kMostLines);
  }
}

std::string MapText(const MapSource& map) {
  std::string text = fmt::format("map        {} ({})", map.path, map.kind);
  if (map.columns > 0) {
    text += fmt::format(", {} x {} cells of {}: {} free, {} blocked, {} unknown", map.columns, map.rows,
                        Metres(map.resolution), map.free_cells, map.blocked_cells, map.unknown_cells);
  }
  if (map.geographic) text += fmt::format(", (0, 0) is longitude {:.7f}, latitude {:.7f}", map.origin.x, map.origin.y);
  if (map.skipped_features > 0) text += fmt::format(", {} features skipped", map.skipped_features);
  return text + "\n";
}

std::string ToText(const Scene& scene, const FreeSpace& space) {
  const Point size = space.box.size();
  std::string text;
  if (scene.world.map) text += MapText(*scene.world.map);
  text += fmt::format("world      {} x {}, clearance {}, free ground {:.6g} m2\n", Metres(size.x), Metres(size.y),
                      Metres(space.clearance), FreeArea(space));
  text += fmt::format("components {}\n", space.components.size());
  AddLines(
      space.components,
      [](const FreeComponent& component) {
        return fmt::format("{:.6g} m2, {} holes, {} vertices", component.area, component.holes.size(),
                           VertexCount(component));
      },
      text);
  text += fmt::format("obstacles  {}\n", space.islands.size());
  AddLines(
      space.islands,
      [](const Island& island) {
        return fmt::format("{}: {:.6g} m2, ray from ({:.6g}, {:.6g})", island.name, island.area,
                           island.representative.x, island.representative.y);
      },
      text);
  text += fmt::format("merges     {}\n", space.merges.size());
  AddLines(
      space.merges,
      [](const Merge& merge) {
        return fmt::format("{} -> {}", fmt::join(merge.members, " + "), merge.with_wall ? "wall" : merge.members[0]);
      },
      text);
  text += fmt::format("snaps      {}\n", space.snaps.size());
  AddLines(
      space.snaps,
      [](const Snap& snap) {
        return fmt::format("{} at ({:.6g}, {:.6g}) moved {:.3g} m onto {}", snap.obstacle, snap.from.x, snap.from.y,
                           Distance(snap.from, snap.to), snap.onto);
      },
      text);
  return text;
}

Expected<int> RunShow(const CommonOptions& options) {
  const auto scene = ReadScene(options);
  if (!scene) return tl::unexpected(scene.error());
  const auto space = BuildFreeSpace(scene->world);
  if (!space) return tl::unexpected(space.error());
  const Json json = ToJson(*scene, *space);
  const auto draw = [&] { return DrawShow(*scene, *space); };
  return Deliver(options, {.json = json, .text = ToText(*scene, *space), .draw = draw, .status = kExitSolved});
}

}  // namespace

Run AddShow(CLI::App& app) {
  const auto options = std::make_shared<CommonOptions>();
  CLI::App* sub =
      app.add_subcommand("show", "what was understood of a scene: areas, obstacles, merges, snaps, components");
  AddCommonOptions(*sub, *options);
  sub->footer("Example:\n  tautline show scenes/two_ways.yaml --svg scene.svg\nExit status: 0 shown, 2 bad input.");
  return [options] { return RunShow(*options); };
}

}  // namespace tautline::cli
