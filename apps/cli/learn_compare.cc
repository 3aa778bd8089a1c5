// `tautline learn compare`: all ways to a contact-free path on many scenes, beside each other.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "apps/answers/compare_search.h"
#include "apps/answers/compare_tables.h"
#include "apps/cli/common_options.h"
#include "apps/cli/kept_jobs.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/read_driver_network.h"
#include "tautline/draw/draw_comparison.h"
#include "tautline/scene/check_tether.h"

namespace tautline::cli {
namespace {

struct LearnCompareCommand {
  CommonOptions common;  ///< Its scene is the first one.
  std::vector<std::string> more;
  CompareQuestion question;
  std::string general;
  std::string checkpoint;
  std::string kernels = "auto";
};

Expected<void> ReadScenes(LearnCompareCommand& command) {
  std::vector<std::string> paths = {command.common.scene};
  paths.insert(paths.end(), command.more.begin(), command.more.end());
  for (const std::string& path : paths) {
    CommonOptions common = command.common;
    common.scene = path;
    auto scene = ReadScene(common, command.checkpoint);
    if (!scene) return tl::unexpected(scene.error());
    if (auto given = RequireTetherAndGoal(*scene); !given) return given;
    const std::string name = std::filesystem::path(path).stem().string();
    command.question.scenes.push_back({name, GroupOf(name), *std::move(scene)});
  }
  return {};
}

Expected<void> ReadGeneral(LearnCompareCommand& command) {
  if (command.general.empty()) return {};
  if (auto kept = KeepInput(command.common, command.general); !kept) return kept;
  auto network = ReadDriverNetwork(command.general);
  if (!network) return tl::unexpected(network.error());
  command.question.general = *std::move(network);
  return {};
}

/// One panel for each scene: the first seed's paths.
std::string Draw(const CompareSearch& search, const std::vector<ComparedPath>& paths) {
  std::vector<ComparisonPanel> panels;
  for (const ComparedScene& scene : search.question.scenes) {
    ComparisonPanel panel{scene.name, &scene.scene, BuildFreeSpace(scene.scene.world).value(), {}};
    for (const ComparedPath& path : paths) {
      const bool usual = path.reference && path.cable_robot == search.question.learn.env.reward.cable_robot;
      const bool first = path.seed == 0 || path.seed == search.question.learn.training.seed;
      if (path.scene == scene.name && usual && first && path.found) panel.paths.push_back({path.method, path.path});
    }
    panels.push_back(std::move(panel));
  }
  return DrawComparison(fmt::format("Paths of {} scenes", panels.size()), panels);
}

Expected<int> RunLearnCompare(LearnCompareCommand command) {
  command.question.kernels = FindKernels(command.kernels);
  if (command.question.kernels == nullptr) {
    return InvalidInput("this processor, or this build, has no such kernels; give auto",
                        "--kernels " + command.kernels);
  }
  command.question.learn.training.seed = command.common.seed;
  if (auto checked = CheckDqnOptions(command.question.learn.training.dqn); !checked) {
    return tl::unexpected(checked.error());
  }
  if (auto read = ReadScenes(command); !read) return tl::unexpected(read.error());
  if (auto read = ReadGeneral(command); !read) return tl::unexpected(read.error());
  const auto search = PrepareCompare(std::move(command.question));
  if (!search) return tl::unexpected(search.error());
  ProgressBar progress(!command.common.quiet);
  const KeptJobs<CompareDone> jobs{
      .compute = [&](std::size_t job) { return search->Run(job); },
      .read = [&](std::string_view text, const std::string& name) { return ReadComparePart(*search, text, name); },
      .write = [&](const std::vector<CompareDone>& done,
                   bool complete) { return ComparePartJson(*search, done, complete); }};
  auto done = jobs.Run({.jobs = search->jobs.size(),
                        .shard = {},
                        .threads = command.common.threads,
                        .checkpoint = command.checkpoint,
                        .stage = "comparing"},
                       progress);
  progress.Clear();
  if (!done) return tl::unexpected(done.error());
  std::sort(done->begin(), done->end(), [](const CompareDone& a, const CompareDone& b) { return a.job < b.job; });
  std::vector<ComparedPath> paths;
  for (const CompareDone& job : *done) paths.insert(paths.end(), job.paths.begin(), job.paths.end());
  const std::vector<CompareCell> cells = CellsOf(paths);
  Json json{{"command", "learn compare"}, {"status", "solved"}, {"cells", ToJson(cells)}};
  json["jobs"] = ComparePartJson(*search, *std::move(done), true).at("done");
  return Deliver(command.common, {.json = json,
                                  .text = CompareMarkdown(cells, search->question.learn.env.reward.cable_robot),
                                  .draw = [&] { return Draw(*search, paths); }});
}

}  // namespace

Run AddLearnCompare(CLI::App& learn) {
  const auto command = std::make_shared<LearnCompareCommand>();
  CLI::App* sub = learn.add_subcommand("compare", "all ways to a contact-free path on many scenes, as tables");
  AddCommonOptions(*sub, command->common);
  CompareQuestion& question = command->question;
  sub->add_option("more", command->more, "more scenes; those whose names differ in a number are averaged")
      ->type_name("SCENE");
  sub->add_option("--seeds", question.seeds, "trainings for each scene, from --seed on")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--steps", question.learn.training.dqn.steps, "of each training")
      ->check(AtLeastOne())
      ->capture_default_str();
  CLI::Option* penalty =
      sub->add_option("--penalty", question.penalties, "also with these rewards for standing on the cable");
  CLI::Option* groups =
      sub->add_option("--penalty-groups", question.penalty_groups, "for scenes of these names, without their numbers");
  penalty->type_name("REWARD")->needs(groups);
  groups->type_name("NAME")->needs(penalty);
  sub->add_option("--ablation-groups", question.ablation_groups, "also without the reference path, for these scenes")
      ->type_name("NAME");
  sub->add_option("--general", command->general, "a policy for all maps, as `learn imitate` wrote it")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--checkpoint", command->checkpoint, "keep finished jobs in this file, and go on from those")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--kernels", command->kernels, "the loops of the network; auto: the widest that the processor has")
      ->check(CLI::IsMember({"auto", "portable", "avx2", "avx512"}))
      ->capture_default_str();
  sub->footer(
      "Example:\n  tautline learn compare scenes/quiet_room.yaml --steps 20000 --seeds 1 --svg paths.svg\n"
      "Exit status: 0 solved, 2 bad input.");
  return [command] { return RunLearnCompare(*command); };
}

}  // namespace tautline::cli
