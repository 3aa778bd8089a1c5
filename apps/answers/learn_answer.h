// What `learn train` and `learn evaluate` answer, for every face.
#ifndef APPS_ANSWERS_LEARN_ANSWER_H_
#define APPS_ANSWERS_LEARN_ANSWER_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "apps/answers/learn_options.h"
#include "apps/answers/learn_setup.h"
#include "tautline/network/onnx_file.h"
#include "tautline/planners/contact_free/policy_run.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A policy driven on a scene.
struct LearnAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  std::optional<ReferencePath> reference;  ///< Absent where there is none.
  PolicyRun run;                           ///< Empty where it cannot begin.
  double robot_radius_m = 0;               ///< Of the disc.
  std::string explanation;                 ///< Why it did not succeed; empty when it did.
  Json json;                               ///< The result as docs/learn.md describes it.
  ExitStatus status = kExitSolved;
};

/// Which policy to drive, and how.
struct EvaluateQuestion {
  std::string_view policy;  ///< The bytes of an ONNX file.
  std::string name;         ///< That file's, for messages.
  const Kernels* kernels;   ///< With which to compute.
  Watcher watch = {};       ///< Told what is being done.
};

/// Drives the robot as a policy says, with the constants with which it was trained. Errors: the file is no policy, or
/// as SetUpLearning.
[[nodiscard]] Expected<LearnAnswer> AnswerLearnEvaluate(const Scene& scene, const EvaluateQuestion& question);

/// That there is no reference path: `status`, `reason`, `explanation`.
LearnAnswer NoReference(const std::string& command, const LearnSetup& setup);

/// What a drive came to, as the answer of a command.
LearnAnswer AnswerOf(const std::string& command, const LearnSetup& setup, PolicyRun run);

/// A policy as a file: the network, the constants, the kernels it was trained with and the step it is from.
OnnxModel PolicyOf(const TrainingRun& run, const LearnOptions& options, const Kernels& kernels);

/// Episodes as a table with a heading line.
std::string EpisodesCsv(const std::vector<EpisodeRecord>& episodes);

/// A map of visits as a table: x and y of each cell's middle, and the visits; cells without one are left out.
std::string VisitsCsv(const VisitMap& visits);

}  // namespace tautline

#endif  // APPS_ANSWERS_LEARN_ANSWER_H_
