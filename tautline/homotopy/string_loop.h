// The closed curve around a string: what its word tells the class of the string by.
#ifndef TAUTLINE_HOMOTOPY_STRING_LOOP_H_
#define TAUTLINE_HOMOTOPY_STRING_LOOP_H_

#include <span>

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/corners.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// A line that passes points on given sides, led past each of them at a distance of `gap` metres, on the other side;
/// the ends stay. `sides` are those of the points; kNone: straight through. Requires a point and no equal neighbours.
Polyline LedAside(std::span<const Point> line, std::span<const Side> sides, double gap);

/// A closed curve around such a line and both of its ends, first point repeated. Where the ends are points that write
/// letters, its word, read as a ring, tells the class of the line; and it can be carried along when both ends move,
/// since it ends at neither (MovingPunctures). Requires two points or more, and a gap that is far below the distance
/// of any other point from the line.
Polyline LoopAround(std::span<const Point> line, std::span<const Side> sides, double gap);

/// The word of a closed curve from wherever it starts: of all turns of the cyclically reduced word, the least. Equal
/// for words that are conjugates of each other, and only for these. O(letters^2).
Word RingWord(const Word& word);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_STRING_LOOP_H_
