#include "tautline/draw/heading_arrows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tautline {
namespace {

/// Between arrows that can be told apart, pixels.
constexpr double kLeastSpacing = 11;
constexpr double kLongestArrow = 16;
constexpr double kArrowShare = 0.78;  ///< Of the spacing.

}  // namespace

ArrowLattice::ArrowLattice(double spacing_m, const View& view) {
  const double spacing = spacing_m * view.pixels_per_metre();
  stride = std::max(1, static_cast<int>(std::ceil(kLeastSpacing / std::max(spacing, 1e-9) - 1e-9)));
  length_px = std::min(kArrowShare * stride * spacing_m * view.pixels_per_metre(), kLongestArrow);
}

void AppendArrow(Point middle, double heading_rad, double length_px, std::vector<SvgCurve>& curves) {
  constexpr double kBarbShare = 0.38;
  constexpr double kBarbAngle = 0.85 * std::numbers::pi;
  const auto towards = [](double angle) { return Point{std::cos(angle), -std::sin(angle)}; };  // y points down.
  const Point tip = middle + 0.5 * length_px * towards(heading_rad);
  const Point tail = middle - 0.5 * length_px * towards(heading_rad);
  curves.push_back({.start = tail, .steps = {{.to = tip}}});
  const double barb = kBarbShare * length_px;
  curves.push_back({.start = tip + barb * towards(heading_rad + kBarbAngle),
                    .steps = {{.to = tip}, {.to = tip + barb * towards(heading_rad - kBarbAngle)}}});
}

}  // namespace tautline
