#include "tautline/planners/contact_free/goal_guide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tautline/base/check.h"
#include "tautline/homotopy/classes.h"

namespace tautline {

GoalGuide::GoalGuide(const TautSpace& space, Place goal, double cell_m)
    : space_(&space), field_(space, goal), per_m_(1 / cell_m) {
  TAUTLINE_CHECK(cell_m > 0);
}

Polyline GoalGuide::ShortestPath(Point from) {
  const std::optional<Place> place = space_->Locate(from);
  if (!place || !space_->mesh().Connected(*place, field_.goal())) return {};
  const auto path = FindShortestOnward(*space_, Walk(*place), GoalDistances(field_));
  return path.value_or(Polyline{});
}

double GoalGuide::LowerBound(Point from) {
  const Point low = space_->free_space().box.low;
  const auto column = static_cast<std::int64_t>(std::floor((from.x - low.x) * per_m_));
  const auto row = static_cast<std::int64_t>(std::floor((from.y - low.y) * per_m_));
  const auto [found, is_new] = cells_.try_emplace((column << 32) ^ (row & 0xffffffff));
  if (is_new) {
    const Polyline path = ShortestPath(from);
    found->second = {from, path.empty() ? std::numeric_limits<double>::infinity() : Length(path)};
    // A place that rounding puts outside tells nothing about its cell.
    if (path.empty()) {
      cells_.erase(found);
      return std::numeric_limits<double>::infinity();
    }
  }
  return std::max(0.0, found->second.distance_m - Distance(from, found->second.at));
}

}  // namespace tautline
