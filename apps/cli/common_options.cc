#include "apps/cli/common_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

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
  command
      .add_option(
          "--threads", options.threads,
          "the most threads to use, for --goals, --field, places and trainings; the answer does not depend on it")
      ->check(AtLeastOne());
  command.add_option("--seed", options.seed, "the seed of everything random");
}

namespace {

/// Whether two paths lead to one file, or would if there were one.
bool SameFile(const std::string& a, const std::string& b) {
  std::error_code none;
  if (std::filesystem::equivalent(a, b, none)) return std::filesystem::is_regular_file(a, none);
  const auto whole = [&none](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
  };
  return !std::filesystem::exists(a, none) && whole(a) == whole(b);
}

/// The files that are to be written, with their options.
std::vector<std::pair<std::string, std::string>> OutputsOf(const CommonOptions& options) {
  std::vector<std::pair<std::string, std::string>> outputs;
  for (const auto& [option, path] : {std::pair{"--svg", options.svg},
                                     {"--png", options.png},
                                     {"--csv", options.csv},
                                     {"--save-prepared", options.save_prepared},
                                     {"--out", options.policy},
                                     {"--animate", options.animate}}) {
    if (!path.empty()) outputs.emplace_back(option, path);
  }
  return outputs;
}

std::optional<Error> TwoOutputsInOne(const CommonOptions& options) {
  const auto outputs = OutputsOf(options);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = i + 1; k < outputs.size(); ++k) {
      if (!SameFile(outputs[i].second, outputs[k].second)) continue;
      return Error{ErrorCode::kInvalidInput,
                   fmt::format("{} and {} name the same file; give each its own", outputs[i].first, outputs[k].first),
                   outputs[i].second};
    }
  }
  return std::nullopt;
}

/// An output that would replace the scene or its map.
std::optional<Error> OutputIsInput(const CommonOptions& options, const std::string& input) {
  for (const auto& [option, output] : OutputsOf(options)) {
    if (input.empty() || !SameFile(output, input)) continue;
    return Error{ErrorCode::kInvalidInput,
                 fmt::format("{} would replace the input {}; name another file", option, input), output};
  }
  return std::nullopt;
}

/// The pictures that are asked for, as temporary files.
Expected<void> AddPictures(const CommonOptions& options, const Answer& answer, OutputFiles& files) {
  if (options.svg.empty() && options.png.empty()) return {};
  const std::string svg = answer.draw();
  if (!options.png.empty()) {
    if (!options.quiet && !HasFont()) {
      std::fputs("tautline: there is no font, so the PNG shows boxes for letters; install fonts-dejavu-core\n", stderr);
    }
    const auto png = RenderPng(svg);
    if (!png) return tl::unexpected(png.error());
    if (auto added = files.Add(options.png, *png); !added) return added;
  }
  return options.svg.empty() ? Expected<void>{} : files.Add(options.svg, svg);
}

}  // namespace

Expected<Scene> ReadScene(const CommonOptions& options, const std::string& other_input) {
  if (const auto error = TwoOutputsInOne(options)) return tl::unexpected(*error);
  for (const std::string& input : {options.scene, options.prepared, other_input}) {
    if (const auto error = OutputIsInput(options, input)) return tl::unexpected(*error);
  }
  auto scene = ReadSceneFile(options.scene, {.unknown_free = options.unknown == "free", .simplify = options.simplify});
  if (scene && scene->world.map) {
    const auto map = std::filesystem::path(options.scene).parent_path() / scene->world.map->path;
    if (const auto error = OutputIsInput(options, map.string())) return tl::unexpected(*error);
  }
  return scene;
}

Expected<void> KeepInput(const CommonOptions& options, const std::string& input) {
  const auto error = OutputIsInput(options, input);
  return error ? tl::unexpected(*error) : Expected<void>{};
}

Expected<int> Deliver(const CommonOptions& options, const Answer& answer) {
  OutputFiles files;
  if (const auto added = AddPictures(options, answer, files); !added) return tl::unexpected(added.error());
  if (!options.csv.empty()) {
    if (const auto added = files.Add(options.csv, answer.csv()); !added) return tl::unexpected(added.error());
  }
  if (!options.save_prepared.empty()) {
    const auto added = files.Add(options.save_prepared, answer.prepared());
    if (!added) return tl::unexpected(added.error());
  }
  if (!options.policy.empty()) {
    if (const auto added = files.Add(options.policy, answer.policy()); !added) return tl::unexpected(added.error());
  }
  if (!options.animate.empty()) {
    if (const auto added = files.Add(options.animate, answer.animate()); !added) return tl::unexpected(added.error());
  }
  const bool quiet = options.quiet && !options.json;
  const std::string text = quiet ? "" : options.json ? answer.json.dump(1) + "\n" : answer.text;
  if (const auto written = WriteStandardOutput(text); !written) return tl::unexpected(written.error());
  if (const auto placed = files.Commit(); !placed) return tl::unexpected(placed.error());
  return answer.status;
}

}  // namespace tautline::cli
