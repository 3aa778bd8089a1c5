// `tautline workspace place`: where to put the winches.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/place_output.h"
#include "apps/cli/place_run.h"
#include "apps/cli/workspace_commands.h"

namespace tautline::cli {
namespace {

struct PlaceCommand {
  CommonOptions common;
  PlaceQuestion question;
  std::string objective = "area";
  std::string shard;
  std::string checkpoint;
};

/// What a shard cannot be asked for.
std::optional<Error> ShardFault(const PlaceCommand& command) {
  const CommonOptions& common = command.common;
  if (!common.svg.empty() || !common.png.empty()) {
    return Error{ErrorCode::kInvalidInput,
                 "a picture shows all jobs, and --shard does a part of them; draw with `tautline workspace merge`",
                 common.svg.empty() ? "--png" : "--svg"};
  }
  if (command.checkpoint.empty() && !common.json) {
    return Error{ErrorCode::kInvalidInput,
                 "nothing would be left of the shard; name a file with --checkpoint, or print the part with --json",
                 "--shard"};
  }
  return std::nullopt;
}

std::string ShardText(const PlaceCommand& command, std::size_t jobs) {
  return fmt::format("Shard {} is done: {}{}.\n", command.shard, Counted(jobs, "job", "jobs"),
                     command.checkpoint.empty() ? "" : " in " + command.checkpoint);
}

Expected<int> RunPlace(const PlaceCommand& command) {
  Shard shard;
  if (!command.shard.empty()) {
    const auto parsed = ParseShard(command.shard);
    if (!parsed) return tl::unexpected(parsed.error());
    if (const auto fault = ShardFault(command)) return tl::unexpected(*fault);
    shard = *parsed;
  }
  const auto scene = ReadScene(command.common, command.checkpoint);
  if (!scene) return tl::unexpected(scene.error());
  PlaceQuestion question = command.question;
  question.objective = command.objective == "cable" ? PlaceObjective::kCable : PlaceObjective::kArea;
  question.seed = command.common.seed;
  ProgressBar progress(!command.common.quiet);
  const auto search = PreparePlaceSearch(*scene, question, progress.watcher());
  if (!search) return tl::unexpected(search.error());
  auto jobs = RunPlaceJobs(
      *search, {.threads = command.common.threads, .shard = shard, .checkpoint = command.checkpoint}, progress);
  progress.Clear();
  if (!jobs) return tl::unexpected(jobs.error());
  if (command.shard.empty()) return DeliverPlaces(command.common, *scene, *search, std::move(*jobs));
  const std::string text = ShardText(command, jobs->size());
  return Deliver(command.common, {.json = PartJson(*search, std::move(*jobs), true), .text = text, .draw = {}});
}

void AddSearchOptions(CLI::App& sub, PlaceCommand& command) {
  PlaceQuestion& question = command.question;
  sub.add_option("--anchors", question.anchors, "how many winches, 3 or more")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub.add_option("--objective", command.objective,
                 "area: the largest (with futures, expected) workspace; cable: the least cable that holds all tasks")
      ->check(CLI::IsMember({"area", "cable"}))
      ->capture_default_str();
  sub.add_option("--max-boundary", question.max_boundary,
                 "the longest boundary; default: that of the scene, or a quarter more than the outline")
      ->type_name("METRES")
      ->check(Positive());
  sub.add_option("--jobs", question.jobs, "independent searches, each from a start of its own")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub.add_option("--evaluations", question.evaluations, "placements that each job looks at, at most")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub.add_option("--budget", question.budget, "steps of the search for boundaries in each evaluation, at most")
      ->check(AtLeastOne())
      ->capture_default_str();
}

}  // namespace

Run AddWorkspacePlace(CLI::App& workspace) {
  const auto command = std::make_shared<PlaceCommand>();
  CLI::App* sub = workspace.add_subcommand("place", "where to put the winches");
  AddCommonOptions(*sub, command->common);
  AddSearchOptions(*sub, *command);
  sub->add_option("--checkpoint", command->checkpoint,
                  "keep finished jobs in this file, and go on from those that it holds")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--shard", command->shard,
                  "do the I-th of N parts of the jobs; `tautline workspace merge` joins the parts")
      ->type_name("I/N");
  sub->footer(
      "Example:\n  tautline workspace place scenes/winches.yaml --anchors 4 --svg place.svg\n"
      "Exit status: 0 solved, 2 bad input, 3 no placement holds all tasks, or none was found.");
  return [command] { return RunPlace(*command); };
}

}  // namespace tautline::cli
