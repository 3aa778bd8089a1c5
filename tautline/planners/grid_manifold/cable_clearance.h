// How far a cable lies from the cells about it.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_CABLE_CLEARANCE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_CABLE_CLEARANCE_H_

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "tautline/cable/cable.h"
#include "tautline/planners/grid_manifold/cell_ground.h"

namespace tautline {

/// The distance from the middle of each cell to the cable, as far as it is below some radius. What leads from the robot
/// out of the disc of that radius about it does not count: the cable is tied to the robot. [Igarashi2010, Sec. 4.1]
class CableClearance {
 public:
  /// Without a cable. Keeps a reference to the ground. O(cells).
  CableClearance(const CellGround& ground, double radius_m);

  /// Forgets the cable before and measures this one. O(links * cells within the radius of a link).
  void Measure(const Cable& cable);

  /// Below this, distances are known, metres.
  double radius_m() const { return radius_m_; }
  /// The distance of a cell's middle from the cable, metres; infinite where it is not below the radius.
  double at(GridCell cell) const { return std::sqrt(square_[IndexOf(cell)]); }
  /// Whether it is not below the radius.
  bool IsClear(GridCell cell) const { return square_[IndexOf(cell)] == kFar; }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  std::size_t IndexOf(GridCell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(ground_->columns()) +
           static_cast<std::size_t>(cell.column);
  }
  void MeasureLine(Point a, Point b);

  const CellGround* ground_;
  double radius_m_;
  std::vector<double> square_;        ///< Of the distance, by cell, square metres.
  std::vector<std::size_t> touched_;  ///< Cells that are not kFar.
};

/// The radius that keeps a disc off a cable all along a step between the middles of two cells that are not nearer to it
/// than this, metres: no point of a step is farther from both of its ends than half of a diagonal.
double SteppingRadius(double robot_radius_m, double cell_m);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_CABLE_CLEARANCE_H_
