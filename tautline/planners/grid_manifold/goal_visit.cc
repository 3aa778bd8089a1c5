#include "tautline/planners/grid_manifold/goal_visit.h"

#include <algorithm>
#include <utility>

#include "tautline/planners/grid_manifold/accessible_region.h"

namespace tautline {
namespace {

/// Other vertices of the goal that are tried where the nearest is against the rules: each is a simulated drive.
constexpr std::size_t kMostOtherWays = 6;

/// The way that is left until as near as `near`; kUnreached stays.
LatticeDistance Less(LatticeDistance distance, LatticeDistance near) {
  return distance == kUnreached ? kUnreached : std::max(0, distance - near);
}

LatticeDistance RobotWidth(const RobotDriver& driver) {
  return LimitOf(2 * driver.options().radius_m / driver.manifold().ground().cell_m());
}

}  // namespace

GoalVisit::GoalVisit(RobotDriver& driver, Point goal, const ManifoldGoalField& field, TrialBudget& budget,
                     VisitRules rules)
    : driver_(driver), field_(field), budget_(budget), rules_(std::move(rules)) {
  const LatticeDistance near = RobotWidth(driver);
  const double width_m = 2 * driver.options().radius_m;
  const GridManifold& manifold = driver.manifold();
  destination_ = {.remaining = [&field, near](ManifoldVertex v) { return Less(field.distance(v), near); },
                  .holds =
                      [&manifold, &field, near, width_m, goal](ManifoldVertex v) {
                        if (field.distance(v) > near) return false;
                        return field.distance(v) == 0 ||
                               Distance(manifold.ground().CentreOf(manifold.CellOf(v)), goal) <= width_m;
                      }};
}

bool GoalVisit::IsWayOpen(const DriveState& state) const {
  return !FindWay(driver_.Look(state), state.at, destination_).empty();
}

int GoalVisit::CountBlockedPlaces(const DriveState& state) const {
  const OpenGround open = driver_.Look(state);
  const std::vector<ManifoldVertex> way = field_.WayFrom(state.at);
  int places = 0;
  bool blocked = false;
  for (std::size_t i = 1; i < way.size() && !destination_.holds(way[i - 1]); ++i) {
    const bool closed = !open.IsOpen(way[i]);
    if (closed && !blocked) ++places;
    blocked = closed;
  }
  return places;
}

std::optional<DriveState> GoalVisit::TryTo(const Destination& destination, const DriveState& state) const {
  // Each is a trial of its own where there may be many: acceptance is asked again and again.
  if (!AcceptsAll() && !MayTry()) return std::nullopt;
  DriveState after = state;
  if (driver_.Drive(destination, after) != LegEnd::kThere || !KeepsRetreat(after)) return std::nullopt;
  if (rules_.accepts && !rules_.accepts(after)) return std::nullopt;
  return after;
}

std::optional<DriveState> GoalVisit::Try(const DriveState& state) const {
  if (auto after = TryTo(destination_, state); after || (!rules_.keep_retreat && AcceptsAll())) return after;
  const AccessibleRegion region(driver_.Look(state), state.at);
  const std::vector<LatticeDistance> distances = region.DistancesFrom(0);
  std::vector<std::pair<LatticeDistance, std::size_t>> others;
  for (std::size_t v = 0; v < region.size(); ++v) {
    if (field_.distance(region.vertices()[v]) == 0) others.emplace_back(distances[v], v);
  }
  std::sort(others.begin(), others.end());
  for (std::size_t i = 0; i < std::min(kMostOtherWays, others.size()); ++i) {
    if (auto after = TryTo(ToVertex(driver_.manifold(), region.vertices()[others[i].second]), state)) return after;
  }
  return std::nullopt;
}

bool GoalVisit::KeepsRetreat(const DriveState& state) const {
  if (!rules_.keep_retreat) return true;
  const GridManifold& manifold = driver_.manifold();
  const LatticeDistance near = RobotWidth(driver_);
  DriveState back = state;
  return driver_.Drive({.remaining = [&manifold, near](ManifoldVertex v) { return Less(manifold.distance(v), near); },
                        .holds = [&manifold, near](ManifoldVertex v) { return manifold.distance(v) <= near; }},
                       back) == LegEnd::kThere;
}

}  // namespace tautline
