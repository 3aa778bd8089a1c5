// The cable lines that one robot could have, the shortest first. Internal to the fleet planner.
#ifndef TAUTLINE_PLANNERS_FLEET_ROUTE_SEARCH_H_
#define TAUTLINE_PLANNERS_FLEET_ROUTE_SEARCH_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "tautline/planners/fleet/layout.h"

namespace tautline {

/// Which nodes a taut cable can lead between in one straight leg; asked for as they are needed, and then kept.
class FleetSight {
 public:
  /// The ground must outlive it. O(1).
  explicit FleetSight(const FleetGround& ground) : ground_(ground), legs_(ground.node_count()) {}

  /// A straight leg.
  struct Leg {
    FleetNodeId to;     ///< Where it ends.
    double length = 0;  ///< Metres.
  };

  /// The legs that lead from a start, target or corner to targets and corners: inside of the free space, tangent at
  /// corners, and over no start or target. Cost: once O(nodes * triangles passed).
  const std::vector<Leg>& From(FleetNodeId node);

 private:
  bool IsLeg(FleetNodeId from, FleetNodeId to) const;
  bool IsTangent(FleetNodeId at, FleetNodeId from) const;

  const FleetGround& ground_;
  std::vector<std::optional<std::vector<Leg>>> legs_;
};

/// One robot's cable line, found.
struct CandidateRoute {
  Route route;        ///< From its start to its target.
  double length = 0;  ///< Metres.
};

/// Searches the cable lines of one robot: those that bend around targets of others and corners, pass no node twice, do
/// not cross themselves, lead over no start and no target without a bend, and whose polygon encloses no start.
/// Best first, so they come in order of their lengths.
class RouteSearch {
 public:
  /// Lines up to `limit` metres. `sight` is that of the ground; both must outlive the search. O(1).
  RouteSearch(const FleetGround& ground, FleetSight& sight, RobotId robot, double limit);

  /// Goes on until every line of up to `length` metres is in candidates(), or until about `steps` more legs were
  /// looked at. Returns how many were. O(bends) for each.
  std::int64_t Extend(double length, std::int64_t steps);

  /// Those found so far, the shortest first.
  const std::vector<CandidateRoute>& candidates() const { return candidates_; }
  /// Every line that is not among the candidates is at least this long, metres; infinite when there is none.
  double next_bound() const;

 private:
  /// The beginning of a line; the rest of it is told by its parent.
  struct Partial {
    FleetNodeId node;
    std::int64_t parent = -1;
    double length = 0;
  };

  double BoundOf(const Partial& partial) const;
  std::vector<FleetNodeId> NodesOf(std::int64_t partial) const;
  std::int64_t Expand(std::int64_t partial);
  void Finish(std::int64_t partial);
  bool CanGoOn(const std::vector<FleetNodeId>& nodes, FleetNodeId to) const;

  const FleetGround& ground_;
  FleetSight& sight_;
  RobotId robot_;
  double limit_;
  std::vector<Partial> partials_;
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  std::vector<CandidateRoute> candidates_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_ROUTE_SEARCH_H_
