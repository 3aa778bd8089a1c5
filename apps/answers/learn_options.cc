#include "apps/answers/learn_options.h"

namespace tautline {

void ResolveBody(const Scene& scene, double robot_radius_m, double link_length_m, TetherEnvOptions& env) {
  const double unknown = TetherEnvOptions().robot_radius_m;
  env.robot_radius_m = robot_radius_m > 0 ? robot_radius_m : scene.robot.radius.value_or(unknown);
  env.link_length_m = link_length_m > 0 ? link_length_m : 2 * env.robot_radius_m;
}

Json ToJson(const LearnOptions& options) {
  Json json;
  const auto add = [&json](const char* name, const auto& value, const char*) { json[name] = value; };
  VisitEnvOptions(options.env, add);
  json["observation"] = options.env.observation == ObservationScale::kMetres ? "metres" : "scaled";
  json["use_reference"] = options.env.reward.use_reference;
  VisitDqnOptions(options.training.dqn, add);
  json["hidden"] = options.training.dqn.hidden;
  json["evaluate_every"] = options.training.evaluate_every;
  json["visit_cell"] = options.training.visit_cell_m;
  json["seed"] = options.training.seed;
  return json;
}

Expected<TetherEnvOptions> EnvOptionsFrom(const std::string& text, const std::string& name) {
  TetherEnvOptions env;
  try {
    const Json json = Json::parse(text);
    VisitEnvOptions(env, [&json](const char* key, auto& value, const char*) { json.at(key).get_to(value); });
    env.observation =
        json.at("observation").get<std::string>() == "metres" ? ObservationScale::kMetres : ObservationScale::kScaled;
    env.reward.use_reference = json.at("use_reference").get<bool>();
  } catch (const Json::exception& fault) {
    return InvalidInput(std::string("does not say how it was trained: ") + fault.what(), name);
  }
  return env;
}

}  // namespace tautline
