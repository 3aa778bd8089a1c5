#include "tautline/planners/cable_workspace/tour_bound.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tautline {
namespace {

/// Rounds without a better bound after which steps are halved, and the share of the gap that the first steps take.
constexpr int kPatience = 20;
constexpr double kFirstStep = 1.5;
constexpr double kLeastStep = 1e-8;

/// The least spanning tree under prices.
struct PricedTree {
  double length = 0;         ///< With prices, as a bound for tours without.
  std::vector<int> surplus;  ///< By node: neighbours beyond those in a tour.
};

/// Prim's algorithm. The edge from start to end is in no tour of at least one task.
PricedTree FindTree(const TourDistances& distances, const std::vector<double>& prices) {
  const std::size_t n = distances.nodes(), start = distances.start(), end = distances.end();
  PricedTree tree{0, std::vector<int>(n, -2)};
  tree.surplus[start] = tree.surplus[end] = -1;
  std::vector<double> nearest(n, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> neighbour(n, start);
  std::vector<bool> joined(n, false);
  std::size_t at = start;
  joined[start] = true;
  for (std::size_t step = 1; step < n; ++step) {
    std::size_t next = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (joined[i]) continue;
      const double length = distances(at, i) + prices[at] + prices[i];
      const bool ends = (at == start && i == end) || (at == end && i == start);
      if (!ends && length < nearest[i]) {
        nearest[i] = length;
        neighbour[i] = at;
      }
      if (next == n || nearest[i] < nearest[next]) next = i;
    }
    joined[next] = true;
    tree.length += nearest[next];
    ++tree.surplus[next];
    ++tree.surplus[neighbour[next]];
    at = next;
  }
  for (std::size_t i = 0; i < n; ++i) tree.length -= prices[i] * (i == start || i == end ? 1 : 2);
  return tree;
}

}  // namespace

double BoundTour(const TourDistances& distances, const TourBoundOptions& options) {
  if (distances.tasks() == 0) return distances(distances.start(), distances.end());
  std::vector<double> prices(distances.nodes(), 0);
  double best = 0, share = kFirstStep;
  int since_better = 0;
  for (int round = 0; round < options.rounds && share > kLeastStep; ++round) {
    if (options.keep_going && !options.keep_going()) break;
    const PricedTree tree = FindTree(distances, prices);
    if (tree.length > best) {
      best = tree.length;
      since_better = 0;
    } else if (++since_better == kPatience) {
      share *= 0.5;
      since_better = 0;
    }
    int squares = 0;
    for (const int surplus : tree.surplus) squares += surplus * surplus;
    // The tree is a tour: the bound is met.
    if (squares == 0) break;
    const double step = share * std::max(options.known_length - tree.length, 0.0) / squares;
    for (std::size_t i = 0; i < prices.size(); ++i) prices[i] += step * tree.surplus[i];
  }
  return best;
}

}  // namespace tautline
