// The region that a tether reaches, class by class.
#ifndef TAUTLINE_PLANNERS_TETHER_REACH_SHEETS_H_
#define TAUTLINE_PLANNERS_TETHER_REACH_SHEETS_H_

#include <cstdint>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/homotopy/word.h"
#include "tautline/planners/tether/region_ring.h"

namespace tautline {

/// All points that the tether can reach in classes of one word.
struct Sheet {
  /// That of all tethers to it.
  Word word;
  double area = 0;                ///< Square metres.
  std::vector<RegionRing> rings;  ///< Bounded by walls, arcs, and cuts along the rays.
};

/// The ball that is cut into sheets.
struct SheetOptions {
  Place root;                     ///< Where the tether comes into the free space; counts for all sectors there.
  Word prefix;                    ///< What it has written before, in a socket.
  double length = 0;              ///< Metres from the root on.
  std::int64_t budget = 100'000;  ///< Taut walks after which the list ends incomplete.
  Watcher watch = {};             ///< Told of the share of the budget; at a no the list ends incomplete.
};

/// What was found.
struct SheetList {
  std::vector<Sheet> sheets;  ///< Of a complete list; shorter words first, words of one length in their order.
  std::int64_t classes = 0;   ///< Words that were met; the number of sheets.
  double area = 0;            ///< Of all sheets.
  std::int64_t walks = 0;     ///< Taut walks counted, that of the root included.
  double counted_to = 0;      ///< Every taut walk to a corner that is shorter than this is counted, metres.
  bool complete = false;      ///< All that the tether reaches is counted.
};

/// The ball about the root in the universal cover of the free space, cut along the rays of the words. Each class of a
/// point has one taut walk, so each point of the ball belongs to one walk: to that which bends last at the corner from
/// which the point is seen beyond the turn. Walks are taken shortest first. O(log) and what is seen per walk; their
/// number grows exponentially with the length.
SheetList ReachSheets(const TautSpace& space, const SheetOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_REACH_SHEETS_H_
