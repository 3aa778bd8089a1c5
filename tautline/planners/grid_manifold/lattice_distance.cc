#include "tautline/planners/grid_manifold/lattice_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/homotopy/taut_path.h"

namespace tautline {
namespace {

/// kDiagonalStep times this is 1 modulo kStraightStep: what tells how many steps were diagonal.
constexpr std::int64_t InverseOfDiagonal() {
  std::int64_t r0 = kStraightStep, r1 = kDiagonalStep % kStraightStep, t0 = 0, t1 = 1;
  while (r1 != 0) {
    const std::int64_t q = r0 / r1, r2 = r0 - q * r1, t2 = t0 - q * t1;
    r0 = r1, r1 = r2, t0 = t1, t1 = t2;
  }
  return (t0 % kStraightStep + kStraightStep) % kStraightStep;
}
constexpr std::int64_t kInverseOfDiagonal = InverseOfDiagonal();
static_assert(kDiagonalStep * kInverseOfDiagonal % kStraightStep == 1);

}  // namespace

double CellsOf(LatticeDistance distance) {
  const std::int64_t diagonal = distance % kStraightStep * kInverseOfDiagonal % kStraightStep;
  const std::int64_t straight = (distance - diagonal * kDiagonalStep) / kStraightStep;
  return static_cast<double>(straight) + static_cast<double>(diagonal) * std::numbers::sqrt2;
}

LatticeDistance LimitOf(double cells) {
  return static_cast<LatticeDistance>(
      std::floor(std::min(cells, kFarthestCells) * (1 + kLengthTolerance) * kStraightStep));
}

}  // namespace tautline
