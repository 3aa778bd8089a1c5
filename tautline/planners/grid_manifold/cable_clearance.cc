#include "tautline/planners/grid_manifold/cable_clearance.h"

#include <algorithm>
#include <cmath>

namespace tautline {

CableClearance::CableClearance(const CellGround& ground, double radius_m)
    : ground_(&ground), radius_m_(radius_m), distance_(ground.grid().cells.size(), kFar) {}

void CableClearance::Measure(const Cable& cable) {
  for (const std::size_t i : touched_) distance_[i] = kFar;
  touched_.clear();
  const Polyline shape = cable.Shape();
  // The last point outside of the disc before the cable comes to the robot: what lies beyond it counts.
  std::size_t end = shape.size() - 1;
  while (end > 0 && Distance(shape[end], cable.robot()) <= radius_m_) --end;
  for (std::size_t i = 0; i < end; ++i) MeasureLine(shape[i], shape[i + 1]);
}

void CableClearance::MeasureLine(Point a, Point b) {
  // In columns and rows, also where the grid is turned: the line lies within its half length of its middle.
  const double reach = radius_m_ + Distance(a, b) / 2;
  const auto middle = ground_->CellAt(Lerp(a, b, 0.5));
  if (!middle) return;
  const int span = static_cast<int>(std::ceil(reach / ground_->cell_m())) + 1;
  for (int row = std::max(0, middle->row - span); row <= std::min(ground_->rows() - 1, middle->row + span); ++row) {
    for (int column = std::max(0, middle->column - span);
         column <= std::min(ground_->columns() - 1, middle->column + span); ++column) {
      const GridCell cell{column, row};
      const Point centre = ground_->CentreOf(cell);
      const double distance = Distance(centre, NearestOnSegment(centre, a, b));
      double& known = distance_[IndexOf(cell)];
      if (distance >= radius_m_ || distance >= known) continue;
      if (known == kFar) touched_.push_back(IndexOf(cell));
      known = distance;
    }
  }
}

double SteppingRadius(double robot_radius_m, double cell_m) {
  return std::sqrt(robot_radius_m * robot_radius_m + cell_m * cell_m / 2);
}

}  // namespace tautline
