#include "tautline/planners/contact_free/reference_path.h"

#include <cmath>

#include "tautline/base/check.h"

namespace tautline {

Polyline Waypoints(const Polyline& path, double spacing_m) {
  TAUTLINE_CHECK(spacing_m > 0);
  Polyline waypoints;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double pieces = std::ceil(Distance(path[i - 1], path[i]) / spacing_m);
    for (double k = 1; k < pieces; ++k) waypoints.push_back(Lerp(path[i - 1], path[i], k / pieces));
    waypoints.push_back(path[i]);
  }
  return waypoints;
}

}  // namespace tautline
