// A workspace when obstacles may move: what becomes of a boundary in each future [Wang2018, Sec. IV-C].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/boundary.h"
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

/// The futures of a world, prepared: each with its own ground, and with how words change on the way there. Immutable.
class Futures {
 public:
  /// Errors: a move names no obstacle of the world, starts outside of it, or leads its representative exactly through
  /// that of another or through an anchor; no ground is left in a future; kStopped.
  [[nodiscard]] static Expected<Futures> Prepare(const World& world, std::span<const Point> anchors,
                                                 std::span<const Future> futures, const Watcher& watch = {});

  /// Carries a boundary, which must be one of `ground` and `anchors`, into every future.
  FutureOutcomes Carry(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary) const;

  /// The ground of a future.
  const CableGround& ground(std::size_t future) const;
  /// The world of a future: obstacles moved.
  const World& world(std::size_t future) const;
  /// How many there are.
  std::size_t size() const;

 private:
  struct Prepared;
  Futures();
  std::vector<std::unique_ptr<const Prepared>> prepared_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_FUTURES_H_
