// Arcs of one circle as spans of angles, and what lines and other discs leave of them.
#ifndef TAUTLINE_PLANNERS_TETHER_CIRCLE_SPAN_H_
#define TAUTLINE_PLANNERS_TETHER_CIRCLE_SPAN_H_

#include <span>
#include <vector>

#include "tautline/geometry/point.h"

namespace tautline {

/// A closed disc, metres.
struct Disc {
  Point centre;
  double radius = 0;
};

/// The angles from `low` to `high`, counter-clockwise, radians; high - low is at most 2 pi.
struct AngleSpan {
  double low = 0;
  double high = 0;

  double width() const { return high - low; }
};

/// The angles within `half` of `middle`: none when half is negative, all when it is pi or more.
struct AngleRange {
  double middle = 0;
  double half = -1;
};

/// Where a line crosses a circle. The same line gives the same bits, whichever two of its directions it is given in.
struct Chord {
  Point foot;         ///< The line's point nearest to the centre.
  Point along;        ///< Unit vector, from the lesser to the greater of the two given points.
  double offset = 0;  ///< The signed distance of the centre from the line, positive to the left of `along`.
  double half = 0;    ///< From the foot to either crossing, metres; 0 when there is none.
  bool crosses = false;

  Point entry() const { return foot - half * along; }
  Point exit() const { return foot + half * along; }
};
Chord ChordOf(const Disc& disc, Point a, Point b);

/// The part of the disc's circle to the left of the line from a to b, a != b.
AngleRange LeftOfLine(const Disc& disc, Point a, Point b);

/// The part of the disc's circle inside the closed disc `other`. About one centre, the larger covers the smaller; of
/// equals, `wins_tie` says whether `other` does.
AngleRange InsideDisc(const Disc& disc, const Disc& other, bool wins_tie);

/// The parts of the spans that lie within the range.
std::vector<AngleSpan> Intersect(std::span<const AngleSpan> spans, const AngleRange& range);

/// The parts of `span` that none of the covers hold. Gaps between covers, and remainders, narrower than `least` are
/// dropped: they are rounding. O(n log n).
std::vector<AngleSpan> Uncovered(const AngleSpan& span, std::vector<AngleSpan> covers, double least);

Point PointAt(const Disc& disc, double angle);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_CIRCLE_SPAN_H_
