#include "tautline/planners/tether/explain.h"

#include "tautline/scene/number_text.h"

namespace tautline {

std::string ToString(PlanObstruction obstruction) {
  switch (obstruction) {
    case PlanObstruction::kNone:
      return "";
    case PlanObstruction::kStartBlocked:
      return "start_blocked";
    case PlanObstruction::kGoalBlocked:
      return "goal_blocked";
    case PlanObstruction::kGoalUnreachable:
      return "goal_unreachable";
    case PlanObstruction::kLaidCableBlocked:
      return "laid_cable_blocked";
    case PlanObstruction::kLaidCableTooLong:
      return "laid_cable_too_long";
    case PlanObstruction::kTetherTooShort:
      return "tether_too_short";
    case PlanObstruction::kMustCross:
      return "must_cross";
  }
  return "";
}

std::string ExplainBlocked(const TautSpace& space, const std::string& what, Point at) {
  return what + " " + ShortText(at) + " lies " + BlockedText(space.free_space());
}

std::string ExplainLaidCable(const TautSpace& space, PlanObstruction obstruction, Point at) {
  if (obstruction == PlanObstruction::kStartBlocked) return ExplainBlocked(space, "the robot", at);
  return "the cable as laid leaves the free ground at " + ShortText(at) + ": that place is " +
         BlockedText(space.free_space());
}

std::string ExplainApart(const std::string& what, Point at, const std::string& other) {
  return what + " " + ShortText(at) + " and " + other + " are in parts of the free ground that are not connected";
}

std::string ExplainLaidTooLong(double taut_length, double limit) {
  return "the cable as laid needs " + Metres(taut_length) + " when pulled taut, but the tether has only " +
         Metres(limit);
}

std::string ExplainTooShort(const TautSpace& space, const TautPath& shortest, double limit) {
  return "the tether of " + Metres(limit) + " is " + Metres(shortest.length - limit) +
         " too short: the goal needs at least " + Metres(shortest.length) + ", in the class '" +
         ToString(shortest.word, space.rays().names()) + "'";
}

std::string ExplainMustCross(Point at) {
  return "the cable as laid, pulled taut, already crosses itself at " + ShortText(at) +
         ", and no motion starts there without a crossing";
}

std::string ExplainBudget(std::int64_t budget) {
  return "the search stopped after its budget of " + std::to_string(budget) + (budget == 1 ? " step" : " steps") +
         " with the question still open";
}

std::string ExplainStopped() { return "the search was stopped by its caller with the question still open"; }

std::string ExplainOutOfReach(Point at, double shortest, double limit) {
  return "the point " + ShortText(at) + " needs a tether of " + Metres(shortest) + ", " + Metres(shortest - limit) +
         " more than there is";
}

std::string ExplainShortInSocket(double stub_length, double limit) {
  return "the base is closer to a wall than the clearance: the tether of " + Metres(limit) +
         " ends before it is out in the open, after " + Metres(stub_length);
}

std::string ExplainSheetBudget(std::int64_t budget, double counted_to) {
  return "the count of classes stopped after its budget of " + std::to_string(budget) +
         (budget == 1 ? " taut walk" : " taut walks") + ", which are all those up to " + Metres(counted_to) +
         "; raise --budget or shorten the tether";
}

}  // namespace tautline
