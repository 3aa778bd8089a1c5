#include "apps/answers/futures_json.h"

#include <utility>

namespace tautline {
namespace {

Json OutcomeJson(const FreeSpace& space, const FutureOutcome& outcome, bool in_full) {
  Json json;
  json["probability"] = outcome.probability;
  json["status"] = outcome.boundary ? "solved" : "infeasible";
  if (!outcome.boundary) {
    json["reason"] = ToString(outcome.boundary.error().obstruction);
    json["explanation"] = outcome.boundary.error().explanation;
    return json;
  }
  json["area"] = outcome.boundary->area;
  if (!in_full) return json;
  const JsonValues values(space);
  json["boundary"] = values.Of(outcome.boundary->ring);
  json["length"] = outcome.boundary->length;
  json["words"] = Json::array();
  for (const BoundarySide& side : outcome.boundary->sides) json["words"].push_back(values.Of(side.path.word));
  json["max_cable_lengths"] = Json::array();
  for (const LongestCable& cable : outcome.longest) json["max_cable_lengths"].push_back(cable.length);
  return json;
}

}  // namespace

Json FuturesJson(const Futures& futures, const FutureOutcomes& outcomes, bool in_full) {
  Json json;
  json["expected_area"] = outcomes.expected_area;
  json["lost_probability"] = outcomes.lost_probability;
  json["futures"] = Json::array();
  for (std::size_t i = 0; i < outcomes.outcomes.size(); ++i) {
    json["futures"].push_back(OutcomeJson(futures.ground(i).space().free_space(), outcomes.outcomes[i], in_full));
  }
  return json;
}

}  // namespace tautline
