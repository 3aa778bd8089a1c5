#include "tautline/draw/aligned_keyframes.h"

#include <algorithm>
#include <limits>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// `line` with points repeated to the size of `before`, each as near as possible to the point in its place there.
Polyline Stretched(const Polyline& line, const Polyline& before) {
  const std::size_t slots = before.size(), points = line.size();
  // cost[s][k]: slots 0 to s are filled, slot s with point k.
  std::vector<std::vector<double>> cost(slots, std::vector<double>(points, std::numeric_limits<double>::infinity()));
  for (std::size_t s = 0; s < slots; ++s) {
    for (std::size_t k = 0; k < points; ++k) {
      double best = s == 0 && k == 0 ? 0 : std::numeric_limits<double>::infinity();
      if (s > 0) best = std::min(cost[s - 1][k], k > 0 ? cost[s - 1][k - 1] : best);
      cost[s][k] = best + Dot(before[s] - line[k], before[s] - line[k]);
    }
  }
  Polyline stretched(slots);
  std::size_t k = points - 1;
  for (std::size_t s = slots; s-- > 0;) {
    stretched[s] = line[k];
    if (s > 0 && k > 0 && cost[s - 1][k - 1] <= cost[s - 1][k]) --k;
  }
  return stretched;
}

}  // namespace

std::vector<Polyline> AlignedKeyframes(std::span<const Polyline> lines) {
  std::size_t most = 0;
  for (const Polyline& line : lines) {
    TAUTLINE_CHECK(!line.empty());
    most = std::max(most, line.size());
  }
  // From the line with the most points on, both ways: its points have their places.
  std::size_t fullest = 0;
  while (fullest < lines.size() && lines[fullest].size() < most) ++fullest;
  std::vector<Polyline> aligned(lines.begin(), lines.end());
  for (std::size_t i = fullest + 1; i < aligned.size(); ++i) aligned[i] = Stretched(aligned[i], aligned[i - 1]);
  for (std::size_t i = fullest; i-- > 0;) aligned[i] = Stretched(aligned[i], aligned[i + 1]);
  return aligned;
}

}  // namespace tautline
