#include "tautline/planners/contact_free/path_graph.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace tautline {

PathGraph::PathGraph(std::vector<Point> points, std::vector<Edge> edges) : points_(std::move(points)) {
  const std::size_t given = edges.size();
  for (std::size_t i = 0; i < given; ++i) edges.emplace_back(edges[i].second, edges[i].first);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  begin_.assign(points_.size() + 1, 0);
  for (const Edge& edge : edges) ++begin_[edge.first.index() + 1];
  for (std::size_t i = 0; i < points_.size(); ++i) begin_[i + 1] += begin_[i];
  to_.reserve(edges.size());
  for (const Edge& edge : edges) to_.push_back(edge.second);
}

std::vector<double> PathGraph::DistancesTo(PathNodeId goal) const {
  std::vector<double> distance(size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, PathNodeId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance[goal.index()] = 0;
  queue.emplace(0, goal);
  while (!queue.empty()) {
    const auto [reached, at] = queue.top();
    queue.pop();
    if (reached > distance[at.index()]) continue;
    for (const PathNodeId next : Neighbours(at)) {
      const double through = reached + Length(at, next);
      if (through >= distance[next.index()]) continue;
      distance[next.index()] = through;
      queue.emplace(through, next);
    }
  }
  return distance;
}

Polyline PathGraph::PointsOf(std::span<const PathNodeId> nodes) const {
  Polyline points;
  points.reserve(nodes.size());
  for (const PathNodeId id : nodes) points.push_back(point(id));
  return points;
}

}  // namespace tautline
