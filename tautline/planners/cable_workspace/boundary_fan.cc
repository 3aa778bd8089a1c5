#include "tautline/planners/cable_workspace/boundary_fan.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace tautline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kStepsPerCheck = 256;

}  // namespace

SearchBudget::SearchBudget(std::int64_t steps, KeepGoing keep_going)
    : left_(steps), stop_(std::move(keep_going), kStepsPerCheck) {}

BoundaryFan::BoundaryFan(const CableGround& ground, AnchorCurves& curves,
                         const std::vector<std::vector<CurveId>>& sides, const FanOptions& options)
    : ground_(ground), curves_(curves), sides_(sides), options_(options), rest_(sides.size() + 1, 0) {
  for (std::size_t i = sides.size(); i-- > 0;) rest_[i] = rest_[i + 1] + options_.shortest[i];
}

void BoundaryFan::ForEach(const std::function<void(std::span<const CurveId>)>& visit) {
  const std::size_t n = sides_.size();
  layers_.assign(n, {});
  visit_ = &visit;
  for (const CurveId side : sides_[0]) {
    layers_[1].nodes[static_cast<std::size_t>(NodeOf(layers_[1], side))].before = curves_.length(side);
  }
  for (const CurveId side : sides_[n - 1]) {
    const CurveId chord = curves_.Add(Reversed(curves_.walk(side)));
    layers_[n - 1].nodes[static_cast<std::size_t>(NodeOf(layers_[n - 1], chord))].after = curves_.length(side);
  }
  std::size_t first = 1, last = n - 1;
  while (first < last) {
    const std::size_t forwards = layers_[first].nodes.size() * sides_[first].size();
    const std::size_t backwards = layers_[last].nodes.size() * sides_[last - 1].size();
    if (forwards <= backwards) {
      GrowForwards(first++);
    } else {
      GrowBackwards(last--);
    }
  }
  for (std::size_t k = n - 1; k >= 1; --k) SortSteps(k);
  for (const Node& node : layers_[1].nodes) {
    if (node.before + node.after > options_.limit || !Push(node.chord)) continue;
    chosen_.push_back(node.chord);
    Descend(1, node, node.before);
    chosen_.pop_back();
    drawn_.pop_back();
  }
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

/// Tries all sides from the chords to anchor k on.
void BoundaryFan::GrowForwards(std::size_t k) {
  Layer &layer = layers_[k], &next = layers_[k + 1];
  for (Node& node : layer.nodes) {
    for (const CurveId side : sides_[k]) {
      const double used = node.before + curves_.length(side);
      if (used + rest_[k + 1] > options_.limit) break;
      options_.budget->Spend();
      if (options_.chords_can_cross && curves_.Cross(node.chord, side)) continue;
      const CurveId chord = curves_.Add(Joined(ground_.space().mesh(), curves_.walk(node.chord), curves_.walk(side)));
      if (used + curves_.length(chord) > options_.limit || !IsTriangle(node.chord, side, chord)) continue;
      const std::int32_t to = NodeOf(next, chord);
      Node& reached = next.nodes[static_cast<std::size_t>(to)];
      reached.before = std::min(reached.before, used);
      node.steps.push_back({side, to, 0});
    }
  }
}

/// Tries all sides to anchor k, from where the chords to it can be continued to the first anchor.
void BoundaryFan::GrowBackwards(std::size_t k) {
  Layer &layer = layers_[k], &before = layers_[k - 1];
  const double missing = rest_[0] - rest_[k - 1];
  for (std::size_t i = 0; i < layer.nodes.size(); ++i) {
    const Node& node = layer.nodes[i];
    for (const CurveId side : sides_[k - 1]) {
      const double used = node.after + curves_.length(side);
      if (used + missing > options_.limit) break;
      options_.budget->Spend();
      if (options_.chords_can_cross && curves_.Cross(node.chord, side)) continue;
      const CurveId chord =
          curves_.Add(Joined(ground_.space().mesh(), curves_.walk(node.chord), Reversed(curves_.walk(side))));
      if (used + curves_.length(chord) > options_.limit || !IsTriangle(node.chord, side, chord)) continue;
      Node& reached = before.nodes[static_cast<std::size_t>(NodeOf(before, chord))];
      reached.after = std::min(reached.after, used);
      reached.steps.push_back({side, static_cast<std::int32_t>(i), 0});
    }
  }
}

/// Gives the chords to anchor k the length of their best rest, from the next layer; the best step comes first.
void BoundaryFan::SortSteps(std::size_t k) {
  for (Node& node : layers_[k].nodes) {
    for (Step& step : node.steps) {
      step.length = curves_.length(step.side) + layers_[k + 1].nodes[static_cast<std::size_t>(step.to)].after;
      node.after = std::min(node.after, step.length);
    }
    std::stable_sort(node.steps.begin(), node.steps.end(),
                     [](const Step& a, const Step& b) { return a.length < b.length; });
  }
}

/// Draws one more curve, unless it crosses another one.
bool BoundaryFan::Push(CurveId curve) {
  for (const CurveId other : drawn_) {
    if (other != curve && curves_.Cross(curve, other)) return false;
  }
  drawn_.push_back(curve);
  return true;
}

/// Goes on from the chord to anchor k in every way that ends within the limit.
void BoundaryFan::Descend(std::size_t k, const Node& node, double used) {
  options_.budget->Spend();
  if (k + 1 == sides_.size()) {
    if (used + node.after > options_.limit) return;
    chosen_.push_back(curves_.Add(Reversed(curves_.walk(node.chord))));
    (*visit_)(chosen_);
    chosen_.pop_back();
    return;
  }
  const std::size_t before = drawn_.size();
  for (const Step& step : node.steps) {
    if (used + step.length > options_.limit) break;
    const Node& next = layers_[k + 1].nodes[static_cast<std::size_t>(step.to)];
    const bool is_side = k + 2 == sides_.size();
    if (Push(step.side) && ((!options_.chords_can_cross && !is_side) || Push(next.chord))) {
      chosen_.push_back(step.side);
      Descend(k + 1, next, used + curves_.length(step.side));
      chosen_.pop_back();
    }
    drawn_.resize(before);
  }
}

}  // namespace tautline
