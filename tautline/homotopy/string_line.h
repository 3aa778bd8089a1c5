// One string as the pins that it passes, and how it is pulled taut. Internal to TautStrings.
#ifndef TAUTLINE_HOMOTOPY_STRING_LINE_H_
#define TAUTLINE_HOMOTOPY_STRING_LINE_H_

#include <functional>
#include <vector>

#include "tautline/geometry/point.h"
#include "tautline/homotopy/taut_strings.h"

namespace tautline {

/// A vertex of a string: it passes a pin infinitely near, or a free point that nothing holds. How it passes the pin is
/// the angle by which the string sweeps around it, counter-clockwise positive, from where it comes from to where it
/// goes: 2 pi `turns` + the principal angle in (-pi, pi]. A pin holds the string where that is half a turn or more,
/// either way: straight past a pin on the left is +pi, straight past one on the right -pi, back around it 2 pi. With
/// the whole turns written down, no order of pulling can mistake a string that was let go for one that is wound up.
struct StringVertex {
  PinId pin;      ///< Invalid: a free point.
  Point at;       ///< Where it is.
  int turns = 0;  ///< Of the angle swept; meaningless at the ends of a string.
};

/// The principal angle at p from one point to another: 0 when they are in the same direction, 2 in opposite ones (pi),
/// otherwise +1 or -1 by its sign. Exact. Requires points other than p.
int AngleAt(Point p, Point from, Point to);

/// A string's vertices; the ends first and last.
using StringLine = std::vector<StringVertex>;

/// Hands out all pins that may lie in a triangle, and perhaps others.
using PinsNear = std::function<void(Point, Point, Point, const std::function<void(PinId, Point)>&)>;

/// The sweep of a string that passes a pin with two neighbours on a given side, held.
int TurnsOf(Point before, Point at, Point after, Side side);

/// Changes how a vertex counts when the point after it is exchanged by less than half a turn.
void ExchangeNext(StringVertex& vertex, Point before, Point old_next, Point next);
/// Likewise the point before it.
void ExchangePrevious(StringVertex& vertex, Point after, Point old_previous, Point previous);

/// The vertices between u and w of the string u, X, w pulled taut, that turns to the side `turn` (+1: left) at X, where
/// `pins` are those inside of the triangle and on its side uw. O(pins * vertices). Exact.
StringLine ChainAround(Point u, Point w, int turn, std::vector<StringVertex> pins);

/// Pulls a string taut: what nothing holds goes, triangle by triangle. O(vertices + pins swept over).
void PullTaut(StringLine& line, const PinsNear& pins_near);

/// The side on which the pin of an inner vertex lies when it holds the string; kNone when it does not.
Side HeldSide(const StringVertex& vertex, Point before, Point after);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_STRING_LINE_H_
