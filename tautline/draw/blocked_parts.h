// Where a line leaves the free space.
#ifndef TAUTLINE_DRAW_BLOCKED_PARTS_H_
#define TAUTLINE_DRAW_BLOCKED_PARTS_H_

#include <span>
#include <vector>

#include "tautline/scene/free_space.h"

namespace tautline {

/// The parts of a polyline (metres) that lie outside of the free space, each as long as possible,
/// for a picture: parts that only touch a boundary within rounding are left out. O(line times
/// boundary).
std::vector<Polyline> BlockedParts(const FreeSpace& space, std::span<const Point> line);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_BLOCKED_PARTS_H_
