#include "apps/answers/learn_answer.h"

#include <utility>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

const char* ReasonOf(const EpisodeTotals& totals) { return totals.hit ? "robot_hits_obstacle" : "goal_not_reached"; }

std::string Explain(const EpisodeTotals& totals) {
  const std::string when = std::to_string(totals.steps) + " steps and " + ShortNumber(totals.length_m) + " m";
  return totals.hit ? "the policy drives the robot into an obstacle, after " + when
                    : "the policy does not bring the robot to the goal within " + when;
}

void AddReference(const JsonValues& values, const ReferencePath& reference, Json& json) {
  Json& item = json["reference"];
  item["path"] = values.Of(reference.path);
  item["length"] = reference.length_m;
  item["word"] = values.Of(reference.word);
  item["tether_word"] = values.Of(reference.tether_word);
  item["tether_length"] = reference.tether_length_m;
}

}  // namespace

LearnAnswer NoReference(const std::string& command, const LearnSetup& setup) {
  LearnAnswer answer;
  answer.explanation = setup.selection.explanation;
  answer.status = kExitInfeasible;
  answer.json["command"] = command;
  const bool gave_up = setup.selection.outcome == ReferenceOutcome::kBudgetExceeded;
  answer.json["status"] = gave_up ? "budget_exceeded" : "infeasible";
  answer.json["reason"] = ToString(setup.selection.outcome);
  answer.json["explanation"] = answer.explanation;
  answer.json["success"] = false;
  return answer;
}

LearnAnswer AnswerOf(const std::string& command, const LearnSetup& setup, PolicyRun run) {
  const JsonValues values(setup.space);
  const double dt_s = setup.env->options().dt_s;
  LearnAnswer answer;
  answer.reference = setup.selection.reference;
  answer.robot_radius_m = setup.env->options().robot_radius_m;
  answer.run = std::move(run);
  const EpisodeTotals& totals = answer.run.totals;
  Json& json = answer.json;
  json["command"] = command;
  json["status"] = totals.success ? "solved" : "budget_exceeded";
  if (!totals.success) {
    answer.status = kExitInfeasible;
    answer.explanation = Explain(totals);
    json["reason"] = ReasonOf(totals);
    json["explanation"] = answer.explanation;
  }
  json["success"] = totals.success;
  json["path"] = values.Of(answer.run.Path());
  json["length"] = totals.length_m;
  json["time"] = totals.steps * dt_s;
  json["return"] = totals.reward;
  json["cable_robot_per_minute"] = totals.PerMinute(totals.cable_robot, dt_s);
  json["cable_obstacle_per_minute"] = totals.PerMinute(totals.cable_obstacle, dt_s);
  json["cable_robot_steps"] = totals.cable_robot;
  json["cable_obstacle_steps"] = totals.cable_obstacle;
  if (!answer.run.frames.empty()) {
    json["heading"] = answer.run.frames.back().pose.heading_rad;
    json["cable"] = values.Of(answer.run.frames.back().cable);
  }
  AddReference(values, *setup.selection.reference, json);
  return answer;
}

Expected<LearnAnswer> AnswerLearnEvaluate(const Scene& scene, const EvaluateQuestion& question) {
  const auto model = ReadOnnx(question.policy, question.name);
  if (!model) return tl::unexpected(model.error());
  if (model->network.inputs() != static_cast<int>(Observation().size()) || model->network.outputs() != kTetherActions) {
    return InvalidInput("is a network, but no policy for three actions", question.name);
  }
  const auto text = model->metadata.find("options");
  const auto env = EnvOptionsFrom(text == model->metadata.end() ? "{}" : text->second, question.name);
  if (!env) return tl::unexpected(env.error());
  const auto setup = SetUpLearning(scene, *env, question.watch);
  if (!setup) return tl::unexpected(setup.error());
  if (!setup->env) return NoReference("learn evaluate", *setup);
  return AnswerOf("learn evaluate", *setup, RunPolicy(*setup->env, model->network, *question.kernels, true));
}

OnnxModel PolicyOf(const TrainingRun& run, const LearnOptions& options, const Kernels& kernels) {
  OnnxModel model{.network = run.best(), .metadata = {}};
  model.metadata["options"] = ToJson(options).dump();
  model.metadata["kernels"] = kernels.name;
  model.metadata["actions"] = "turn right, go straight, turn left";
  const EpisodeRecord* const best = run.best_evaluation();
  model.metadata["step"] = std::to_string(best == nullptr ? 0 : best->step);
  return model;
}

std::string EpisodesCsv(const std::vector<EpisodeRecord>& episodes) {
  std::string csv = "step,return,success,steps,length,cable_robot,cable_obstacle,loss\n";
  for (const EpisodeRecord& episode : episodes) {
    const EpisodeTotals& totals = episode.totals;
    csv += std::to_string(episode.step) + "," + ShortNumber(totals.reward) + "," + (totals.success ? "1" : "0") + "," +
           std::to_string(totals.steps) + "," + ShortNumber(totals.length_m) + "," +
           std::to_string(totals.cable_robot) + "," + std::to_string(totals.cable_obstacle) + "," +
           ShortNumber(episode.loss) + "\n";
  }
  return csv;
}

std::string VisitsCsv(const VisitMap& visits) {
  std::string csv = "x,y,visits\n";
  for (int row = 0; row < visits.rows(); ++row) {
    for (int column = 0; column < visits.columns(); ++column) {
      const auto index =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(visits.columns()) + static_cast<std::size_t>(column);
      const std::int64_t count = visits.counts()[index];
      if (count == 0) continue;
      csv += ShortNumber(visits.low().x + (column + 0.5) * visits.cell_m()) + "," +
             ShortNumber(visits.low().y + (row + 0.5) * visits.cell_m()) + "," + std::to_string(count) + "\n";
    }
  }
  return csv;
}

}  // namespace tautline
