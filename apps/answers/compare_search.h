// The comparison of all ways to a contact-free path, in jobs that can be run anywhere [Shimada2024, Sec. 6.3].
#ifndef APPS_ANSWERS_COMPARE_SEARCH_H_
#define APPS_ANSWERS_COMPARE_SEARCH_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/answers/json_values.h"
#include "apps/answers/learn_options.h"
#include "apps/answers/part_file.h"
#include "tautline/base/error.h"
#include "tautline/network/kernels.h"
#include "tautline/network/mlp.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A scene, and which scenes its numbers are averaged with.
struct ComparedScene {
  std::string name;   ///< Of its file, without folder and ending.
  std::string group;  ///< The name without its number: "dots_deployed" of "dots_3_deployed".
  Scene scene;
};

/// The group of a name: without parts between underscores that are numbers.
std::string GroupOf(const std::string& name);

/// What is compared.
struct CompareQuestion {
  std::vector<ComparedScene> scenes;
  LearnOptions learn;             ///< Of the learner; the seed is the first one.
  int seeds = 3;                  ///< Trainings for each scene, one seed after the other.
  std::vector<double> penalties;  ///< Also, for groups in `penalty_groups`: other rewards for standing on the cable.
  std::vector<std::string> penalty_groups;   ///< Groups for which penalties are varied.
  std::vector<std::string> ablation_groups;  ///< Also without the reference, for these groups.
  std::optional<Mlp> general;                ///< The policy for all maps.
  const Kernels* kernels = nullptr;          ///< With which to train.
};

/// A path of one method and what came of it when the simulated robot tracked it.
struct ComparedPath {
  std::string scene;
  std::string group;
  std::string method;         ///< "learned", "dijkstra", "voronoi", "search" or "general".
  std::uint64_t seed = 0;     ///< Of the training; 0 where there is none.
  std::string kernels;        ///< With which the network was computed, where there is one.
  double cable_robot = 0;     ///< The reward for standing on the cable that it was trained with.
  bool reference = true;      ///< It was trained with the reference path.
  bool found = false;         ///< The method has a path to the goal.
  bool success = false;       ///< The robot that tracked it came there.
  double length_m = 0;        ///< Of the path.
  double driven_m = 0;        ///< By the robot.
  double time_s = 0;          ///< That it took, simulated.
  int cable_obstacle = 0;     ///< Steps with such a contact.
  int cable_robot_steps = 0;  ///< Likewise.
  Polyline path;              ///< To about a centimetre; empty without one.

  /// Contacts of a kind a minute.
  double PerMinute(int steps) const { return time_s > 0 ? 60 * steps / time_s : 0; }
};

/// A finished job: the paths that came of it.
struct CompareDone {
  std::size_t job = 0;
  std::vector<ComparedPath> paths;
};

/// A job: one training with the baselines in its class, or the search and the policy for all maps.
struct CompareJob {
  std::size_t scene = 0;
  bool learn = true;
  std::uint64_t seed = 0;
  double cable_robot = 0;
  bool reference = true;
  bool baselines = false;
};

/// A comparison that is ready for its jobs.
struct CompareSearch {
  CompareQuestion question;
  std::vector<CompareJob> jobs;
  PartKind part;  ///< What its parts have in common.

  /// Runs a job. Deterministic for its kernels; safe to call from several threads.
  CompareDone Run(std::size_t job) const;
};

/// Errors: as SetUpLearning for any of the scenes, or one in which there is no reference path; no scene, or two of one
/// name; a reward that is not finite; a group of which there is no scene.
[[nodiscard]] Expected<CompareSearch> PrepareCompare(CompareQuestion question);

/// A part: finished jobs with what they belong to, sorted.
Json ComparePartJson(const CompareSearch& search, std::vector<CompareDone> done, bool complete);

/// The jobs of a part. Errors, with `name`: as ReadPartJobs.
[[nodiscard]] Expected<std::vector<CompareDone>> ReadComparePart(const CompareSearch& search, std::string_view text,
                                                                 const std::string& name);

}  // namespace tautline

#endif  // APPS_ANSWERS_COMPARE_SEARCH_H_
