#include "tautline/planners/cable_workspace/ray_tolls.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// How often each refund is moved.
constexpr int kSweeps = 10;
/// Sides times edges that are looked at, about; large maps get fewer trials.
constexpr double kMostWork = 4e7;
/// A step that helps less than this share of the bound is rounding.
constexpr double kLeastGain = 1e-7;
/// Refunds stay below those that make the way around an obstacle free, by this share.
constexpr double kSafety = 0.98;

void AddLetters(const Word& word, int sign, std::vector<int>& sums) {
  for (const Letter letter : word.letters()) sums[letter.obstacle.index()] += letter.inverse ? -sign : sign;
}

}  // namespace

double RefundOf(const TautSpace& space, const RayTolls& tolls, std::span<const Point> polyline) {
  double refund = 0;
  const std::vector<int> crossings = space.rays().HomologyOf(polyline);
  for (std::size_t i = 0; i < crossings.size(); ++i) refund += crossings[i] * tolls.refund[i];
  return refund;
}

TollGraph::TollGraph(const TautSpace& space, const Anchors& anchors) : space_(space) {
  const auto word = [&](Point from, Point to) { return space.rays().WordOf(std::vector{from, to}); };
  for (const TautEdge& edge : space.graph().edges()) {
    edge_words_.push_back(word(space.corners()[edge.from].point, space.corners()[edge.to].point));
  }
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Place from = anchors[i].exit, to = anchors[NextAnchor(i, anchors.size())].exit;
    Side side;
    for (const TautLeg& leg : LegsFrom(space, from)) {
      side.first.push_back({leg.corner, leg.length, word(from.point, space.corners()[leg.corner].point)});
    }
    for (const TautLeg& leg : LegsFrom(space, to)) {
      side.last.push_back({leg.corner, leg.length, word(space.corners()[leg.corner].point, to.point)});
    }
    Walk straight(from);
    if (!WalkStraight(space.mesh(), to.point, straight)) {
      side.straight = Link{CornerId(), Distance(from.point, to.point), word(from.point, to.point)};
    }
    sides_.push_back(std::move(side));
  }
}

double TollGraph::RefundOf(const RayTolls& tolls, const Word& word) const {
  double refund = 0;
  for (const Letter letter : word.letters()) {
    refund += letter.inverse ? -tolls.refund[letter.obstacle.index()] : tolls.refund[letter.obstacle.index()];
  }
  return refund;
}

std::vector<double> TollGraph::RefundOfEdges(const RayTolls& tolls) const {
  std::vector<double> refunds;
  refunds.reserve(edge_words_.size());
  for (const Word& word : edge_words_) refunds.push_back(RefundOf(tolls, word));
  return refunds;
}

std::vector<double> TollGraph::EdgeCosts(const RayTolls& tolls) const {
  std::vector<double> costs = RefundOfEdges(tolls);
  for (std::size_t i = 0; i < costs.size(); ++i) costs[i] = space_.graph().edges()[i].length - costs[i];
  return costs;
}

/// Bellman and Ford; nothing when there is a cycle that costs less than nothing.
std::optional<TollGraph::Costs> TollGraph::FindCosts(const RayTolls& tolls, std::span<const double> edge_costs,
                                                     const Side& side) const {
  const std::size_t corners = space_.corners().size();
  Costs found{std::vector<double>(corners, kInfinity), std::vector<std::int32_t>(corners, 0)};
  for (std::size_t i = 0; i < side.last.size(); ++i) {
    const Link& link = side.last[i];
    const double cost = link.length - RefundOf(tolls, link.word);
    if (cost >= found.cost[link.corner.index()]) continue;
    found.cost[link.corner.index()] = cost;
    found.onward[link.corner.index()] = -1 - static_cast<std::int32_t>(i);
  }
  const auto edges = space_.graph().edges();
  for (std::size_t round = 0; round <= corners; ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double cost = edge_costs[i] + found.cost[edges[i].to.index()];
      double& known = found.cost[edges[i].from.index()];
      // Rounding must not pass for a cycle.
      if (!(cost < known - 1e-12 * edges[i].length)) continue;
      known = cost;
      found.onward[edges[i].from.index()] = static_cast<std::int32_t>(i);
      changed = true;
    }
    if (!changed) return found;
  }
  return std::nullopt;
}

/// The cost of the cheapest path of a side; adds its crossings.
double TollGraph::AddCheapest(const RayTolls& tolls, const Costs& costs, const Side& side,
                              std::vector<int>& excess) const {
  double least = side.straight ? side.straight->length - RefundOf(tolls, side.straight->word) : kInfinity;
  const Link* first = nullptr;
  for (const Link& link : side.first) {
    const double cost = link.length - RefundOf(tolls, link.word) + costs.cost[link.corner.index()];
    if (cost >= least) continue;
    least = cost;
    first = &link;
  }
  AddLetters(first != nullptr ? first->word : side.straight->word, 1, excess);
  for (CornerId at = first != nullptr ? first->corner : CornerId(); at.valid();) {
    const std::int32_t onward = costs.onward[at.index()];
    if (onward < 0) {
      AddLetters(side.last[static_cast<std::size_t>(-1 - onward)].word, 1, excess);
      break;
    }
    AddLetters(edge_words_[static_cast<std::size_t>(onward)], 1, excess);
    at = space_.graph().edges()[static_cast<std::size_t>(onward)].to;
  }
  return least;
}

/// The lower bound of some refunds; fills in the cheapest sides and how much oftener each ray is crossed from left to
/// right by them. Nothing when there is a cycle that costs less than nothing.
std::optional<double> TollGraph::Evaluate(RayTolls& tolls, std::vector<int>& excess) const {
  const std::vector<double> edge_costs = EdgeCosts(tolls);
  excess.assign(tolls.refund.size(), 0);
  tolls.cheapest.clear();
  for (const Side& side : sides_) {
    const auto costs = FindCosts(tolls, edge_costs, side);
    if (!costs) return std::nullopt;
    tolls.cheapest.push_back(AddCheapest(tolls, *costs, side, excess));
  }
  return std::accumulate(tolls.cheapest.begin(), tolls.cheapest.end(), 0.0);
}

RayTolls TollGraph::Free() const {
  RayTolls tolls{std::vector<double>(space_.rays().names().size(), 0), {}};
  std::vector<int> excess;
  TAUTLINE_CHECK(Evaluate(tolls, excess));
  return tolls;
}

RayTolls TollGraph::Raise(double enough) const {
  RayTolls best = Free();
  std::vector<int> excess;
  double bound = *Evaluate(best, excess);
  std::vector<double> steps(best.refund.size(), (enough - bound) / 4);
  const double work = static_cast<double>(sides_.size() * edge_words_.size());
  double left = kMostWork;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < steps.size() && bound < enough && left > 0; ++i) {
      if (excess[i] == 0) continue;
      left -= work;
      RayTolls trial = best;
      // What is crossed too often from left to right is refunded less.
      trial.refund[i] -= excess[i] > 0 ? steps[i] : -steps[i];
      std::vector<int> trial_excess;
      const auto trial_bound = Evaluate(trial, trial_excess);
      if (trial_bound && *trial_bound > bound * (1 + kLeastGain)) {
        bound = *trial_bound;
        best = std::move(trial);
        excess = std::move(trial_excess);
      } else {
        steps[i] /= 2;
      }
    }
  }
  for (double& refund : best.refund) refund *= kSafety;
  TAUTLINE_CHECK(Evaluate(best, excess));
  return best;
}

std::vector<double> TollGraph::CheapestFromCorners(const RayTolls& tolls, std::size_t side) const {
  auto costs = FindCosts(tolls, EdgeCosts(tolls), sides_[side]);
  TAUTLINE_CHECK(costs);
  return std::move(costs->cost);
}

}  // namespace tautline
