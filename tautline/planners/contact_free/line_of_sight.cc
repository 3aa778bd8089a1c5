#include "tautline/planners/contact_free/line_of_sight.h"

#include <span>
#include <vector>

#include "tautline/planners/contact_free/path_lattice.h"

namespace tautline {

Polyline ShortenByLineOfSight(const TautSpace& space, const Polyline& path) {
  Polyline shortened{path.front()};
  std::size_t at = 0;
  while (at + 1 < path.size()) {
    const auto place = space.Locate(path[at]);
    std::size_t next = path.size() - 1;
    // The next point itself is always to be had, whatever rounding says of the segment.
    for (; next > at + 1; --next) {
      const Point ends[] = {path[at], path[next]};
      const auto piece = std::span(path).subspan(at, next - at + 1);
      if (place && IsFreeSegment(space, *place, path[next]) &&
          space.rays().WordOf(ends) == space.rays().WordOf(piece)) {
        break;
      }
    }
    shortened.push_back(path[next]);
    at = next;
  }
  return shortened;
}

}  // namespace tautline
