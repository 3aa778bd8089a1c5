// A rope as it is usually simulated: nodes tied to each other, and pushed out of obstacles one by one.
#ifndef TAUTLINE_BENCH_PEERS_PLAIN_ROPE_H_
#define TAUTLINE_BENCH_PEERS_PLAIN_ROPE_H_

#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// Position-based dynamics without velocities: each step a fixed number of sweeps over all links, after each of which
/// every node is tested against every obstacle and moved to the nearest point of its boundary. Nothing keeps a link
/// from passing an obstacle. Both ends are pinned. [Mueller2007]
class PlainRope {
 public:
  /// All nodes at the base.
  PlainRope(std::vector<Ring> obstacles, Point base, std::size_t links, double link_m)
      : obstacles_(std::move(obstacles)), link_m_(link_m), nodes_(links + 1, base) {}

  /// The last node goes to a point, and the others follow.
  void Step(Point to, int sweeps);

  /// From base to robot.
  const std::vector<Point>& nodes() const { return nodes_; }

  /// How many links pass an obstacle, at least in part.
  std::size_t LinksThroughObstacles() const;

  /// The longest link as a share of its length.
  double WorstStretch() const;

 private:
  void PushOut(Point& node) const;

  std::vector<Ring> obstacles_;
  double link_m_;
  std::vector<Point> nodes_;
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_PLAIN_ROPE_H_
