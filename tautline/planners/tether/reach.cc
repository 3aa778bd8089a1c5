#include "tautline/planners/tether/reach.h"

#include <algorithm>
#include <set>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/tether/explain.h"
#include "tautline/planners/tether/reach_plane.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

/// The area of the components of the free ground that meet at a place.
double ConnectedArea(const FreeMesh& mesh, Place place) {
  std::set<std::int32_t> components;
  for (const Place& sector : mesh.Sectors(place)) components.insert(mesh.ComponentOf(sector.triangle));
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangulation().triangles().size(); ++t) {
    const TriangleId id(t);
    if (!mesh.IsFree(id) || !components.contains(mesh.ComponentOf(id))) continue;
    const Point a = mesh.triangulation().corner(id, 0);
    area += 0.5 * Cross(mesh.triangulation().corner(id, 1) - a, mesh.triangulation().corner(id, 2) - a);
  }
  return area;
}

/// The shortest tether from the base to a place, whatever the limit; nothing when the place is not connected.
std::optional<TautPath> ShortestTether(const TautSpace& space, const Socket& socket, Place to) {
  auto path = FindShortestOnward(space, Walk(socket.exit), to);
  if (!path || socket.stub_length == 0) return path;
  path->points.insert(path->points.begin(), socket.base);
  return space.MakePath(std::move(path->points));
}

std::optional<TautPath> Stretched(const TautSpace& space, const Socket& socket, const std::vector<RegionRing>& rings) {
  const RegionPiece* longest = nullptr;
  for (const RegionRing& ring : rings) {
    for (const RegionPiece& piece : ring.pieces) {
      if (piece.is_arc() && (longest == nullptr || Length(piece) > Length(*longest))) longest = &piece;
    }
  }
  if (longest == nullptr) return std::nullopt;
  const auto end = space.Locate(Middle(*longest));
  return end ? ShortestTether(space, socket, *end) : std::nullopt;
}

ReachPoint AskAt(const TetherPlanner& planner, const Socket& socket, double limit, const ReachOptions& options) {
  const TautSpace& space = planner.space();
  ReachPoint asked{.point = *options.at};
  const auto place = space.Locate(asked.point);
  if (!place) {
    asked.obstruction = PlanObstruction::kGoalBlocked;
    asked.explanation = ExplainBlocked(space, "the point", asked.point);
    return asked;
  }
  asked.least_tether = ShortestTether(space, socket, *place);
  if (!asked.least_tether) {
    asked.obstruction = PlanObstruction::kGoalUnreachable;
    asked.explanation = ExplainApart("the point", asked.point, "the base");
    return asked;
  }
  if (asked.least_tether->length > limit * (1 + kLengthTolerance)) {
    asked.obstruction = PlanObstruction::kTetherTooShort;
    asked.explanation = ExplainOutOfReach(asked.point, asked.least_tether->length, limit);
  }
  if (options.sheets) {
    asked.classes =
        planner.TethersTo(socket, Walk(socket.exit), *place, {.max_length = limit, .max_count = options.max_classes});
  }
  return asked;
}

}  // namespace

ReachResult Reach(const TetherPlanner& planner, const Tether& tether, const ReachOptions& options) {
  const TautSpace& space = planner.space();
  TAUTLINE_CHECK(CheckTether(tether, space.free_space().box));
  TAUTLINE_CHECK(!options.at || CheckGoal(*options.at));
  ReachResult result{.limit = tether.length, .socket = FindSocket(space, planner.ungrown(), tether.base)};
  if (!result.socket) {
    result.obstruction = PlanObstruction::kStartBlocked;
    result.explanation = ExplainBlocked(space, "the base", tether.base);
    return result;
  }
  const Socket& socket = *result.socket;
  if (socket.stub_length > tether.length * (1 + kLengthTolerance)) {
    result.obstruction = PlanObstruction::kTetherTooShort;
    result.explanation = ExplainShortInSocket(socket.stub_length, tether.length);
    return result;
  }
  result.status = PlanStatus::kSolved;
  result.connected_area = ConnectedArea(space.mesh(), socket.exit);
  const double length = tether.length - socket.stub_length;
  result.regions = ReachPlane(space, socket.exit, length);
  result.area = AreaOf(result.regions);
  result.stretched = Stretched(space, socket, result.regions);
  if (options.sheets) {
    const Point stub[] = {socket.base, socket.exit.point};
    const Word prefix = socket.stub_length > 0 ? space.rays().WordOf(stub) : Word();
    result.sheets = ReachSheets(
        space,
        {.root = socket.exit, .prefix = prefix, .length = length, .budget = options.budget, .watch = options.watch});
    if (!result.sheets->complete) {
      result.status = PlanStatus::kBudgetExceeded;
      result.explanation = ExplainSheetBudget(options.budget, result.sheets->counted_to + socket.stub_length);
    }
  }
  if (options.at) result.at = AskAt(planner, socket, tether.length, options);
  return result;
}

Expected<ReachResult> Reach(const Scene& scene, const ReachOptions& options) {
  if (const auto checked = RequireTether(scene); !checked) return tl::unexpected(checked.error());
  if (options.at) {
    if (const auto checked = CheckGoal(*options.at, "at"); !checked) return tl::unexpected(checked.error());
  }
  const auto planner = TetherPlanner::Prepare(scene.world);
  if (!planner) return tl::unexpected(planner.error());
  return Reach(*planner, *scene.tether, options);
}

}  // namespace tautline
