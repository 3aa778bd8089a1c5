#include "tautline/planners/tether/plan_field.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tautline/homotopy/goal_field.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// A grid of this many points takes minutes and hundreds of megabytes.
constexpr double kMostPoints = 4e6;

Expected<FieldGrid> MakeGrid(const Box& box, std::optional<double> resolution) {
  const double side = resolution.value_or(DefaultResolution(box));
  if (!(side > 0) || !std::isfinite(side)) {
    return InvalidInput("the resolution of the field must be larger than 0 and finite", "resolution");
  }
  const double columns = std::max(1.0, std::ceil(box.size().x / side));
  const double rows = std::max(1.0, std::ceil(box.size().y / side));
  if (columns * rows > kMostPoints) {
    return tl::unexpected<Error>(
        Error{ErrorCode::kLimitExceeded,
              "a field of " + FormatNumber(side) + " m has more than four million points; choose a coarser resolution",
              "resolution"});
  }
  return FieldGrid{box.low, side, static_cast<int>(columns), static_cast<int>(rows)};
}

/// Whether a place belongs to one sector of free ground, as almost all do.
bool IsPlain(const TautSpace& space, Place place) { return space.mesh().Sectors(place).size() == 1; }

}  // namespace

double DefaultResolution(const Box& box) {
  constexpr double kAcross = 100;
  const double exact = std::max(box.size().x, box.size().y) / kAcross;
  if (!(exact > 0)) return 1;
  const double digit = std::pow(10.0, std::floor(std::log10(exact)) - 1);
  // A little less, so that what has two digits already keeps them despite rounding.
  return std::ceil(exact / digit - 1e-9) * digit;
}

std::optional<double> FirstHeading(const Polyline& path) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point step = path[i] - path[0];
    if (step.x != 0 || step.y != 0) return std::atan2(step.y, step.x);
  }
  return std::nullopt;
}

Expected<PlanField> PlanField::Prepare(const TetherPlanner& planner, const Tether& tether, Point goal,
                                       const PlanFieldOptions& options) {
  const auto grid = MakeGrid(planner.space().free_space().box, options.resolution);
  if (!grid) return tl::unexpected(grid.error());
  PlanField field(planner, {tether.base, tether.length, {}}, goal, options);
  field.grid_ = *grid;
  return field;
}

PlanField::PlanField(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanFieldOptions& options)
    : planner_(&planner),
      tether_(tether),
      options_(options),
      goal_(planner.PrepareGoal(goal)),
      socket_(FindSocket(planner.space(), planner.ungrown(), tether.base)) {
  from_base_ = planner.Plan(tether_, goal_, {.budget = options.budget, .keep_going = options.keep_going});
  if (from_base_.status == PlanStatus::kInfeasible || !IsPlain(planner.space(), socket_->exit)) return;
  auto to_base = std::make_unique<GoalField>(planner.space(), socket_->exit);
  to_base->GrowTo(std::numeric_limits<double>::infinity());
  to_base_ = std::move(to_base);
}

std::optional<TautPath> PlanField::ShortestTetherTo(Place place) const {
  const TautSpace& space = planner_->space();
  if (!space.mesh().Connected(place, socket_->exit)) return std::nullopt;
  auto path = FindShortestOnward(space, Walk(place), GoalDistances(*to_base_));
  if (!path) return std::nullopt;
  if (socket_->stub_length > 0) path->push_back(socket_->base);
  std::reverse(path->begin(), path->end());
  return space.MakePath(std::move(*path));
}

std::vector<TautPath> PlanField::TethersTo(Place place) const {
  if (options_.classes == 1 && to_base_ && IsPlain(planner_->space(), place)) {
    auto shortest = ShortestTetherTo(place);
    if (!shortest || shortest->length > tether_.length * (1 + kLengthTolerance)) return {};
    return {std::move(*shortest)};
  }
  return planner_
      ->TethersTo(*socket_, Walk(socket_->exit), place,
                  {.max_length = tether_.length,
                   .max_count = options_.classes,
                   .budget = options_.budget,
                   .keep_going = options_.keep_going})
      .classes;
}

void PlanField::AddSamples(int column, int row, FieldRow& samples) const {
  const Point at = grid_.At(column, row);
  const auto place = planner_->space().Locate(at);
  if (!place) return;
  for (TautPath& tether : TethersTo(*place)) {
    const PlanResult plan = planner_->Plan({tether_.base, tether_.length, tether.points}, goal_,
                                           {.budget = options_.budget, .keep_going = options_.keep_going});
    if (plan.status == PlanStatus::kBudgetExceeded) samples.complete = false;
    // A tether that fits but for the rounding of its last digit may be found too long when it is pulled again.
    if (!plan.motion) continue;
    samples.samples.push_back(
        {column, row, at, std::move(tether), FirstHeading(plan.motion->path.points), plan.motion->path.length});
  }
}

FieldRow PlanField::Row(int row) const {
  FieldRow samples;
  if (from_base_.status == PlanStatus::kInfeasible) return samples;
  for (int column = 0; column < grid_.columns; ++column) {
    if (options_.keep_going && !options_.keep_going()) {
      samples.complete = false;
      break;
    }
    AddSamples(column, row, samples);
  }
  return samples;
}

FieldRow PlanField::All() const {
  FieldRow all;
  for (int row = 0; row < grid_.rows; ++row) {
    if (options_.watch && !options_.watch("field", static_cast<double>(row) / grid_.rows)) {
      all.complete = false;
      break;
    }
    FieldRow one = Row(row);
    all.complete = all.complete && one.complete;
    std::move(one.samples.begin(), one.samples.end(), std::back_inserter(all.samples));
  }
  return all;
}

}  // namespace tautline
