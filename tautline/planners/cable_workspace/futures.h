// A workspace when obstacles may move: what becomes of a boundary in each future [Wang2018, Sec. IV-C].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_

#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/boundary.h"
#include "tautline/planners/cable_workspace/future_ground.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What becomes of a boundary in one future.
struct FutureOutcome {
  double probability = 0;                                   ///< Of the future.
  tl::expected<WorkspaceBoundary, BoundaryFault> boundary;  ///< Or why it is no valid boundary any more.
  std::vector<LongestCable> longest;                        ///< By anchor; empty where the boundary is not valid.
};

/// A boundary in all futures.
struct FutureOutcomes {
  std::vector<FutureOutcome> outcomes;  ///< By future, in the order of the scene.
  double expected_area = 0;     ///< The sum of probability times area; a future without a valid boundary adds nothing.
  double lost_probability = 0;  ///< Of the futures in which the boundary is not valid.
  std::vector<double> longest_cables;  ///< By anchor: the greatest length over now and all futures, metres.
};

/// The futures of a world, prepared: each with its own ground, and with how words change on the way there. Immutable;
/// queries may run in several threads.
class Futures {
 public:
  /// Errors: a move names no obstacle of the world, starts outside of it, or leads its representative exactly through
  /// that of another or through an anchor; no ground is left in a future; coordinates out of range; kStopped. All name
  /// the future and the move. An anchor that a future covers is no error: see FutureOutcome. Cost: as
  /// CableGround::Prepare for each future.
  [[nodiscard]] static Expected<Futures> Prepare(const World& world, std::span<const Point> anchors,
                                                 std::span<const Future> futures, const Watcher& watch = {});

  /// Carries a boundary, which must be one of `ground` and `anchors`, into every future. `ground` must be that of the
  /// world, and `anchors` those that Prepare was given, placed on it. For many boundaries, see BoundaryCarrier.
  FutureOutcomes Carry(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary) const;

  /// One of them, with its world and its anchors.
  const FutureGround& future(std::size_t future) const { return *futures_[future]; }
  /// The ground of a future.
  const CableGround& ground(std::size_t future) const { return futures_[future]->ground(); }
  /// The world of a future: obstacles moved.
  const World& world(std::size_t future) const { return futures_[future]->world(); }
  /// The anchors as Prepare was given them.
  std::span<const Point> points() const { return points_; }
  /// How many there are.
  std::size_t size() const { return futures_.size(); }

 private:
  Futures() = default;

  std::vector<Point> points_;
  std::vector<std::unique_ptr<const FutureGround>> futures_;
};

/// What is asked about a boundary in the futures.
struct CarryOptions {
  bool longest_cables = true;  ///< They cost most of the time, and what only compares areas does without.
};

/// Carries many boundaries of one ground into its futures, and remembers the sides that they share. Keeps all that it
/// is made of by reference. Not to be used by several threads at once: each has its own.
class BoundaryCarrier {
 public:
  /// Requires what Futures::Carry does. O(obstacles * futures).
  BoundaryCarrier(const Futures& futures, const CableGround& ground, const Anchors& anchors);

  /// As Futures::Carry. The same answer in whatever order boundaries come. O(futures * sides * (letters * triangles
  /// across the map)) for new sides, otherwise O(futures * sides^2) comparisons of walks.
  FutureOutcomes Carry(const WorkspaceBoundary& boundary, const CarryOptions& options = {});

 private:
  using Carried = tl::expected<BoundarySide, BoundaryFault>;

  const Carried& CarrySide(std::size_t future, std::size_t side, const TautPath& path);
  tl::expected<WorkspaceBoundary, BoundaryFault> CarryBoundary(std::size_t future, const WorkspaceBoundary& boundary);

  const Futures& futures_;
  const CableGround& ground_;
  const Anchors& anchors_;
  std::vector<std::vector<bool>> blocked_now_;  ///< By future, see FutureGround.
  std::vector<std::map<std::pair<std::size_t, Word>, Carried>>
      carried_;  ///< By future, then by side and its class now.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_
