// `tautline show`: what was understood of a scene.
#include <fmt/format.h>

#include <memory>

#include "apps/answers/exit_status.h"
#include "apps/answers/show_answer.h"
#include "apps/cli/commands.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "tautline/draw/draw_show.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Entries of a long list that are printed in full.
constexpr std::size_t kMostLines = 20;

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
  const auto answer = AnswerShow(*scene);
  if (!answer) return tl::unexpected(answer.error());
  const auto draw = [&] { return DrawShow(*scene, answer->space); };
  return Deliver(options,
                 {.json = answer->json, .text = ToText(*scene, answer->space), .draw = draw, .status = kExitSolved});
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
