#include "apps/cli/common_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>

#include "apps/cli/option_checks.h"
#include "apps/cli/output_file.h"
#include "tautline/draw/png.h"
#include "tautline/scene/scene_file.h"

namespace tautline::cli {

void AddCommonOptions(CLI::App& command, CommonOptions& options) {
  command.add_option("scene", options.scene, "the scene: a YAML or JSON file")->required()->type_name("SCENE");
  command.add_flag("--json", options.json, "print one JSON document and nothing else");
  command.add_option("--svg", options.svg, "draw the answer to this SVG file")->type_name("FILE")->check(FileName());
  command.add_option("--png", options.png, "draw the answer to this PNG file")->type_name("FILE")->check(FileName());
  command.add_flag("--quiet", options.quiet, "print nothing but errors");
  command.add_flag("--verify", options.verify, "check the answer by independent means before printing it");
  command.add_option("--unknown", options.unknown, "what unknown cells of a ROS map are: blocked or free")
      ->check(CLI::IsMember({"blocked", "free"}));
  command.add_option("--simplify", options.simplify, "let boundaries traced from cells grow by up to this, metres")
      ->type_name("METRES")
      ->check(NonNegative());
  command.add_option("--threads", options.threads, "the most threads to use")->check(AtLeastOne());
  command.add_option("--seed", options.seed, "the seed of everything random");
}

Expected<Scene> ReadScene(const CommonOptions& options) {
  if (!options.svg.empty() && options.svg == options.png) {
    return InvalidInput("--svg and --png name the same file; give each its own", options.svg);
  }
  return ReadSceneFile(options.scene, {.unknown_free = options.unknown == "free", .simplify = options.simplify});
}

Expected<int> Deliver(const CommonOptions& options, const Answer& answer) {
  if (!options.svg.empty() || !options.png.empty()) {
    const std::string svg = answer.draw();
    if (!options.png.empty()) {
      if (!options.quiet && !HasFont()) {
        std::fputs("tautline: there is no font, so the PNG shows boxes for letters; install fonts-dejavu-core\n",
                   stderr);
      }
      const auto png = RenderPng(svg);
      if (!png) return tl::unexpected(png.error());
      if (const auto written = WriteFile(options.png, *png); !written) return tl::unexpected(written.error());
    }
    if (!options.svg.empty()) {
      if (const auto written = WriteFile(options.svg, svg); !written) return tl::unexpected(written.error());
    }
  }
  if (options.json) {
    if (const auto written = WriteStandardOutput(answer.json.dump(1) + "\n"); !written) {
      return tl::unexpected(written.error());
    }
  } else if (!options.quiet) {
    if (const auto written = WriteStandardOutput(answer.text); !written) return tl::unexpected(written.error());
  }
  return answer.status;
}

}  // namespace tautline::cli
