// The options of a question as JSON: the options of the program, by the same names with `_` for `-`.
#ifndef APPS_WASM_ASK_OPTIONS_H_
#define APPS_WASM_ASK_OPTIONS_H_

#include <string>

#include "apps/answers/best_answer.h"
#include "apps/answers/boundary_answer.h"
#include "apps/answers/classes_answer.h"
#include "apps/answers/fleet_plan_answer.h"
#include "apps/answers/layouts_answer.h"
#include "apps/answers/manifold_answer.h"
#include "apps/answers/move_answer.h"
#include "apps/answers/plan_answer.h"
#include "apps/answers/pose_answer.h"
#include "apps/answers/reach_answer.h"
#include "apps/answers/simulate_answer.h"
#include "apps/answers/taut_answer.h"
#include "apps/answers/tour_answer.h"
#include "tautline/base/error.h"
#include "tautline/scene/scene_options.h"

namespace tautline::wasm {

struct AskOptions {
  bool svg = false;      ///< Draw the answer too.
  bool animate = false;  ///< Draw the motion as a film too.
  SceneOptions scene;
  PlanQuestion plan;
  ReachQuestion reach;
  ClassesQuestion classes;
  TautQuestion taut;
  BoundaryQuestion boundary;
  BestQuestion best;
  PoseQuestion pose;
  MoveQuestion move;
  TourQuestion tour;
  LayoutsQuestion layouts;
  FleetPlanQuestion fleet_plan;
  SimulateQuestion simulate;
  ManifoldQuestion manifold;
};

/// Reads a JSON object such as `{"count": 5, "svg": true}`; no text stands for no options. All commands know `svg`,
/// `verify`, `unknown` and `simplify`; docs/wasm.md lists those of each command besides. Only the members of the
/// command are filled in. Errors: kInvalidInput for a command that there is not, and for what is not JSON, unknown or
/// out of range.
[[nodiscard]] Expected<AskOptions> ReadAskOptions(const std::string& name, const std::string& text);

}  // namespace tautline::wasm

#endif  // APPS_WASM_ASK_OPTIONS_H_
