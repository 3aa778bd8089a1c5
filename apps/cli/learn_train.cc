// `tautline learn train`: a policy that keeps cable, robot and obstacles apart, learned on one scene.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "apps/answers/learn_answer.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/training_folder.h"
#include "apps/cli/training_seeds.h"
#include "apps/pictures/learn_pictures.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

struct LearnTrainCommand {
  CommonOptions common;
  LearnOptions options;
  double robot_radius = 0;  ///< 0: not given.
  double link = 0;          ///< 0: not given.
  std::string observation = "scaled";
  bool no_reference = false;
  std::string kernels = "auto";
  std::string out;
  int seeds = 1;
  std::int64_t checkpoint_every = 10'000;
  bool resume = false;
};

/// The runs, best first one first found: the goal reached, then the largest return.
std::size_t BestOf(const std::vector<std::unique_ptr<TrainingRun>>& runs) {
  const auto worse = [](const auto& a, const auto& b) {
    const EpisodeTotals &x = a->best_evaluation()->totals, &y = b->best_evaluation()->totals;
    return x.success != y.success ? y.success : x.reward < y.reward;
  };
  return static_cast<std::size_t>(std::max_element(runs.begin(), runs.end(), worse) - runs.begin());
}

Json SeedJson(const TrainingRun& run, double dt_s) {
  const EpisodeRecord& best = *run.best_evaluation();
  const auto& tries = run.evaluations();
  Json json;
  json["seed"] = run.options().seed;
  json["success"] = best.totals.success;
  json["return"] = best.totals.reward;
  json["length"] = best.totals.length_m;
  json["cable_robot_per_minute"] = best.totals.PerMinute(best.totals.cable_robot, dt_s);
  json["cable_obstacle_per_minute"] = best.totals.PerMinute(best.totals.cable_obstacle, dt_s);
  json["best_step"] = best.step;
  json["evaluations"] = tries.size();
  json["successes"] = std::count_if(tries.begin(), tries.end(),
                                    [](const EpisodeRecord& evaluation) { return evaluation.totals.success; });
  json["episodes"] = run.episodes().size();
  json["gradient_steps"] = run.gradient_steps();
  return json;
}

std::string ToText(const LearnAnswer& answer, const std::string& out) {
  if (!answer.reference) return fmt::format("No reference path: {}.\n", answer.explanation);
  const Json& json = answer.json;
  std::string text = answer.explanation.empty()
                         ? fmt::format("The policy of seed {} reaches the goal in {} s and {}.\n", json["seed"].dump(),
                                       ShortNumber(json["time"]), Metres(json["length"]))
                         : fmt::format("No policy: {}.\n", answer.explanation);
  text += fmt::format("  the cable touched obstacles {} times a minute, the robot stood on it {} times\n",
                      ShortNumber(json["cable_obstacle_per_minute"]), ShortNumber(json["cable_robot_per_minute"]));
  for (const Json& seed : json["seeds"]) {
    text +=
        fmt::format("  seed {:<5} at the goal {} of {} times; the best {} at step {}, return {}\n", seed["seed"].dump(),
                    seed["successes"].dump(), seed["evaluations"].dump(), seed["success"] ? "reached it" : "did not",
                    seed["best_step"].dump(), ShortNumber(seed["return"]));
  }
  return text + fmt::format("  kept in {}\n", out);
}

/// What tells trainings apart: all but where to write and how many threads.
std::string OptionsText(const Scene& scene, const LearnTrainCommand& command, const Kernels& kernels) {
  Json json;
  json["command"] = "learn train";
  json.update(TaskJson(scene));
  json["seeds"] = command.seeds;
  json["kernels"] = kernels.name;
  json["options"] = ToJson(command.options);
  return json.dump(1) + "\n";
}

/// The best policy, driven; and all that belongs to the run as a whole, written to its folder.
Expected<LearnAnswer> Conclude(const Scene& scene, const LearnSetup& setup, const TrainingSeeds& what,
                               const std::vector<std::unique_ptr<TrainingRun>>& runs, TrainingFolder& folder) {
  const TrainingRun& best = *runs[BestOf(runs)];
  LearnAnswer answer =
      AnswerOf("learn train", setup, RunPolicy(*setup.env, best.best(), *what.kernels, /*keep_frames=*/true));
  answer.json["seed"] = best.options().seed;
  answer.json["kernels"] = what.kernels->name;
  for (const auto& run : runs) answer.json["seeds"].push_back(SeedJson(*run, setup.env->options().dt_s));
  answer.json["options"] = ToJson(what.options);
  LearnOptions options = what.options;
  options.training.seed = best.options().seed;
  std::vector<TrainingFolder::File> files{{"policy.onnx", WriteOnnx(PolicyOf(best, options, *what.kernels))},
                                          {"result.json", answer.json.dump(1) + "\n"},
                                          {"curves.svg", DrawCurves(runs)},
                                          {"visits.svg", DrawVisits(scene, setup, runs)},
                                          {"path.svg", DrawAnswer(scene, answer)}};
  const auto written = folder.Write(files);
  if (!written) return tl::unexpected(written.error());
  return answer;
}

Expected<LearnAnswer> Train(const Scene& scene, const LearnTrainCommand& command, const Kernels& kernels) {
  ProgressBar progress(!command.common.quiet);
  const auto setup = SetUpLearning(scene, command.options.env, progress.watcher());
  if (!setup) return tl::unexpected(setup.error());
  if (!setup->env) return NoReference("learn train", *setup);
  const auto path = TrainingFolder::Open(command.out, OptionsText(scene, command, kernels), command.resume);
  if (!path) return tl::unexpected(path.error());
  TrainingFolder folder(*path);
  const TrainingSeeds what{.env = setup->env.get(),
                           .options = command.options,
                           .kernels = &kernels,
                           .seeds = command.seeds,
                           .threads = command.common.threads,
                           .checkpoint_every = command.checkpoint_every};
  const auto runs = RunTrainings(what, folder, progress);
  if (!runs) return tl::unexpected(runs.error());
  return Conclude(scene, *setup, what, *runs, folder);
}

Expected<int> RunLearnTrain(LearnTrainCommand command) {
  const auto scene = ReadScene(command.common);
  if (!scene) return tl::unexpected(scene.error());
  const Kernels* const kernels = FindKernels(command.kernels);
  if (kernels == nullptr) {
    return InvalidInput("this processor, or this build, has no such kernels; give auto",
                        "--kernels " + command.kernels);
  }
  ResolveBody(*scene, command.robot_radius, command.link, command.options.env);
  command.options.env.observation =
      command.observation == "metres" ? ObservationScale::kMetres : ObservationScale::kScaled;
  command.options.env.reward.use_reference = !command.no_reference;
  command.options.training.seed = command.common.seed;
  if (const auto checked = CheckDqnOptions(command.options.training.dqn); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto answer = Train(*scene, command, *kernels);
  if (!answer) return tl::unexpected(answer.error());
  return Deliver(command.common, {.json = answer->json,
                                  .text = ToText(*answer, command.out),
                                  .draw = [&] { return DrawAnswer(*scene, *answer); },
                                  .animate = [&] { return AnimateAnswer(*scene, *answer); },
                                  .status = answer->status});
}

/// An option for each constant.
struct AddConstant {
  CLI::App& sub;

  template <class Value>
  void operator()(const std::string& name, Value& value, const char* help) const {
    std::string option = "--" + name;
    std::replace(option.begin(), option.end(), '_', '-');
    sub.add_option(option, value, help)->capture_default_str();
  }
};

void AddBodyOptions(CLI::App& sub, LearnTrainCommand& command) {
  VisitEnvOptions(command.options.env, [&](const std::string& name, auto& value, const char* help) {
    if (name == "robot_radius") {
      sub.add_option("--robot-radius", command.robot_radius, help)->check(Positive());
    } else if (name == "link") {
      sub.add_option("--link", command.link, help)->check(Positive());
    } else {
      AddConstant{sub}(name, value, help);
    }
  });
  sub.add_option("--observation", command.observation, "positions and headings in [-1, 1], or as they are")
      ->check(CLI::IsMember({"scaled", "metres"}))
      ->capture_default_str();
  sub.add_flag("--no-reference", command.no_reference, "without the rewards of the reference path");
}

void AddTrainingOptions(CLI::App& sub, LearnTrainCommand& command) {
  TrainingOptions& training = command.options.training;
  VisitDqnOptions(training.dqn, AddConstant{sub});
  sub.add_option("--hidden", training.dqn.hidden, "units of the hidden layers")->capture_default_str();
  sub.add_option("--evaluate-every", training.evaluate_every, "steps between greedy episodes, the best of which counts")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub.add_option("--visit-cell", training.visit_cell_m, "the side of a cell of the map of visits, metres")
      ->check(Positive())
      ->capture_default_str();
  sub.add_option("--kernels", command.kernels, "the loops of the network; auto: the widest that the processor has")
      ->check(CLI::IsMember({"auto", "portable", "avx2", "avx512"}))
      ->capture_default_str();
}

}  // namespace

Run AddLearnTrain(CLI::App& learn) {
  const auto command = std::make_shared<LearnTrainCommand>();
  CLI::App* sub = learn.add_subcommand("train", "a policy for one scene, learned by a deep Q-network");
  AddCommonOptions(*sub, command->common);
  sub->add_option("--out", command->out, "the folder of the training: options, curves, policies, pictures")
      ->required()
      ->type_name("FOLDER")
      ->check(FileName());
  sub->add_option("--seeds", command->seeds, "trainings, from --seed on; the best one counts")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_flag("--resume", command->resume, "go on with the training in the folder, if there is one");
  sub->add_option("--checkpoint-every", command->checkpoint_every, "steps after which the state is kept")
      ->check(AtLeastOne())
      ->capture_default_str();
  AddTrainingOptions(*sub, *command);
  AddBodyOptions(*sub, *command);
  sub->add_option("--animate", command->common.animate, "draw the best policy's drive to this SVG file, which moves")
      ->type_name("FILE")
      ->check(FileName());
  sub->footer(
      "Example:\n  tautline learn train scenes/quiet_room.yaml --steps 60000 --out run\n"
      "Exit status: 0 solved, 2 bad input, 3 no reference path, or no policy reached the goal; 130 interrupted, and\n"
      "--resume goes on.");
  return [command] { return RunLearnTrain(*command); };
}

}  // namespace tautline::cli
