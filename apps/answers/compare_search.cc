#include "apps/answers/compare_search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "apps/answers/learn_setup.h"
#include "tautline/planners/contact_free/driver_policy.h"
#include "tautline/planners/contact_free/homotopic_dijkstra.h"
#include "tautline/planners/contact_free/homotopic_voronoi.h"
#include "tautline/planners/contact_free/plan_contact_free.h"
#include "tautline/planners/contact_free/policy_run.h"
#include "tautline/planners/contact_free/track_path.h"

namespace tautline {
namespace {

bool Has(const std::vector<std::string>& groups, const std::string& group) {
  return std::find(groups.begin(), groups.end(), group) != groups.end();
}

/// The constants for a scene: its own radius where it has one.
TetherEnvOptions EnvFor(const CompareQuestion& question, const Scene& scene) {
  TetherEnvOptions env = question.learn.env;
  ResolveBody(scene, 0, 0, env);
  return env;
}

std::vector<CompareJob> JobsOf(const CompareQuestion& question) {
  std::vector<CompareJob> jobs;
  for (std::size_t scene = 0; scene < question.scenes.size(); ++scene) {
    const std::string& group = question.scenes[scene].group;
    const double usual = question.learn.env.reward.cable_robot;
    jobs.push_back({.scene = scene, .learn = false});
    for (int k = 0; k < question.seeds; ++k) {
      const std::uint64_t seed = question.learn.training.seed + static_cast<std::uint64_t>(k);
      jobs.push_back({.scene = scene, .seed = seed, .cable_robot = usual, .baselines = true});
      if (Has(question.penalty_groups, group)) {
        for (const double other : question.penalties) {
          jobs.push_back({.scene = scene, .seed = seed, .cable_robot = other});
        }
      }
      if (Has(question.ablation_groups, group)) {
        jobs.push_back({.scene = scene, .seed = seed, .cable_robot = usual, .reference = false});
      }
    }
  }
  return jobs;
}

/// The path for files and pictures: whole millimetres, without points that are within kDrawn of what is left.
Polyline ForDrawing(const Polyline& path) {
  constexpr double kDrawn = 0.01;
  Polyline kept;
  for (std::size_t i = 0; i < path.size();) {
    kept.push_back({std::round(1000 * path[i].x) / 1000, std::round(1000 * path[i].y) / 1000});
    std::size_t next = i + 1;
    const auto is_near = [&](std::size_t end) {
      return std::all_of(path.begin() + static_cast<std::ptrdiff_t>(i), path.begin() + static_cast<std::ptrdiff_t>(end),
                         [&](Point p) { return DistanceToSegment(p, path[i], path[end]) <= kDrawn; });
    };
    while (next + 1 < path.size() && is_near(next + 1)) ++next;
    i = next;
  }
  return kept;
}

/// One job at work.
class CompareWorker {
 public:
  CompareWorker(const CompareSearch& search, const CompareJob& job)
      : question_(search.question),
        job_(job),
        scene_(question_.scenes[job.scene]),
        options_(OptionsOf(search.question, job, scene_.scene)),
        setup_(SetUpLearning(scene_.scene, options_).value()) {}

  std::vector<ComparedPath> Run() {
    if (job_.learn) {
      Learn();
    } else {
      Search();
      Generalise();
    }
    return std::move(paths_);
  }

 private:
  static TetherEnvOptions OptionsOf(const CompareQuestion& question, const CompareJob& job, const Scene& scene) {
    TetherEnvOptions options = EnvFor(question, scene);
    if (job.learn) {
      options.reward.cable_robot = job.cable_robot;
      options.reward.use_reference = job.reference;
    }
    return options;
  }

  void Learn() {
    TrainingOptions training = question_.learn.training;
    training.seed = job_.seed;
    TrainingRun run(*setup_.env, training, *question_.kernels);
    while (!run.done()) run.RunEpisode();
    const PolicyRun drive = RunPolicy(*setup_.env, run.best(), *question_.kernels, true);
    const Polyline path = drive.Path();
    Add("learned", drive.totals.success, path);
    if (job_.baselines) AddBaselines(drive.totals.success ? path : setup_.selection.reference->path);
  }

  /// The shortest path on a lattice and along the Voronoi diagram, in the class of a path.
  void AddBaselines(const Polyline& path) {
    const auto ground = PrepareRobotGround(scene_.scene.world, options_.robot_radius_m);
    const ClassPathQuery query{.from = path.front(),
                               .to = setup_.env->task().goal,
                               .word = ground->space().rays().WordOf(LedTo(path, setup_.env->task().goal))};
    const auto dijkstra = HomotopicDijkstra(*ground, query);
    Add("dijkstra", dijkstra.has_value(), dijkstra.value_or(Polyline{}));
    const auto voronoi = VoronoiRoadmap(*ground, options_.robot_radius_m / 5).PathInClass(query);
    Add("voronoi", voronoi.has_value(), voronoi.value_or(Polyline{}));
  }

  /// A learned path ends within the goal's radius.
  static Polyline LedTo(Polyline path, Point goal) {
    path.push_back(goal);
    return path;
  }

  void Search() {
    const auto plan = PlanContactFree(scene_.scene, {.env = SearchEnv()});
    const bool found = plan && plan->status == ContactFreeStatus::kSolved;
    Add("search", found, found ? plan->path : Polyline{});
  }

  TetherEnvOptions SearchEnv() const {
    TetherEnvOptions env = options_;
    env.max_steps = ContactFreeOptions().env.max_steps;
    return env;
  }

  void Generalise() {
    if (!question_.general) return;
    const DrivenMotion motion = DriverPolicy(*question_.general, PortableKernels()).Drive(*setup_.env);
    Add("general", motion.at_goal, motion.Path());
  }

  void Add(const std::string& method, bool found, const Polyline& path) {
    ComparedPath row{.scene = scene_.name,
                     .group = scene_.group,
                     .method = method,
                     .seed = job_.seed,
                     .kernels = method == "learned" ? question_.kernels->name : "portable",
                     .cable_robot = options_.reward.cable_robot,
                     .reference = job_.reference,
                     .found = found,
                     .length_m = Length(path)};
    if (found) {
      const TrackResult track = TrackPath(*setup_.env, path);
      row.success = track.success();
      row.driven_m = track.driven_m;
      row.time_s = track.time_s;
      row.cable_obstacle = track.cable_obstacle_steps;
      row.cable_robot_steps = track.cable_robot_steps;
    }
    row.path = ForDrawing(path);
    paths_.push_back(std::move(row));
  }

  const CompareQuestion& question_;
  const CompareJob& job_;
  const ComparedScene& scene_;
  TetherEnvOptions options_;
  LearnSetup setup_;
  std::vector<ComparedPath> paths_;
};

Json ToJson(const ComparedPath& path) {
  Json json{{"scene", path.scene},
            {"group", path.group},
            {"method", path.method},
            {"seed", path.seed},
            {"kernels", path.kernels},
            {"reward_cable_robot", path.cable_robot},
            {"reference", path.reference},
            {"found", path.found},
            {"success", path.success},
            {"length", path.length_m},
            {"driven", path.driven_m},
            {"time", path.time_s},
            {"cable_obstacle_steps", path.cable_obstacle},
            {"cable_robot_steps", path.cable_robot_steps},
            {"cable_obstacle_per_minute", path.PerMinute(path.cable_obstacle)},
            {"cable_robot_per_minute", path.PerMinute(path.cable_robot_steps)}};
  json["path"] = Json::array();
  for (const Point p : path.path) json["path"].push_back({p.x, p.y});
  return json;
}

ComparedPath PathOf(const Json& json) {
  ComparedPath path{.scene = json.at("scene").get<std::string>(),
                    .group = json.at("group").get<std::string>(),
                    .method = json.at("method").get<std::string>(),
                    .seed = json.at("seed").get<std::uint64_t>(),
                    .kernels = json.at("kernels").get<std::string>(),
                    .cable_robot = json.at("reward_cable_robot").get<double>(),
                    .reference = json.at("reference").get<bool>(),
                    .found = json.at("found").get<bool>(),
                    .success = json.at("success").get<bool>(),
                    .length_m = json.at("length").get<double>(),
                    .driven_m = json.at("driven").get<double>(),
                    .time_s = json.at("time").get<double>(),
                    .cable_obstacle = json.at("cable_obstacle_steps").get<int>(),
                    .cable_robot_steps = json.at("cable_robot_steps").get<int>(),
                    .path = {}};
  for (const Json& p : json.at("path")) path.path.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  return path;
}

/// That every group that is named has a scene.
Expected<void> CheckGroups(const CompareQuestion& question, const std::vector<std::string>& groups,
                           const char* option) {
  for (const std::string& group : groups) {
    const bool has = std::any_of(question.scenes.begin(), question.scenes.end(),
                                 [&](const ComparedScene& scene) { return scene.group == group; });
    if (!has) return InvalidInput("no scene has this name, with or without a number: " + group, option);
  }
  return {};
}

/// What can be seen to be wrong before any scene is set up.
Expected<void> CheckQuestion(const CompareQuestion& question) {
  if (question.scenes.empty()) return InvalidInput("no scene is given: name one or more");
  for (auto scene = question.scenes.begin(); scene != question.scenes.end(); ++scene) {
    const bool twice = std::any_of(question.scenes.begin(), scene,
                                   [&](const ComparedScene& other) { return other.name == scene->name; });
    if (twice) return InvalidInput("is given twice, or another scene has this name", scene->name);
  }
  for (const double penalty : question.penalties) {
    if (!std::isfinite(penalty)) return InvalidInput("rewards must be finite", "--penalty");
  }
  if (auto known = CheckGroups(question, question.penalty_groups, "--penalty-groups"); !known) return known;
  return CheckGroups(question, question.ablation_groups, "--ablation-groups");
}

/// What tells one comparison from another: scenes, constants, the network of the policy. Not the kernels: a comparison
/// may be finished, or its tables printed again, on another processor; each path says which ones it was learned with.
Json SearchJson(const CompareQuestion& question) {
  Json scenes = Json::array();
  for (const ComparedScene& scene : question.scenes) {
    Json& json = scenes.emplace_back(Json{{"name", scene.name}});
    json.update(TaskJson(scene.scene));
    if (scene.scene.robot.radius) json["robot_radius"] = *scene.scene.robot.radius;
  }
  double general = 0;
  if (question.general) {
    for (const float value : question.general->parameters()) general += static_cast<double>(value);
  }
  return {{"scenes", scenes},
          {"options", ToJson(question.learn)},
          {"seeds", question.seeds},
          {"penalties", question.penalties},
          {"penalty_groups", question.penalty_groups},
          {"ablation_groups", question.ablation_groups},
          {"general", general}};
}

}  // namespace

std::string GroupOf(const std::string& name) {
  std::string group;
  for (std::size_t from = 0; from < name.size();) {
    const std::size_t to = std::min(name.find('_', from), name.size());
    const std::string part = name.substr(from, to - from);
    const bool number = part.find_first_not_of("0123456789") == std::string::npos;
    if (!number || part.empty()) group += (group.empty() ? "" : "_") + part;
    from = to + 1;
  }
  return group.empty() ? name : group;
}

CompareDone CompareSearch::Run(std::size_t job) const { return {job, CompareWorker(*this, jobs[job]).Run()}; }

Expected<CompareSearch> PrepareCompare(CompareQuestion question) {
  if (auto checked = CheckQuestion(question); !checked) return tl::unexpected(checked.error());
  for (const ComparedScene& scene : question.scenes) {
    const auto setup = SetUpLearning(scene.scene, EnvFor(question, scene.scene));
    if (!setup) return tl::unexpected(setup.error());
    if (!setup->env) return InvalidInput("has no reference path: " + setup->selection.explanation, scene.scene.path);
  }
  PartKind part{.command = "learn compare", .version = 1, .digest = 0, .search = SearchJson(question)};
  std::vector<CompareJob> jobs = JobsOf(question);
  return CompareSearch{std::move(question), std::move(jobs), std::move(part)};
}

Json ComparePartJson(const CompareSearch& search, std::vector<CompareDone> done, bool complete) {
  std::sort(done.begin(), done.end(), [](const CompareDone& a, const CompareDone& b) { return a.job < b.job; });
  Json jobs = Json::array();
  for (const CompareDone& job : done) {
    Json paths = Json::array();
    for (const ComparedPath& path : job.paths) paths.push_back(ToJson(path));
    jobs.push_back({{"job", job.job}, {"paths", std::move(paths)}});
  }
  return PartJson(search.part, std::move(jobs), complete);
}

Expected<std::vector<CompareDone>> ReadComparePart(const CompareSearch& search, std::string_view text,
                                                   const std::string& name) {
  const auto jobs = ReadPartJobs(search.part, text, name);
  if (!jobs) return tl::unexpected(jobs.error());
  auto done = ReadingPart(search.part, name, [&jobs] {
    std::vector<CompareDone> read;
    for (const Json& job : *jobs) {
      read.push_back({job.at("job").get<std::size_t>(), {}});
      for (const Json& path : job.at("paths")) read.back().paths.push_back(PathOf(path));
    }
    return read;
  });
  if (!done) return done;
  for (const CompareDone& job : *done) {
    if (job.job < search.jobs.size()) continue;
    return InvalidInput("holds a job " + std::to_string(job.job) + " that this comparison does not have", name);
  }
  return done;
}

}  // namespace tautline
