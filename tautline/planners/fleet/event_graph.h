// The event graph of a fleet on its paths [Zhang2019, Sec. 4.4]: which events come before which.
#ifndef TAUTLINE_PLANNERS_FLEET_EVENT_GRAPH_H_
#define TAUTLINE_PLANNERS_FLEET_EVENT_GRAPH_H_

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "tautline/planners/fleet/pair_rule.h"

namespace tautline {

/// A directed graph whose vertices belong to robots: an edge says that a vertex comes before another one.
struct OrderGraph {
  std::vector<RobotId> robot_of;                  ///< By vertex.
  std::vector<std::vector<std::uint32_t>> after;  ///< By vertex, those that come after it.

  /// How many vertices.
  std::size_t size() const { return robot_of.size(); }
};

/// The strongly connected parts with more than one vertex, of what is left without the vertices of the robots `gone`
/// (by RobotId; may be empty). Vertices in order, parts by their least vertex. O(vertices + edges).
std::vector<std::vector<std::uint32_t>> CyclicParts(const OrderGraph& graph, const std::vector<bool>& gone = {});

/// The vertices in an order that keeps all edges, the least first where several may follow; nothing where there is a
/// circle. O((vertices + edges) log vertices).
std::optional<std::vector<std::uint32_t>> TopologicalOrder(const OrderGraph& graph);

/// The events of all robots, and what must come before what.
struct EventGraph {
  std::vector<std::vector<FleetEvent>> chains;  ///< By RobotId, along the path; without times.
  std::vector<EventEdge> edges;                 ///< Between chains.

  /// As one graph of all events: the chains one after the other, edges within them included.
  OrderGraph Flat() const;
  /// The first vertex of each chain in Flat().
  std::vector<std::size_t> Offsets() const;
};

/// How wide a berth robots give each other at crossings.
struct EventGraphOptions {
  /// How far the middles of two robots must stay apart at a crossing of their paths, metres; empty: points.
  std::function<double(RobotId, RobotId)> gap;
};

/// The event graph of robots on their paths, by RobotId, with the order in which they pass contacts. Events of one
/// robot at one place are one event, exactly. The passings of an event are positions in `orders`. On a stretch that two
/// paths share, the order holds at each event that both have there. With a gap, the second robot comes no nearer to the
/// crossing than gap / sin(angle), or its start, before the first one is as far behind it, or at its target. O(events
/// log events), but for exact arithmetic.
EventGraph MakeEventGraph(const std::vector<RobotPath>& paths, std::span<const OrderedContact> orders,
                          const EventGraphOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_EVENT_GRAPH_H_
