// Where a drive begins.
#include <algorithm>
#include <utility>

#include "tautline/planners/grid_manifold/drive.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

tl::unexpected<StartRefusal> Refuse(std::string reason, std::string explanation) {
  return tl::unexpected(StartRefusal{std::move(reason), std::move(explanation)});
}

/// The word of a polyline by the rays of the cells, as steps read them: at each change of column.
Word WordAlong(const CellGround& ground, std::span<const Point> line) {
  constexpr double kSamplesPerCell = 4;
  Word word;
  auto before = ground.CellAt(line.front());
  const auto go_to = [&](Point p) {
    const auto cell = ground.CellAt(p);
    if (!cell) return;
    if (before && cell->column != before->column) {
      const bool right = cell->column > before->column;
      const auto rays = ground.RaysBefore(std::max(cell->column, before->column));
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const CellGround::Ray& ray = rays[right ? i : rays.size() - 1 - i];
        if (ray.above_row < before->row) word.Append({ray.obstacle, !right});
      }
    }
    before = cell;
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const int samples = 1 + static_cast<int>(Distance(line[i], line[i + 1]) / ground.cell_m() * kSamplesPerCell);
    for (int k = 1; k <= samples; ++k) go_to(Lerp(line[i], line[i + 1], static_cast<double>(k) / samples));
  }
  return word;
}

/// The cable as it lies before the robot moves.
tl::expected<Cable, StartRefusal> LayCable(const TautSpace& space, const Tether& tether, const CableOptions& options) {
  if (!space.Locate(tether.base)) {
    return Refuse("start_blocked", "the base " + ShortText(tether.base) + " lies on blocked ground");
  }
  if (!tether.laid) return Cable::Create(space, tether.base, options).value();
  std::optional<Walk> walk;
  if (const auto departure = space.Follow(*tether.laid, walk)) {
    return Refuse("laid_cable_blocked", "the laid cable leaves the free ground at " + ShortText(departure->at));
  }
  auto cable = Cable::Lay(space, *tether.laid, options);
  if (cable) return *std::move(cable);
  return Refuse("laid_cable_too_long", "the cable as laid takes " + Metres(Length(*tether.laid)) + ", the tether has " +
                                           Metres(tether.length));
}

}  // namespace

double LengthFromCell(const CellGround& ground, const Tether& tether) {
  const auto cell = ground.CellAt(tether.base);
  return cell ? std::max(0.0, tether.length - Distance(tether.base, ground.CentreOf(*cell))) : 0;
}

tl::expected<DriveState, StartRefusal> StartDrive(const GridManifold& manifold, const TautSpace& space,
                                                  const Tether& tether, const DriveOptions& options) {
  const CellGround& ground = manifold.ground();
  if (const auto base = ground.CellAt(tether.base);
      base && tether.length <= (tether.laid ? 0 : Distance(tether.base, ground.CentreOf(*base)))) {
    return Refuse("tether_too_short", "the tether of " + Metres(tether.length) +
                                          " does not let the robot out of its base at " + ShortText(tether.base) +
                                          " to the middle of the cell there");
  }
  auto cable = LayCable(space, tether,
                        {.length_m = tether.length,
                         .link_length_m = options.link_m,
                         .robot_radius_m = options.robot.radius_m,
                         .reel = options.controller == DriveController::kRetract ? Reel::kRetracting : Reel::kFree});
  if (!cable) return tl::unexpected(cable.error());
  const Point robot = cable->robot();
  const auto cell = ground.CellAt(robot);
  if (!cell || !ground.IsFree(*cell)) {
    return Refuse("start_blocked", "the robot at " + ShortText(robot) +
                                       " stands in a cell that an obstacle or a wall reaches into: give a smaller "
                                       "--resolution, or lay the cable to another place");
  }
  const Polyline laid = tether.laid ? *tether.laid : Polyline{robot};
  const auto vertex = manifold.Find(*cell, WordAlong(ground, laid));
  const Point centre = ground.CentreOf(*cell);
  const double speed = options.robot.speed_mps;
  if (!vertex || cable->Step(centre, Distance(robot, centre) / speed).outcome != StepOutcome::kMoved) {
    return Refuse("laid_cable_too_long", "in the class of the laid cable, the tether of " + Metres(tether.length) +
                                             " does not reach the cell of the robot at " + ShortText(robot) +
                                             " along the cells");
  }
  return DriveState{.cable = *std::move(cable), .at = *vertex, .way = {}};
}

}  // namespace tautline
