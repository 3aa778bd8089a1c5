// A cable as a chain of rods that follow one another, which obstacles do not hold: fast enough for learning.
#ifndef TAUTLINE_CABLE_CABLE_CHAIN_H_
#define TAUTLINE_CABLE_CABLE_CHAIN_H_

#include <cstddef>
#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// How a chain is made.
struct CableChainOptions {
  double length_m = 0;        ///< All of the cable, with what is on the reel. Positive and finite.
  double link_length_m = 1;   ///< From node to node. Positive. The unit links of [Shimada2024].
  double tolerance_m = 1e-3;  ///< The two passes are repeated until the last node is this near to the robot.
  int max_rounds = 20;        ///< So often at most.
};

/// A cable from its base to the robot's tail. Links have their length, except the first: it grows as the reel pays out,
/// and may be slack. When it is as long as a link, a node enters at the base. Near its full length the passes come to
/// their end slowly, and folded rods may be stuck: then the last link may be stretched by a twentieth, or be shorter.
/// Deterministic; a copy goes on independently. [Shimada2024, Eqs. 6, 7]
class CableChain {
 public:
  /// Laid along a polyline from base to tail; the rest is on the reel. Requires a point, finite points, and a polyline
  /// that is no longer than the cable. O(points + nodes).
  CableChain(std::span<const Point> laid, const CableChainOptions& options);

  /// Pulls the last node to a point, and all others after it: from the tail on [Eq. 6], and, where the reel is empty,
  /// from the base on [Eq. 7], until both ends hold; pulls are made longer by what the base took back of the one
  /// before. False where the cable is too short; nothing moves then. Requires a finite point. O(nodes * rounds).
  bool Pull(Point to);

  /// From base to tail; at least two.
  std::span<const Point> nodes() const { return nodes_; }
  /// Where the cable is tied.
  Point base() const { return nodes_.front(); }
  /// Where the robot pulls.
  Point tail() const { return nodes_.back(); }
  /// How much cable lies on the floor, metres.
  double paid_out_m() const { return first_link_m_ + options_.link_length_m * static_cast<double>(nodes_.size() - 2); }
  /// How it was made.
  const CableChainOptions& options() const { return options_; }

 private:
  void FollowTail(Point to);
  bool PayOut();
  void FollowBase();

  CableChainOptions options_;
  std::vector<Point> nodes_;
  double first_link_m_ = 0;    ///< As long as it may become; never longer than a link.
  std::vector<Point> before_;  ///< Where the nodes were, for motions that are refused.
};

}  // namespace tautline

#endif  // TAUTLINE_CABLE_CABLE_CHAIN_H_
