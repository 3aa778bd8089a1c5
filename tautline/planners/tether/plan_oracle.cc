#include "tautline/planners/tether/plan_oracle.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using State = ClassOracle::State;

class PlanSearch {
 public:
  PlanSearch(ClassOracle& oracle, const OracleQuery& query)
      : oracle_(oracle),
        query_(query),
        base_(query.base_nodes.empty() ? oracle.sight().NodesAt(query.laid.front()) : query.base_nodes),
        robot_(query.robot_nodes.empty() ? oracle.sight().NodesAt(query.laid.back()) : query.robot_nodes),
        goal_(oracle.sight().NodesAt(query.goal)),
        remaining_(oracle.DistancesTo(goal_)),
        laid_word_(oracle.AppendPolyline(0, query.laid)) {}

  OracleMotion Run() {
    OracleMotion motion;
    motion.too_many_states = !FindTethers();
    motion.laid_length = Least(robot_, laid_word_);
    motion.shortest_tether = Least(goal_, {});
    const auto fits = [this](const State& state) { return tethers_.contains({state.node, state.word}); };
    const auto anything = [](const State&) { return true; };
    motion.unlimited = ShortestMotion(anything, anything, motion);
    const bool possible = motion.laid_length < kInfinity && motion.shortest_tether < kInfinity;
    motion.checked = possible ? ShortestMotion(fits, fits, motion) : kInfinity;
    motion.unchecked = possible ? ShortestMotion(anything, fits, motion) : kInfinity;
    return motion;
  }

 private:
  using Test = std::function<bool(const State&)>;

  bool IsGoal(std::size_t node) const { return std::find(goal_.begin(), goal_.end(), node) != goal_.end(); }

  /// All tethers within the limit: from the base to every node in every class.
  bool FindTethers() {
    return oracle_.Run({.start = base_, .word = 0, .remaining = {}, .limit = query_.limit, .allowed = {}},
                       [this](const State& state) {
                         tethers_[{state.node, state.word}] = state.length;
                         return true;
                       });
  }

  /// The least length of the tethers to any of the nodes, in one class or in all.
  double Least(const std::vector<std::size_t>& nodes, std::optional<int> word) const {
    double least = kInfinity;
    for (const auto& [key, length] : tethers_) {
      const bool counts = !word || key.second == *word;
      if (counts && std::find(nodes.begin(), nodes.end(), key.first) != nodes.end()) least = std::min(least, length);
    }
    return least;
  }

  /// The robot's shortest way to the goal; its states carry the word of the tether.
  double ShortestMotion(const Test& on_the_way, const Test& at_the_goal, OracleMotion& motion) {
    double shortest = kInfinity;
    const bool complete = oracle_.Run(
        {.start = robot_, .word = laid_word_, .remaining = remaining_, .limit = 1e300, .allowed = on_the_way},
        [&](const State& state) {
          if (!IsGoal(state.node) || !at_the_goal(state)) return true;
          shortest = state.length;
          return false;
        });
    if (!complete) motion.too_many_states = true;
    return shortest;
  }

  ClassOracle& oracle_;
  const OracleQuery& query_;
  std::vector<std::size_t> base_, robot_, goal_;
  std::vector<double> remaining_;
  int laid_word_;
  std::map<std::pair<std::size_t, int>, double> tethers_;
};

}  // namespace

OracleMotion OraclePlan(ClassOracle& oracle, const OracleQuery& query) { return PlanSearch(oracle, query).Run(); }

}  // namespace tautline
