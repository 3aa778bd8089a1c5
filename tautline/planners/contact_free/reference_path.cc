#include "tautline/planners/contact_free/reference_path.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"

namespace tautline {

Polyline Waypoints(const Polyline& path, double spacing_m) {
  TAUTLINE_CHECK(spacing_m > 0);
  Polyline points;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = Distance(path[i - 1], path[i]);
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacing_m)));
    for (int k = 1; k <= pieces; ++k) points.push_back(Lerp(path[i - 1], path[i], static_cast<double>(k) / pieces));
  }
  return points;
}

}  // namespace tautline
