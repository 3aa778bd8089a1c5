// The question of `plan --field`, answered: the next heading from everywhere.
#ifndef APPS_ANSWERS_PLAN_FIELD_ANSWER_H_
#define APPS_ANSWERS_PLAN_FIELD_ANSWER_H_

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/answers/json_values.h"
#include "apps/answers/preparation.h"
#include "tautline/base/error.h"
#include "tautline/planners/tether/plan_field.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A row with what its verification found.
struct CheckedRow {
  FieldRow row;
  std::vector<std::string> faults;
  int curves = 0;
};

/// Computes all rows of a field, in any order and in several threads if it likes, and returns them in order.
using RowRunner = std::function<std::vector<CheckedRow>(int rows, const std::function<CheckedRow(int row)>& compute)>;

/// One row after the other.
std::vector<CheckedRow> RunRows(int rows, const std::function<CheckedRow(int row)>& compute);

struct PlanFieldQuestion {
  PlanFieldOptions options;
  bool verify = false;           ///< Check every plan by independent means.
  Preparation preparation = {};  ///< How the world is prepared.
  RowRunner run_rows = RunRows;
};

struct PlanFieldAnswer {
  std::unique_ptr<const TetherPlanner> planner;
  PlanResult from_base;  ///< Why the field is empty, where it is.
  FieldGrid grid;
  std::vector<FieldSample> samples;  ///< By row, column and class.
  bool complete = true;
  Json json;                        ///< The result as docs/plan.md describes it.
  ExitStatus status = kExitSolved;  ///< kExitInfeasible too where a budget ran out.
  int verified_curves = 0;          ///< How many taut curves were verified.
};

/// Plans from all points of a grid. Errors: the scene has no tether or no goal, those of PreparePlanner and of
/// PlanField::Prepare. Throws std::logic_error where the answer fails verification. Cost: see PlanField.
[[nodiscard]] Expected<PlanFieldAnswer> AnswerPlanField(const Scene& scene, const PlanFieldQuestion& question);

}  // namespace tautline

#endif  // APPS_ANSWERS_PLAN_FIELD_ANSWER_H_
