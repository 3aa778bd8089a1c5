// All closed ways around the anchors up to a length, found as fans of chords from the first anchor.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_FAN_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_FAN_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "tautline/planners/cable_workspace/anchor_curves.h"
#include "tautline/planners/cable_workspace/search_budget.h"

namespace tautline {

/// What bounds the fans.
struct FanOptions {
  std::vector<double> cheapest;    ///< By side: no curve costs less, metres.
  double limit = 0;                ///< Of all sides together, metres.
  bool chords_can_cross = false;   ///< Fans in which a chord crosses a side or a chord are left out.
  SearchBudget* budget = nullptr;  ///< Spends a step for each triangle looked at.
};

/// The chord from anchor 0 to anchor k is the class of the sides before k, and, read backwards, of those from k on. So
/// a closed boundary is a path through a graph: its nodes are chords, in layers by k, its edges are sides, and it leads
/// from the trivial chord to the trivial chord.
///
/// Sides count by their cost, which is their length less a refund (see RayTolls): around a closed boundary the refunds
/// cancel. What the limit leaves beyond the cheapest sides is the slack; each side spends some of it. Along a closed
/// boundary, the first side with which more than half of the slack is spent has at most half of it spent before, and
/// less than half after it. So chords are grown from both ends with half of the slack, and joined by one side, which is
/// listed when it spends up to half alone, and otherwise is what closes the gap. Sides are never listed farther than
/// that: the number of classes grows exponentially with the slack. Chords are left out when they and the sides that
/// they stand for are together longer than the limit.
///
/// Then every chord knows the exact cost of its best rest, and only what can be closed is walked.
class BoundaryFan {
 public:
  /// `sides`: the classes of each side that spend up to half of the slack, cheapest first, none of which crosses
  /// itself.
  BoundaryFan(const Anchors& anchors, AnchorCurves& curves, const std::vector<std::vector<CurveId>>& sides,
              const FanOptions& options);

  /// Calls visit(curves by side) for every closed boundary up to the limit whose sides do not cross. Throws Stopped
  /// when the budget is spent.
  void ForEach(const std::function<void(std::span<const CurveId>)>& visit);

 private:
  /// A triangle of the fan: from a chord along a side to the chord of the next layer.
  struct Step {
    CurveId side;
    std::int32_t to;
    double cost;  ///< Of the side and of the best rest from there.
  };
  struct Node {
    CurveId chord;
    double before;            ///< The least cost of sides from the first anchor to here, metres.
    double after;             ///< And from here back to it.
    std::vector<Step> steps;  ///< To the next layer.
  };
  /// Chords to one anchor.
  struct Layer {
    std::vector<Node> nodes;
    std::unordered_map<std::int32_t, std::int32_t> node_of;  ///< By chord.
    std::size_t forwards = 0;                                ///< So many nodes, the first ones, were grown forwards.
  };

  double SpentBefore(std::size_t k, double cost) const { return cost - (rest_[0] - rest_[k]); }
  double SpentAfter(std::size_t k, double cost) const { return cost - rest_[k]; }
  void GrowForwards(std::size_t k);
  void GrowBackwards(std::size_t k);
  void JoinByListed(std::size_t k);
  void JoinByLong(std::size_t k);
  std::int32_t NodeOf(Layer& layer, CurveId chord);
  void AddStep(Node& node, CurveId side, std::int32_t to);
  bool IsTriangle(CurveId chord, CurveId side, CurveId next);
  void SortSteps(std::size_t k);
  void Descend(std::size_t k, const Node& node, double used);
  bool Push(CurveId curve);

  AnchorCurves& curves_;
  const std::vector<std::vector<CurveId>>& sides_;
  FanOptions options_;
  CurveId trivial_;
  double half_ = 0;            ///< Of the slack, metres.
  std::vector<double> rest_;   ///< By anchor: the cheapest sides from it on, metres.
  std::vector<Layer> layers_;  ///< By anchor, from the first one until it comes again.
  std::vector<CurveId> drawn_;
  std::vector<CurveId> chosen_;
  const std::function<void(std::span<const CurveId>)>* visit_ = nullptr;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_BOUNDARY_FAN_H_
