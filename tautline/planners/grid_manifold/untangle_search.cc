#include "tautline/planners/grid_manifold/untangle_search.h"

#include <algorithm>
#include <deque>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/accessible_region.h"
#include "tautline/planners/grid_manifold/intermediate_targets.h"
#include "tautline/planners/grid_manifold/state_key.h"

namespace tautline {
namespace {

class UntangleTree {
 public:
  UntangleTree(RobotDriver& driver, const GoalVisit& visit, const UntangleSearchOptions& options)
      : driver_(driver), visit_(visit), options_(options), budget_(options.max_trials) {}

  UntangleResult From(const DriveState& start) {
    Add(start, 0);
    for (int spacing = options_.spacing; spacing >= 1; spacing /= 2) {
      // Every state meets the finer samples; those of before are not tried again.
      open_.clear();
      for (std::size_t i = 0; i < nodes_.size(); ++i) Open(i);
      while (!open_.empty()) {
        const std::size_t node = std::get<2>(*open_.begin());
        open_.erase(open_.begin());
        if (!Expand(node, spacing)) return std::move(result_);
      }
      // States beyond the best way are not worth a finer sampling.
      if (result_.visited) return std::move(result_);
    }
    result_.exhausted = true;
    return std::move(result_);
  }

 private:
  struct Node {
    DriveState state;
    int targets = 0;
    int blocked_places = 0;
    int tried = 0;  ///< The spacing of the last sampling; 0: none.
  };
  using Entry = std::tuple<int, double, std::size_t>;  ///< Blocked places, time, node.

  void Open(std::size_t node) { open_.insert({nodes_[node].blocked_places, nodes_[node].state.cable.time_s(), node}); }

  void Add(const DriveState& state, int targets) {
    if (!keys_.insert(StateKey(state, driver_.coarse_m())).second) return;
    nodes_.push_back({.state = state, .targets = targets, .blocked_places = visit_.CountBlockedPlaces(state)});
    Open(nodes_.size() - 1);
  }

  /// What a node is to try at a spacing.
  std::vector<ManifoldVertex> TargetsOf(Node& node, int spacing) {
    const AccessibleRegion region(driver_.Look(node.state), node.state.at);
    std::vector<ManifoldVertex> targets;
    if (node.tried == 0) {
      for (const IntermediateTarget& target : FindIntermediateTargets(region, driver_.coarse()))
        targets.push_back(target.vertex);
    }
    const GridManifold& manifold = driver_.manifold();
    for (const ManifoldVertex v : SampleTargets(manifold, region, spacing)) {
      const GridCell cell = manifold.CellOf(v);
      const bool before = node.tried > 0 && cell.column % node.tried == 0 && cell.row % node.tried == 0;
      if (!before && std::find(targets.begin(), targets.end(), v) == targets.end()) targets.push_back(v);
    }
    node.tried = spacing;
    return targets;
  }

  /// False when the search is to end.
  bool Expand(std::size_t number, int spacing) {
    if (result_.visited && nodes_[number].state.cable.time_s() >= result_.visited->cable.time_s()) return true;
    const DriveState state = nodes_[number].state;
    const int targets = nodes_[number].targets + 1;
    for (const ManifoldVertex target : TargetsOf(nodes_[number], spacing)) {
      if (result_.trials == budget_ || !visit_.MayTry()) return false;
      ++result_.trials;
      TargetTrial trial = TryTarget(driver_, visit_, state, target);
      if (trial.visited) {
        Keep(*std::move(trial.visited), targets);
      } else if (!trial.touched && trial.after.at != state.at && visit_.KeepsRetreat(trial.after)) {
        Add(trial.after, targets);
      }
    }
    return true;
  }

  void Keep(DriveState visited, int targets) {
    if (!result_.visited) budget_ = visit_.AcceptsAll() ? std::min(budget_, 2 * result_.trials) : result_.trials;
    if (result_.visited && visited.cable.time_s() >= result_.visited->cable.time_s()) return;
    result_.visited = std::move(visited);
    result_.targets = targets;
  }

  RobotDriver& driver_;
  const GoalVisit& visit_;
  UntangleSearchOptions options_;
  int budget_;
  UntangleResult result_;
  std::deque<Node> nodes_;
  std::set<std::uint64_t> keys_;
  std::set<Entry> open_;
};

}  // namespace

UntangleResult SearchUntangling(RobotDriver& driver, const GoalVisit& visit, const DriveState& start,
                                const UntangleSearchOptions& options) {
  TAUTLINE_CHECK(options.spacing >= 1);
  return UntangleTree(driver, visit, options).From(start);
}

}  // namespace tautline
