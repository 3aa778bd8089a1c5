// What a search may spend.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_SEARCH_BUDGET_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_SEARCH_BUDGET_H_

#include <cstdint>
#include <utility>

#include "tautline/base/stop.h"

namespace tautline {

/// Steps that are left, and the caller who may stop the search before they are spent.
class SearchBudget {
 public:
  /// `steps` in all; `keep_going` is asked now and then.
  SearchBudget(std::int64_t steps, KeepGoing keep_going) : left_(steps), stop_(std::move(keep_going), kStepsPerCheck) {}

  /// Counts a step. Throws Stopped at the end.
  void Spend() {
    if (left_-- <= 0) throw Stopped();
    stop_.Step();
  }

 private:
  static constexpr int kStepsPerCheck = 256;

  std::int64_t left_;
  StopCheck stop_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_SEARCH_BUDGET_H_
