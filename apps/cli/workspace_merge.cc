// `tautline workspace merge`: the shards of `tautline workspace place` joined.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/common_options.h"
#include "apps/cli/kept_jobs.h"
#include "apps/cli/place_output.h"
#include "apps/cli/place_run.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/workspace_commands.h"

namespace tautline::cli {
namespace {

struct MergeCommand {
  CommonOptions common;
  std::vector<std::string> parts;
  bool unfinished = false;
};

Expected<std::vector<std::string>> ReadPartFiles(const MergeCommand& command) {
  std::vector<std::string> texts;
  for (const std::string& path : command.parts) {
    if (auto kept = KeepInput(command.common, path); !kept) return tl::unexpected(kept.error());
    auto text = ReadPartFile(path);
    if (!text) return tl::unexpected(text.error());
    texts.push_back(std::move(*text));
  }
  return texts;
}

Expected<int> RunMerge(const MergeCommand& command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  const auto texts = ReadPartFiles(command);
  if (!texts) return tl::unexpected(texts.error());
  const auto question = ReadPartQuestion(texts->front(), command.parts.front());
  if (!question) return tl::unexpected(question.error());
  ProgressBar progress(!command.common.quiet);
  const auto search = PreparePlaceSearch(*scene, *question, progress.watcher());
  if (!search) return tl::unexpected(search.error());
  std::vector<NamedPart> parts;
  for (std::size_t i = 0; i < texts->size(); ++i) {
    auto jobs = ReadPart(*search, (*texts)[i], command.parts[i]);
    if (!jobs) return tl::unexpected(jobs.error());
    parts.push_back({command.parts[i], std::move(*jobs)});
  }
  auto jobs = JoinParts(*search, std::move(parts), command.unfinished);
  progress.Clear();
  if (!jobs) return tl::unexpected(jobs.error());
  return DeliverPlaces(command.common, *scene, *search, std::move(*jobs));
}

}  // namespace

Run AddWorkspaceMerge(CLI::App& workspace) {
  const auto command = std::make_shared<MergeCommand>();
  CLI::App* sub = workspace.add_subcommand("merge", "joins the shards of `workspace place` to one answer");
  AddCommonOptions(*sub, command->common);
  sub->add_option("parts", command->parts, "the parts: files of --checkpoint, or what --shard --json printed")
      ->required()
      ->type_name("FILE");
  sub->add_flag("--unfinished", command->unfinished, "join what there is, though jobs are missing");
  sub->footer(
      "Example:\n  tautline workspace place scenes/winches.yaml --shard 1/2 --checkpoint part1.json\n"
      "  tautline workspace place scenes/winches.yaml --shard 2/2 --checkpoint part2.json\n"
      "  tautline workspace merge scenes/winches.yaml part1.json part2.json --svg place.svg\n"
      "Exit status: 0 solved, 2 bad input or parts that do not fit, 3 no placement holds all tasks, or none was "
      "found.");
  return [command] { return RunMerge(*command); };
}

}  // namespace tautline::cli
