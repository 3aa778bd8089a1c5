// One future: the ground that it leaves, and how the classes of cables come there [Wang2018, Sec. IV-C].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURE_GROUND_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURE_GROUND_H_

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/base/stop.h"
#include "tautline/homotopy/moving.h"
#include "tautline/homotopy/rays.h"
#include "tautline/planners/cable_workspace/boundary.h"
#include "tautline/planners/cable_workspace/moved_world.h"

namespace tautline {

/// A future, prepared. Cables are carried there as words by one ray for every obstacle of the world, also of those that
/// stand together: obstacles may come together, and leave each other or the wall. Only where obstacles end and on which
/// side of each other's representatives they pass matters, not whether they bump into each other, or leave the outline,
/// on their way. Immutable; queries may run in several threads.
class FutureGround {
 public:
  /// Requires a world that CheckWorld passes. `position` of the future in the scene is for messages. Errors: as
  /// MoveObstacles, and a move that leads a representative exactly through that of another obstacle or through an
  /// anchor; as CableGround::Prepare for the ground. Cost: as CableGround::Prepare.
  [[nodiscard]] static Expected<FutureGround> Prepare(const World& world, std::span<const Point> anchors,
                                                      const Future& future, std::size_t position,
                                                      const Watcher& watch = {});

  /// Of the future.
  double probability() const { return probability_; }
  /// With the obstacles where they are then.
  const World& world() const { return moved_.world; }
  /// Of that world.
  const CableGround& ground() const { return ground_; }
  /// On that ground, or the one that cannot stand there any more.
  const tl::expected<Anchors, AnchorFault>& anchors() const { return anchors_; }

  /// Which letters of cables on `now`, the ground before the future, mean something: those of obstacles whose
  /// representatives are in blocked ground, as all are but for what joining boundaries can do to very small ones.
  std::vector<bool> BlockedOn(const CableGround& now) const;

  /// Carries a side of a boundary: a taut path between anchors as they are on the ground before the future.
  /// `blocked_now` is BlockedOn that ground. Requires anchors. Faults: kAnchorsUnconnected; kNoSuchClass where
  /// obstacles that have come together, or to a wall, leave no path of the class; kTooTangled.
  tl::expected<BoundarySide, BoundaryFault> CarrySide(std::size_t side, const Anchors& anchors_now,
                                                      const TautPath& path, const std::vector<bool>& blocked_now) const;

 private:
  /// A point that writes letters, and the obstacle that it moves with.
  struct Puncture {
    Point now;
    Point then;
    std::size_t obstacle;
    ObstacleId island;  ///< Whose ray starts at it then, if any.
  };

  FutureGround(double probability, MovedWorld moved, CableGround ground, std::span<const Point> anchors);
  void ListPunctures();
  std::size_t CarrierOf(const Island& island) const;
  std::optional<Error> MovePunctures(std::size_t position);
  Error CollisionError(const PunctureCollision& collision, std::size_t obstacle, std::string where) const;
  std::optional<PunctureCollision> MoveGroup(std::vector<ObstacleId> group, Point from, Point to);
  Word WordOfIslands(const Word& word) const;
  Polyline WithStubs(std::size_t side, const Anchors& anchors, const TautPath& path) const;

  double probability_;
  MovedWorld moved_;
  CableGround ground_;
  std::vector<Point> points_;  ///< Of the anchors, as given.
  tl::expected<Anchors, AnchorFault> anchors_;
  std::vector<Puncture> punctures_;  ///< One per obstacle, then those of further pieces of parted obstacles.
  std::optional<MovingPunctures> moving_;
  std::optional<Rays> rays_now_;
  std::optional<Rays> rays_then_;
  std::vector<bool> blocked_;  ///< By puncture: it counts for what is blocked then.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURE_GROUND_H_
