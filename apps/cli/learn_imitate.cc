// `tautline learn imitate`: one policy for all maps, taught by the search.
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "apps/answers/json_values.h"
#include "apps/cli/common_options.h"
#include "apps/cli/describe.h"
#include "apps/cli/in_order.h"
#include "apps/cli/learn_commands.h"
#include "apps/cli/option_checks.h"
#include "apps/cli/output_file.h"
#include "apps/cli/progress_bar.h"
#include "apps/cli/read_driver_network.h"
#include "tautline/network/onnx_file.h"
#include "tautline/planners/contact_free/homotopic_dijkstra.h"
#include "tautline/planners/contact_free/imitation.h"
#include "tautline/planners/contact_free/select_reference.h"
#include "tautline/planners/contact_free/track_path.h"
#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Courses that policies are tested on have seeds from here on, and are never taught.
constexpr std::uint64_t kUnseen = 1'000'000'000;
/// Between the seeds of two rounds of teaching.
constexpr std::uint64_t kRound = 10'000'000;
/// So that no course is taught twice, and none that is tested on.
constexpr int kMostCourses = static_cast<int>(kRound);
constexpr int kMostRounds = static_cast<int>(kUnseen / kRound) - 1;

struct LearnImitateCommand {
  CommonOptions common;  ///< There is no scene.
  std::string policy;
  std::string kernels = "auto";
  int courses = 300;
  int rounds = 2;
  int recoveries = 3;
  int test = 50;
  ImitationOptions imitation;
};

/// What the drives of one method over all courses come to.
struct Drives {
  int count = 0, success = 0, cable_obstacle = 0, cable_robot = 0;
  double time_s = 0;

  void Add(bool at_goal, double seconds, int obstacle_steps, int robot_steps) {
    ++count;
    success += at_goal ? 1 : 0;
    time_s += seconds;
    cable_obstacle += obstacle_steps;
    cable_robot += robot_steps;
  }
  void Add(const Drives& other) {
    count += other.count;
    success += other.success;
    cable_obstacle += other.cable_obstacle;
    cable_robot += other.cable_robot;
    time_s += other.time_s;
  }
  double PerMinute(int steps) const { return time_s > 0 ? 60 * steps / time_s : 0; }
};

/// The policy, the search that taught it and the first baseline, on one course.
struct CourseTest {
  Drives policy, search, dijkstra;
};

void AddMotion(const DrivenMotion& motion, double dt_s, Drives& drives) {
  drives.Add(motion.at_goal, motion.costs.steps * dt_s, motion.costs.cable_obstacle_steps,
             motion.costs.cable_robot_steps);
}

CourseTest TestOn(const Course& course, const Mlp& network, const Kernels& kernels) {
  CourseTest test;
  const double dt = course.env.options().dt_s;
  AddMotion(DriverPolicy(network, kernels).Drive(course.env), dt, test.policy);
  ContactFreeOptions search;
  search.env.robot_radius_m = course.env.options().robot_radius_m;
  search.env.link_length_m = course.env.options().link_length_m;
  const auto plan = PlanContactFree(course.scene, search);
  AddMotion(plan ? plan->motion : DrivenMotion(), dt, test.search);
  const auto ground = PrepareRobotGround(course.scene.world, course.env.options().robot_radius_m);
  if (!ground) return test;
  Polyline reference = {course.env.pose().at};
  const Polyline& waypoints = course.env.task().waypoints;
  reference.insert(reference.end(), waypoints.begin(), waypoints.end());
  const auto path = HomotopicDijkstra(
      *ground,
      {.from = reference.front(), .to = course.env.task().goal, .word = ground->space().rays().WordOf(reference)});
  if (!path) {
    test.dijkstra.count = 1;
    return test;
  }
  const TrackResult track = TrackPath(course.env, *path);
  test.dijkstra.Add(track.success(), track.time_s, track.cable_obstacle_steps, track.cable_robot_steps);
  return test;
}

/// Both methods on the unseen courses, in threads.
CourseTest TestUnseen(const LearnImitateCommand& command, const Mlp& network, const Kernels& kernels,
                      ProgressBar& progress) {
  CourseTest all;
  int tested = 0;
  // Some seeds have no course; the others are tested in their order.
  const std::size_t count = 2 * static_cast<std::size_t>(command.test);
  InOrder<std::optional<CourseTest>>::Run(
      {.count = count, .threads = command.common.threads},
      [&](std::size_t i) -> std::optional<CourseTest> {
        const auto course = CourseOf(kUnseen + command.common.seed + i, {});
        if (!course) return std::nullopt;
        return TestOn(*course, network, kernels);
      },
      [&](std::size_t i, const std::optional<CourseTest>& test) {
        progress.Tell("unseen maps", static_cast<double>(i + 1) / static_cast<double>(count));
        if (!test) return true;
        all.policy.Add(test->policy);
        all.search.Add(test->search);
        all.dijkstra.Add(test->dijkstra);
        return ++tested < command.test;
      });
  return all;
}

/// Demonstrations of one round, in the order of the seeds whatever the threads.
Demonstrations Collect(const LearnImitateCommand& command, int round, const CollectOptions& options,
                       ProgressBar& progress) {
  Demonstrations all;
  const auto count = static_cast<std::size_t>(round == 0 ? command.courses : (command.courses + 1) / 2);
  const std::uint64_t first = command.common.seed + static_cast<std::uint64_t>(round) * kRound;
  InOrder<Demonstrations>::Run(
      {.count = count, .threads = command.common.threads},
      [&](std::size_t i) { return CollectDemonstrations(first + i, options); },
      [&](std::size_t i, const Demonstrations& some) {
        all.Append(some);
        progress.Tell(fmt::format("round {}: searching", round),
                      static_cast<double>(i + 1) / static_cast<double>(count));
        return true;
      });
  return all;
}

Expected<Mlp> Teach(const LearnImitateCommand& command, const Kernels& kernels, ProgressBar& progress) {
  Demonstrations all;
  std::optional<Mlp> network;
  for (int round = 0; round <= command.rounds; ++round) {
    CollectOptions options{.recoveries = command.recoveries};
    std::optional<DriverPolicy> policy;
    if (network) policy.emplace(*network, kernels);
    options.policy = policy ? &*policy : nullptr;
    all.Append(Collect(command, round, options, progress));
    if (all.size() == 0) {
      return InvalidInput("no course of these seeds has a motion to learn from; give more", "--courses");
    }
    ImitationOptions imitation = command.imitation;
    imitation.seed = command.common.seed;
    imitation.progress = [&](int epoch, double loss) {
      progress.Tell(fmt::format("round {}: learning, loss {:.4f}", round, loss),
                    static_cast<double>(epoch) / imitation.epochs);
      return true;
    };
    network = Imitate(all, imitation, kernels);
  }
  return *network;
}

Json ToJson(const Drives& drives) {
  return {{"courses", drives.count},
          {"success", drives.success},
          {"cable_obstacle_per_minute", drives.PerMinute(drives.cable_obstacle)},
          {"cable_robot_per_minute", drives.PerMinute(drives.cable_robot)}};
}

std::string Line(const char* name, const Drives& drives) {
  return fmt::format("  {:<20} {} of {} at the goal; contacts a minute: cable-obstacle {:.2f}, cable-robot {:.2f}\n",
                     name, drives.success, drives.count, drives.PerMinute(drives.cable_obstacle),
                     drives.PerMinute(drives.cable_robot));
}

/// The policy as a file, which says how it was taught.
std::string PolicyFile(const LearnImitateCommand& command, const Mlp& network, const Kernels& kernels) {
  const Json options{{"courses", command.courses},
                     {"rounds", command.rounds},
                     {"recoveries", command.recoveries},
                     {"epochs", command.imitation.epochs},
                     {"seed", command.common.seed}};
  return WriteOnnx(
      {network, {{"kernels", kernels.name}, {"kind", "policy for all maps"}, {"options", options.dump()}}});
}

/// That a file can be written, which is found out before the work, not after it.
Expected<void> TryToWrite(const std::string& path) {
  OutputFiles files;
  return path.empty() ? Expected<void>() : files.Add(path, "");
}

Expected<int> RunLearnImitate(const LearnImitateCommand& command) {
  const Kernels* const kernels = FindKernels(command.kernels);
  if (kernels == nullptr) {
    return InvalidInput("this processor, or this build, has no such kernels; give auto",
                        "--kernels " + command.kernels);
  }
  if (command.common.policy.empty() == command.policy.empty()) {
    return InvalidInput("give --out FILE to teach a policy, or --policy FILE to test one", "learn imitate");
  }
  if (auto tried = TryToWrite(command.common.policy); !tried) return tl::unexpected(tried.error());
  ProgressBar progress(!command.common.quiet);
  const auto network = command.policy.empty() ? Teach(command, *kernels, progress) : ReadDriverNetwork(command.policy);
  if (!network) return tl::unexpected(network.error());
  const CourseTest test = TestUnseen(command, *network, *kernels, progress);
  progress.Clear();
  Json json{{"command", "learn imitate"}, {"status", "solved"}, {"kernels", kernels->name}};
  json["policy"] = ToJson(test.policy);
  json["search"] = ToJson(test.search);
  json["dijkstra"] = ToJson(test.dijkstra);
  const std::string text =
      fmt::format("On {} never seen:\n", Counted(static_cast<std::size_t>(test.policy.count), "map", "maps")) +
      Line("policy", test.policy) + Line("search", test.search) + Line("Homotopic Dijkstra", test.dijkstra);
  return Deliver(command.common, {.json = json, .text = text, .draw = {}, .policy = [&] {
                                    return PolicyFile(command, *network, *kernels);
                                  }});
}

}  // namespace

Run AddLearnImitate(CLI::App& learn) {
  const auto command = std::make_shared<LearnImitateCommand>();
  CLI::App* sub =
      learn.add_subcommand("imitate", "one policy for all maps, taught by the search and tested on new maps");
  sub->add_option("--out", command->common.policy, "the policy to write, an ONNX file")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--policy", command->policy, "instead of teaching: the policy to test")
      ->type_name("FILE")
      ->check(FileName());
  sub->add_option("--courses", command->courses, "random courses to learn from, and half as many in each further round")
      ->check(CLI::Range(1, kMostCourses))
      ->capture_default_str();
  sub->add_option("--rounds", command->rounds, "rounds in which the policy learns to get out of its own mistakes")
      ->check(CLI::Range(0, kMostRounds))
      ->capture_default_str();
  sub->add_option("--recoveries", command->recoveries, "of a course in such a round")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--epochs", command->imitation.epochs, "how often each demonstration is seen")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--test", command->test, "courses never seen to test the policy on")
      ->check(CLI::Range(1, kMostCourses))
      ->capture_default_str();
  sub->add_option("--threads", command->common.threads, "the most threads to use; the answer does not depend on it")
      ->check(AtLeastOne())
      ->capture_default_str();
  sub->add_option("--seed", command->common.seed, "the seed of everything random")->capture_default_str();
  sub->add_option("--kernels", command->kernels, "the loops of the network; auto: the widest that the processor has")
      ->check(CLI::IsMember({"auto", "portable", "avx2", "avx512"}))
      ->capture_default_str();
  sub->add_flag("--json", command->common.json, "print one JSON document and nothing else");
  sub->add_flag("--quiet", command->common.quiet, "print nothing but errors");
  sub->footer(
      "Example:\n  tautline learn imitate --courses 20 --rounds 0 --test 10 --out policy.onnx\n"
      "Exit status: 0 solved, 2 bad input.");
  return [command] { return RunLearnImitate(*command); };
}

}  // namespace tautline::cli
