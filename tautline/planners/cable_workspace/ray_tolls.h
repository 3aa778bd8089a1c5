// Tolls on the rays of obstacles: lower bounds for what closed boundaries cost beyond their shortest sides.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_RAY_TOLLS_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_RAY_TOLLS_H_

#include <optional>
#include <span>
#include <vector>

#include "tautline/homotopy/goal_field.h"
#include "tautline/planners/cable_workspace/cable_ground.h"

namespace tautline {

/// A refund for each crossing of an obstacle's ray from left to right, and the same as a charge from right to left. A
/// closed null-homotopic boundary crosses each ray as often one way as the other, so that its length is the sum of its
/// sides' lengths less their refunds. Each side alone is then as cheap as the cheapest path, and the sum of these is a
/// lower bound for all boundaries: without tolls that of the shortest sides, with good tolls far more.
struct RayTolls {
  std::vector<double> refund;    ///< By island, metres; of either sign.
  std::vector<double> cheapest;  ///< By side: no path from its anchor to the next one costs less, metres.
};

/// What the refunds of a polyline amount to, metres.
double RefundOf(const TautSpace& space, const RayTolls& tolls, std::span<const Point> polyline);

/// The visibility graph and the anchors in it, for paths whose cost is their length less refunds.
class TollGraph {
 public:
  /// O(edges). Requires that all anchors are connected.
  TollGraph(const TautSpace& space, const Anchors& anchors);

  /// No tolls.
  RayTolls Free() const;

  /// Raises the lower bound by moving one refund at a time as long as that helps, with ever smaller steps: coordinate
  /// ascent on a concave function. Ends when the bound reaches `enough`, metres. Any outcome is a valid bound.
  /// O(islands * anchors * edges * corners of a path) per sweep, of which there are ten at most, fewer on large maps.
  RayTolls Raise(double enough) const;

  /// The cost of the cheapest path from each corner to where a side ends, metres. Requires tolls of this graph.
  std::vector<double> CheapestFromCorners(const RayTolls& tolls, std::size_t side) const;

  /// The refund of each edge of the visibility graph, metres.
  std::vector<double> RefundOfEdges(const RayTolls& tolls) const;

 private:
  struct Link {
    CornerId corner;
    double length;
    Word word;  ///< Of the rays that are crossed on the way: from the anchor to the corner, or from it to the anchor.
  };
  struct Side {
    std::vector<Link> first;
    std::vector<Link> last;
    std::optional<Link> straight;
  };
  /// By corner: the cost from there, and where the cheapest path goes on: to an edge, or, from -1 down, by a last link.
  struct Costs {
    std::vector<double> cost;
    std::vector<std::int32_t> onward;
  };

  double RefundOf(const RayTolls& tolls, const Word& word) const;
  std::optional<Costs> FindCosts(const RayTolls& tolls, std::span<const double> edge_costs, const Side& side) const;
  std::vector<double> EdgeCosts(const RayTolls& tolls) const;
  std::optional<double> Evaluate(RayTolls& tolls, std::vector<int>& excess) const;
  double AddCheapest(const RayTolls& tolls, const Costs& costs, const Side& side, std::vector<int>& excess) const;

  const TautSpace& space_;
  std::vector<Word> edge_words_;
  std::vector<Side> sides_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_RAY_TOLLS_H_
