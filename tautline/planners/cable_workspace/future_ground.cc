#include "tautline/planners/cable_workspace/future_ground.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/obstacle_naming.h"

namespace tautline {
namespace {

/// The word without the letters that do not count.
Word Counted(const Word& word, const std::vector<bool>& counts) {
  Word counted;
  for (const Letter letter : word.letters()) {
    if (counts[letter.obstacle.index()]) counted.Append(letter);
  }
  return counted;
}

BoundaryFault SideFault(WorkspaceObstruction obstruction, std::size_t side, std::string explanation) {
  return {.obstruction = obstruction, .sides = {side}, .at = {}, .explanation = std::move(explanation)};
}

}  // namespace

FutureGround::FutureGround(double probability, MovedWorld moved, CableGround ground, std::span<const Point> anchors)
    : probability_(probability),
      moved_(std::move(moved)),
      ground_(std::move(ground)),
      points_(anchors.begin(), anchors.end()),
      anchors_(PlaceAnchors(ground_, anchors)) {}

Expected<FutureGround> FutureGround::Prepare(const World& world, std::span<const Point> anchors, const Future& future,
                                             std::size_t position, const Watcher& watch) {
  auto moved = MoveObstacles(world, future, position);
  if (!moved) return tl::unexpected(moved.error());
  auto ground = CableGround::Prepare(moved->world, watch);
  if (!ground) {
    Error error = ground.error();
    if (error.code != ErrorCode::kStopped) error.where = FutureName(position);
    return tl::unexpected(std::move(error));
  }
  FutureGround prepared(future.probability, *std::move(moved), *std::move(ground), anchors);
  prepared.ListPunctures();
  if (auto error = prepared.MovePunctures(position)) return tl::unexpected(*std::move(error));
  return prepared;
}

/// Islands have the order of their first obstacles, and further pieces come last: letters that stand for islands are in
/// the order of the islands, as rays that share a column must be.
void FutureGround::ListPunctures() {
  for (std::size_t i = 0; i < moved_.representatives.size(); ++i) {
    const Point now = moved_.representatives[i];
    punctures_.push_back({now, now + moved_.offsets[i], i, ObstacleId()});
  }
  const std::vector<std::string> names = ObstacleNames(moved_.world);
  const FreeSpace& space = ground_.space().free_space();
  for (std::size_t i = 0; i < space.islands.size(); ++i) {
    const Island& island = space.islands[i];
    const auto first = static_cast<std::size_t>(std::find(names.begin(), names.end(), island.name) - names.begin());
    const bool further_piece = first == names.size() || punctures_[first].island.valid();
    Puncture puncture{island.representative, island.representative, first, ObstacleId(i)};
    if (further_piece || punctures_[first].then != island.representative) {
      puncture.obstacle = CarrierOf(island);
      puncture.now = puncture.then - moved_.offsets[puncture.obstacle];
    } else {
      puncture.now = punctures_[first].now;
    }
    if (further_piece) {
      punctures_.push_back(puncture);
    } else {
      punctures_[first] = puncture;
    }
  }
}

/// The obstacle that the representative of an island lies in, or in whose growth. It need not be a member: a piece of a
/// parted obstacle may consist of another one and the part without width of the first.
std::size_t FutureGround::CarrierOf(const Island& island) const {
  std::tuple<bool, double, std::size_t> nearest{true, std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < moved_.world.obstacles.size(); ++i) {
    const Obstacle& obstacle = moved_.world.obstacles[i];
    const bool outside = !StrictlyInsideObstacle(obstacle, island.representative);
    nearest = std::min(nearest, {outside, DistanceToObstacle(obstacle, island.representative), i});
  }
  return std::get<2>(nearest);
}

std::optional<Error> FutureGround::MovePunctures(std::size_t position) {
  std::vector<Point> now, then;
  std::vector<std::string> names;
  std::vector<std::vector<ObstacleId>> groups(moved_.offsets.size());
  for (std::size_t i = 0; i < punctures_.size(); ++i) {
    now.push_back(punctures_[i].now);
    then.push_back(punctures_[i].then);
    names.push_back(std::to_string(i));
    groups[punctures_[i].obstacle].emplace_back(i);
    blocked_.push_back(punctures_[i].island.valid() || !ground_.space().mesh().Locate(punctures_[i].then, 0));
  }
  rays_now_.emplace(now, names);
  rays_then_.emplace(then, std::move(names));
  moving_.emplace(std::move(now), points_);
  std::vector<Point> offsets(moved_.offsets.size());
  for (const ObstacleStep& step : moved_.steps) {
    const auto collision = MoveGroup(groups[step.obstacle], offsets[step.obstacle], step.offset);
    offsets[step.obstacle] = step.offset;
    if (collision) return CollisionError(*collision, step.obstacle, MoveName(position, step.move));
  }
  // Rays that nearly share a column must not change their order by rounding.
  for (std::size_t i = 0; i < punctures_.size(); ++i) {
    const auto moved = moving_->Move(ObstacleId(i), punctures_[i].then);
    if (!moved) return CollisionError(moved.error(), punctures_[i].obstacle, FutureName(position));
  }
  return std::nullopt;
}

Error FutureGround::CollisionError(const PunctureCollision& collision, std::size_t obstacle, std::string where) const {
  const std::vector<std::string> names = ObstacleNames(moved_.world);
  std::string met;
  if (collision.puncture) {
    met = "that of '" + names[punctures_[collision.puncture->index()].obstacle] + "' at " +
          ToText(moving_->punctures()[collision.puncture->index()]);
  } else {
    met = "anchor " + std::to_string(*collision.end + 1) + " at " + ToText(points_[*collision.end]);
  }
  return {ErrorCode::kInvalidInput,
          "the representative of '" + names[obstacle] + "' moves exactly through " + met +
              ": lead it past on the side that is meant",
          std::move(where)};
}

/// Punctures of one obstacle move together: one after the other is the same when none has to pass through another.
std::optional<PunctureCollision> FutureGround::MoveGroup(std::vector<ObstacleId> group, Point from, Point to) {
  const auto ahead = [&](ObstacleId id) { return Dot(punctures_[id.index()].now, to - from); };
  std::stable_sort(group.begin(), group.end(), [&](ObstacleId a, ObstacleId b) { return ahead(a) > ahead(b); });
  for (const ObstacleId id : group) {
    const auto moved = moving_->Move(id, punctures_[id.index()].now + to);
    if (!moved) return moved.error();
  }
  return std::nullopt;
}

std::vector<bool> FutureGround::BlockedOn(const CableGround& now) const {
  std::vector<bool> blocked;
  for (const Puncture& puncture : punctures_) {
    blocked.push_back(puncture.island.valid() || !now.space().mesh().Locate(puncture.now, 0));
  }
  return blocked;
}

Word FutureGround::WordOfIslands(const Word& word) const {
  Word of_islands;
  for (const Letter letter : word.letters()) {
    const ObstacleId island = punctures_[letter.obstacle.index()].island;
    if (island.valid()) of_islands.Append({island, letter.inverse});
  }
  return of_islands;
}

/// A path from exit to exit, continued to the points that the anchors were given as: those stay where they are.
Polyline FutureGround::WithStubs(std::size_t side, const Anchors& anchors, const TautPath& path) const {
  const std::size_t next = NextAnchor(side, points_.size());
  Polyline line{points_[side], anchors[side].base};
  line.insert(line.end(), path.points.begin(), path.points.end());
  line.insert(line.end(), {anchors[next].base, points_[next]});
  return line;
}

tl::expected<BoundarySide, BoundaryFault> FutureGround::CarrySide(std::size_t side, const Anchors& anchors_now,
                                                                  const TautPath& path,
                                                                  const std::vector<bool>& blocked_now) const {
  TAUTLINE_CHECK(anchors_ && side < anchors_->size());
  const std::size_t count = anchors_->size(), next = NextAnchor(side, count);
  const Socket &from = (*anchors_)[side], &to = (*anchors_)[next];
  const TautSpace& space = ground_.space();
  if (!space.mesh().Connected(from.exit, to.exit)) {
    auto fault = SideFault(WorkspaceObstruction::kAnchorsUnconnected, side, "");
    fault.explanation = ExplainBoundary(ground_, *anchors_, fault);
    return tl::unexpected(std::move(fault));
  }
  const auto carried = moving_->Carry(rays_now_->WordOf(WithStubs(side, anchors_now, path)), side, next);
  if (!carried) {
    return tl::unexpected(SideFault(WorkspaceObstruction::kTooTangled, side,
                                    SideName(side, count) +
                                        " cannot be followed: the obstacles that move wind it around each other so "
                                        "often that its word grows to thousands of letters"));
  }
  const Point first_stub[] = {points_[side], from.base, from.exit.point};
  const Point last_stub[] = {to.exit.point, to.base, points_[next]};
  const Word word =
      space.rays().WordOf(first_stub).Inverse() * WordOfIslands(*carried) * space.rays().WordOf(last_stub).Inverse();
  const auto taut = FindWordPath(space, from.exit, to.exit, word);
  std::vector<bool> counts = blocked_;
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = counts[i] && blocked_now[i];
  // The path of the islands' word is of the class if it is on the same side of all other obstacles as well: those in
  // the same island as the one that has the letter, and those in the wall.
  if (!taut || Counted(rays_then_->WordOf(WithStubs(side, *anchors_, *taut)), counts) != Counted(*carried, counts)) {
    return tl::unexpected(SideFault(WorkspaceObstruction::kNoSuchClass, side,
                                    SideName(side, count) +
                                        " is pinched off: it ran between obstacles, or between one and a wall, where "
                                        "no way is left"));
  }
  return BoundarySide{*taut, WalkBetween(ground_, from, to, *taut)};
}

}  // namespace tautline
