// The question of `learn reference`, answered: what every face of tautline hands out.
#ifndef APPS_ANSWERS_REFERENCE_ANSWER_H_
#define APPS_ANSWERS_REFERENCE_ANSWER_H_

#include <optional>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "tautline/base/error.h"
#include "tautline/planners/contact_free/select_reference.h"
#include "tautline/planners/contact_free/track_path.h"
#include "tautline/scene/scene.h"

namespace tautline {

struct ReferenceQuestion {
  std::optional<double> robot_radius_m;  ///< Default: the scene's, else 0.5.
  std::int64_t count = 10;               ///< How many of the shortest classes to list.
  std::int64_t budget = 5'000'000;       ///< Of the exact search.
  bool yen = false;                      ///< Also as the paper finds it.
  int paths = 120;                       ///< For that: how many paths each way.
  std::optional<double> step_m;  ///< For that and the lattice baseline: the side of a cell. Default: the radius.
  bool baselines = false;        ///< Also the baselines in the class of the reference, all tracked.
  double lookahead_m = 0.5;      ///< For that.
  bool time = false;             ///< Write the times into the result.
  bool verify = false;           ///< Check the answer by independent means.
  Watcher watch = {};            ///< Told what is being done.
};

/// A path in the class of the reference, and how the simulated robot drove it.
struct TrackedPath {
  std::string method;            ///< "reference", "dijkstra" or "voronoi".
  std::optional<Polyline> path;  ///< Absent where the method has none.
  TrackResult track;             ///< Empty without a path.
};

/// How long the parts took, milliseconds.
struct ReferenceTimes {
  double ground = 0;
  double exact = 0;
  double yen = 0;
};

struct ReferenceAnswer {  // NOLINT(bugprone-exception-escape): the JSON library moves its values without noexcept.
  TautGround ground;
  double robot_radius_m = 0.5;
  double step_m = 0.5;
  ReferenceSelection exact = {};
  std::optional<ReferenceSelection> yen = {};
  std::vector<TrackedPath> tracked = {};
  ReferenceTimes times = {};
  Json json = {};                   ///< The result as docs/learn_reference.md describes it.
  ExitStatus status = kExitSolved;  ///< Of the exact way.
  int verified_curves = 0;          ///< How many taut curves were verified.
};

/// The reference path of the scene's tethered robot. Errors: the scene has no tether or no goal, a radius that is not
/// positive, a step that is too small, those of PrepareRobotGround, and with baselines those of TetherEnv::Create.
/// Throws std::logic_error where the answer fails verification.
[[nodiscard]] Expected<ReferenceAnswer> AnswerReference(const Scene& scene, const ReferenceQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_REFERENCE_ANSWER_H_
