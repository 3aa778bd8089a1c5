#include "tautline/planners/cable_workspace/boundary_fan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tautline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

BoundaryFan::BoundaryFan(const Anchors& anchors, AnchorCurves& curves, const std::vector<std::vector<CurveId>>& sides,
                         const FanOptions& options)
    : curves_(curves), sides_(sides), options_(options), rest_(sides.size() + 1, 0) {
  for (std::size_t i = sides.size(); i-- > 0;) rest_[i] = rest_[i + 1] + options_.cheapest[i];
  half_ = (options_.limit - rest_[0]) / 2;
  Walk trivial(anchors[0].exit);
  trivial.rooted = true;
  trivial_ = curves_.Add(std::move(trivial), 0);
}

void BoundaryFan::ForEach(const std::function<void(std::span<const CurveId>)>& visit) {
  const std::size_t n = sides_.size();
  layers_.assign(n + 1, {});
  visit_ = &visit;
  layers_[0].nodes.push_back({trivial_, 0, kNever, {}});
  layers_[n].nodes.push_back({trivial_, kNever, 0, {}});
  layers_[n].node_of.emplace(trivial_.value(), 0);
  for (std::size_t k = 0; k + 1 < n; ++k) GrowForwards(k);
  for (std::size_t k = 0; k < n; ++k) layers_[k].forwards = layers_[k].nodes.size();
  for (std::size_t k = n; k > 1; --k) GrowBackwards(k);
  for (std::size_t k = 0; k < n; ++k) {
    JoinByListed(k);
    JoinByLong(k);
  }
  for (std::size_t k = n; k-- > 0;) SortSteps(k);
  Descend(0, layers_[0].nodes[0], 0);
}

std::int32_t BoundaryFan::NodeOf(Layer& layer, CurveId chord) {
  const auto [entry, is_new] = layer.node_of.try_emplace(chord.value(), static_cast<std::int32_t>(layer.nodes.size()));
  if (is_new) layer.nodes.push_back({chord, kNever, kNever, {}});
  return entry->second;
}

bool BoundaryFan::IsTriangle(CurveId chord, CurveId side, CurveId next) {
  return !options_.chords_can_cross ||
         !(curves_.CrossesItself(next) || curves_.Cross(chord, next) || curves_.Cross(side, next));
}

/// Tries all sides from the chords to anchor k on that leave half of the slack.
void BoundaryFan::GrowForwards(std::size_t k) {
  Layer &layer = layers_[k], &next = layers_[k + 1];
  for (Node& node : layer.nodes) {
    for (const CurveId side : sides_[k]) {
      const double used = node.before + curves_.cost(side);
      if (SpentBefore(k + 1, used) > half_) break;
      options_.budget->Spend();
      if (options_.chords_can_cross && curves_.Cross(node.chord, side)) continue;
      const double longest = options_.limit - used - curves_.refund(node.chord) - curves_.refund(side);
      const auto chord = curves_.AddJoined(node.chord, side, longest);
      if (!chord || curves_.length(*chord) > longest || !IsTriangle(node.chord, side, *chord)) continue;
      const std::int32_t to = NodeOf(next, *chord);
      Node& reached = next.nodes[static_cast<std::size_t>(to)];
      reached.before = std::min(reached.before, used);
      node.steps.push_back({side, to, 0});
    }
  }
}

/// Tries all sides to anchor k, from where the chords to it can be continued to the first anchor.
void BoundaryFan::GrowBackwards(std::size_t k) {
  Layer &layer = layers_[k], &before = layers_[k - 1];
  for (std::size_t i = 0; i < layer.nodes.size(); ++i) {
    const CurveId from = layer.nodes[i].chord;
    for (const CurveId side : sides_[k - 1]) {
      const double used = layer.nodes[i].after + curves_.cost(side);
      if (!(SpentAfter(k - 1, used) <= half_)) break;
      options_.budget->Spend();
      if (options_.chords_can_cross && curves_.Cross(from, side)) continue;
      const double longest = options_.limit - used + curves_.refund(from) - curves_.refund(side);
      const auto chord = curves_.AddJoined(from, curves_.Reverse(side), longest);
      if (!chord || curves_.length(*chord) > longest || !IsTriangle(from, side, *chord)) continue;
      Node& reached = before.nodes[static_cast<std::size_t>(NodeOf(before, *chord))];
      reached.after = std::min(reached.after, used);
      AddStep(reached, side, static_cast<std::int32_t>(i));
    }
  }
}

void BoundaryFan::AddStep(Node& node, CurveId side, std::int32_t to) {
  for (const Step& step : node.steps) {
    if (step.to == to) return;
  }
  node.steps.push_back({side, to, 0});
}

/// Joins both parts by listed sides that spend the rest of the first half.
void BoundaryFan::JoinByListed(std::size_t k) {
  Layer &layer = layers_[k], &next = layers_[k + 1];
  for (std::size_t i = 0; i < (k == 0 ? 1 : layer.forwards); ++i) {
    Node& node = layer.nodes[i];
    for (const CurveId side : sides_[k]) {
      const double used = node.before + curves_.cost(side);
      if (used + rest_[k + 1] > options_.limit) break;
      if (k + 1 < sides_.size() && SpentBefore(k + 1, used) <= half_) continue;
      options_.budget->Spend();
      const auto chord = curves_.FindJoined(node.chord, side);
      if (!chord) continue;
      const auto to = next.node_of.find(chord->value());
      if (to == next.node_of.end()) continue;
      if (used + next.nodes[static_cast<std::size_t>(to->second)].after > options_.limit) continue;
      if (options_.chords_can_cross && curves_.Cross(node.chord, side)) continue;
      if (IsTriangle(node.chord, side, *chord)) AddStep(node, side, to->second);
    }
  }
}

/// Joins both parts by whatever side is between them, where that spends more than half of the slack.
void BoundaryFan::JoinByLong(std::size_t k) {
  Layer &layer = layers_[k], &next = layers_[k + 1];
  const double least = options_.cheapest[k] + half_;
  std::vector<std::int32_t> order;
  for (std::size_t i = 0; i < next.nodes.size(); ++i) {
    if (next.nodes[i].after < kNever) order.push_back(static_cast<std::int32_t>(i));
  }
  const auto after = [&](std::int32_t i) { return next.nodes[static_cast<std::size_t>(i)].after; };
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return after(a) < after(b); });
  for (std::size_t i = 0; i < (k == 0 ? 1 : layer.forwards); ++i) {
    Node& node = layer.nodes[i];
    for (const std::int32_t to : order) {
      const double used = node.before + after(to);
      if (used + least > options_.limit) break;
      const CurveId chord = next.nodes[static_cast<std::size_t>(to)].chord;
      const double longest = options_.limit - used + curves_.refund(chord) - curves_.refund(node.chord);
      if (std::fabs(curves_.length(chord) - curves_.length(node.chord)) > longest) continue;
      options_.budget->Spend();
      const auto side = curves_.AddJoined(curves_.Reverse(node.chord), chord, longest);
      if (!side || curves_.cost(*side) < least || curves_.length(*side) > longest) continue;
      if (curves_.CrossesItself(*side)) continue;
      if (options_.chords_can_cross &&
          (curves_.Cross(node.chord, chord) || curves_.Cross(node.chord, *side) || curves_.Cross(chord, *side))) {
        continue;
      }
      AddStep(node, *side, to);
    }
  }
}

/// Gives the chords to anchor k the cost of their best rest, from the next layer; the best step comes first.
void BoundaryFan::SortSteps(std::size_t k) {
  for (Node& node : layers_[k].nodes) {
    node.after = kNever;
    for (Step& step : node.steps) {
      step.cost = curves_.cost(step.side) + layers_[k + 1].nodes[static_cast<std::size_t>(step.to)].after;
      node.after = std::min(node.after, step.cost);
    }
    std::stable_sort(node.steps.begin(), node.steps.end(),
                     [](const Step& a, const Step& b) { return a.cost < b.cost; });
  }
}

/// Draws one more curve, unless it crosses another one.
bool BoundaryFan::Push(CurveId curve) {
  for (const CurveId other : drawn_) {
    if (other != curve && curves_.CrossAgain(curve, other)) return false;
  }
  drawn_.push_back(curve);
  return true;
}

/// Goes on from the chord to anchor k in every way that ends within the limit.
void BoundaryFan::Descend(std::size_t k, const Node& node, double used) {
  if (k == sides_.size()) {
    (*visit_)(chosen_);
    return;
  }
  const std::size_t before = drawn_.size();
  for (const Step& step : node.steps) {
    if (used + step.cost > options_.limit) break;
    options_.budget->Spend();
    const Node& next = layers_[k + 1].nodes[static_cast<std::size_t>(step.to)];
    if (Push(step.side) && (!options_.chords_can_cross || Push(next.chord))) {
      chosen_.push_back(step.side);
      Descend(k + 1, next, used + curves_.cost(step.side));
      chosen_.pop_back();
    }
    drawn_.resize(before);
  }
}

}  // namespace tautline
