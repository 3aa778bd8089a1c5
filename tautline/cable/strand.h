// A piece of string between two points of the free space, pulled tight in its class.
#ifndef TAUTLINE_CABLE_STRAND_H_
#define TAUTLINE_CABLE_STRAND_H_

#include <vector>

#include "tautline/homotopy/free_mesh.h"
#include "tautline/homotopy/taut.h"

namespace tautline {

/// The taut curve between two points whose places are kept elsewhere. Its class is a sleeve, never a place, so no
/// rounding can lift it over an obstacle.
struct Strand {
  /// The strand that stays in a triangle.
  explicit Strand(TriangleId triangle) : sleeve{triangle} {}

  std::vector<TriangleId> sleeve;  ///< From the triangle of its first end to that of its second, never back at once.
  std::vector<TautPoint> bends;    ///< The corners that hold it, in order; most strands have none.
  double length = 0;               ///< Metres.

  /// The second end steps to a neighbouring triangle, or stays. The curve is out of date until PullTight. O(1).
  void StepSecond(TriangleId next);
  /// The same for the first end. O(sleeve).
  void StepFirst(TriangleId next);
};

/// Brings bends and length up to date after an end has moved. Requires `first` and `second` in the closed triangles at
/// the ends of the sleeve. Exact but for the length. O(sleeve), and without allocation where the strand is straight.
void PullTight(const FreeMesh& mesh, Point first, Point second, Strand& strand);

/// The strand of a walk, up to date. Requires `taut` == PullTaut of it. O(size of both).
Strand StrandOf(const Walk& walk, const TautCurve& taut);

/// Joins two strands at the point that they share, `other` after `strand`. Out of date until PullTight. O(other).
void Join(Strand& strand, const Strand& other);

/// The point of a triangle's closed region nearest to p, as far as rounding matters: p itself where it is inside, else
/// p moved inwards by the least share that does. For points that rounding has put beside the triangle they lie in.
Point MoveInto(const FreeMesh& mesh, TriangleId triangle, Point p);

/// Goes along a strand from its first end. Requires that the strand is up to date and stays as it is.
class StrandCursor {
 public:
  /// At the first end.
  StrandCursor(const FreeMesh& mesh, Place first, Place second, const Strand& strand)
      : mesh_(mesh), strand_(strand), first_(first.point), second_(second), place_(first) {}

  /// Goes on to arc length s, metres; beyond the second end it stops there. Requires s no less than before. O(what it
  /// passes).
  void MoveTo(double s);

  /// Where it stands: exactly in the closed triangle.
  const Place& place() const { return place_; }
  /// The position of that triangle in the sleeve.
  std::size_t position() const { return position_; }
  /// How many bends it has passed or stands on.
  std::size_t bends_passed() const { return bends_passed_; }

 private:
  /// The first end, the bends, the second end.
  Point Knot(std::size_t i) const {
    return i == 0 ? first_ : i <= strand_.bends.size() ? strand_.bends[i - 1].point : second_.point;
  }
  bool HasPassed(std::size_t portal, double share);

  const FreeMesh& mesh_;
  const Strand& strand_;
  Point first_;
  Place second_;
  Place place_;
  std::size_t position_ = 0;
  std::size_t bends_passed_ = 0;
  double passed_m_ = 0;        ///< Arc length of the point that the present straight piece starts from.
  Point from_ = place_.point;  ///< That point.
  std::size_t knot_ = 0;       ///< The knot that the portals have come to.
  bool at_knot_ = true;        ///< The last portal ends in that knot; at first, the first end is one.
};

/// The first end slides along the strand by `by` metres, and `before`, the strand that ends there, follows with its
/// second end. `first` becomes its new place. Only `strand` is up to date afterwards. Null: nothing is tied there.
void SlideFirst(const FreeMesh& mesh, Place& first, Place second, double by, Strand& strand, Strand* before);

/// The same for the second end, which slides back along the strand; `after` starts there.
void SlideSecond(const FreeMesh& mesh, Place first, Place& second, double by, Strand& strand, Strand* after);

}  // namespace tautline

#endif  // TAUTLINE_CABLE_STRAND_H_
