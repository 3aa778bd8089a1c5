#include "tautline/planners/grid_manifold/cable_clearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tautline {

CableClearance::CableClearance(const CellGround& ground, double radius_m)
    : ground_(&ground), radius_m_(radius_m), square_(ground.grid().cells.size(), kFar) {}

void CableClearance::Measure(const Cable& cable) {
  for (const std::size_t i : touched_) square_[i] = kFar;
  touched_.clear();
  const Polyline shape = cable.Shape();
  // The last point outside of the disc before the cable comes to the robot: what lies beyond it counts.
  std::size_t end = shape.size() - 1;
  while (end > 0 && Distance(shape[end], cable.robot()) <= radius_m_) --end;
  for (std::size_t i = 0; i < end; ++i) MeasureLine(shape[i], shape[i + 1]);
}

void CableClearance::MeasureLine(Point a, Point b) {
  const auto middle = ground_->CellAt(Lerp(a, b, 0.5));
  if (!middle) return;
  // In columns and rows, also where the grid is turned: the line lies within its half length of its middle, and that
  // within half of a diagonal of the middle of its cell.
  const double reach = (radius_m_ + Distance(a, b) / 2) / ground_->cell_m() + std::numbers::sqrt2 / 2;
  const int span = static_cast<int>(std::min(reach, 1e6));
  const Point ab = b - a;
  const double per_square = a == b ? 0 : 1 / Dot(ab, ab);
  for (int row = std::max(0, middle->row - span); row <= std::min(ground_->rows() - 1, middle->row + span); ++row) {
    for (int column = std::max(0, middle->column - span);
         column <= std::min(ground_->columns() - 1, middle->column + span); ++column) {
      const GridCell cell{column, row};
      const Point from_a = ground_->CentreOf(cell) - a;
      const Point from_line = from_a - std::clamp(Dot(from_a, ab) * per_square, 0.0, 1.0) * ab;
      const double square = Dot(from_line, from_line);
      double& known = square_[IndexOf(cell)];
      if (square >= radius_m_ * radius_m_ || square >= known) continue;
      if (known == kFar) touched_.push_back(IndexOf(cell));
      known = square;
    }
  }
}

double SteppingRadius(double robot_radius_m, double cell_m) {
  return std::sqrt(robot_radius_m * robot_radius_m + cell_m * cell_m / 2);
}

}  // namespace tautline
