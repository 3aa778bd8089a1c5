// Whether curves between points of a rectangle's boundary cross, by their words alone: a slow oracle, for tests only.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_WORD_CROSSING_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_WORD_CROSSING_H_

#include <span>
#include <utility>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// A rectangle cut open along the upward rays of points in it: a disc, whose copies, glued along the sides of the rays,
/// are the universal cover of the rectangle without the points. A curve between two points of the rectangle's boundary
/// is a chain of chords of such discs, one more than its word has letters.
class WordCrossing {
 public:
  /// `representatives` by letter.
  WordCrossing(const Box& rectangle, std::span<const Point> representatives)
      : box_(rectangle), representatives_(representatives.begin(), representatives.end()) {}

  /// A curve between two points of the rectangle's boundary.
  struct Curve {
    Point from;
    Point to;
    Word word;

    Curve Reversed() const { return {to, from, word.Inverse()}; }
  };

  /// Whether two curves cross in every way to draw them; with one curve twice: whether it crosses itself.
  bool Cross(const Curve& a, const Curve& b) const {
    return CrossInOneDirection(ChordsOf(a), ChordsOf(b)) || CrossInOneDirection(ChordsOf(a), ChordsOf(b.Reversed()));
  }

 private:
  /// A place on the disc's boundary, counter-clockwise from the upper right corner: how far along, and among what
  /// stands at one place.
  using Spot = std::pair<double, int>;
  struct Chord {
    Spot in, out;
  };

  Spot SpotOf(Point p) const {
    const Point size = box_.size();
    if (p.y == box_.high.y) return {box_.high.x - p.x, -1};
    if (p.x == box_.low.x) return {size.x + box_.high.y - p.y, -1};
    if (p.y == box_.low.y) return {size.x + size.y + p.x - box_.low.x, -1};
    return {2 * size.x + size.y + p.y - box_.low.y, -1};
  }

  /// A side of a ray. Points in its column are to the right of it, and so are rays of larger letters.
  Spot SideOf(ObstacleId ray, bool left) const {
    const int rank = static_cast<int>(representatives_.size() - ray.index());
    return {box_.high.x - representatives_[ray.index()].x, 2 * rank + (left ? 1 : 0)};
  }

  std::vector<Chord> ChordsOf(const Curve& curve) const {
    std::vector<Chord> chords;
    Spot in = SpotOf(curve.from);
    for (const Letter letter : curve.word.letters()) {
      chords.push_back({in, SideOf(letter.obstacle, !letter.inverse)});
      in = SideOf(letter.obstacle, letter.inverse);
    }
    chords.push_back({in, SpotOf(curve.to)});
    return chords;
  }

  /// Whether a comes before b, counter-clockwise from `from`.
  static bool Before(Spot from, Spot a, Spot b) {
    const bool a_wraps = a < from, b_wraps = b < from;
    return a_wraps != b_wraps ? b_wraps : a < b;
  }

  static bool CrossInOneDirection(const std::vector<Chord>& a, const std::vector<Chord>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t k = 0; k < b.size(); ++k) {
        if (i > 0 && k > 0 && a[i].in == b[k].in) continue;
        std::size_t m = 0;
        while (i + m + 1 < a.size() && k + m + 1 < b.size() && a[i + m].out == b[k + m].out) ++m;
        const Spot in_a = a[i].in, in_b = b[k].in, out_a = a[i + m].out, out_b = b[k + m].out;
        if (in_a == in_b || out_a == out_b || (m == 0 && (in_a == out_b || in_b == out_a))) continue;
        // Chords of one disc cross when they alternate.
        if (m == 0 && Before(out_a, in_b, in_a) != Before(out_a, out_b, in_a)) return true;
        // Else they part at both ends of what they share, and cross when the left one there is the right one here.
        // Ahead, the left comes first counter-clockwise; looking back, the right.
        if (m > 0 && Before(a[i].out, in_a, in_b) == Before(a[i + m].in, out_a, out_b)) return true;
      }
    }
    return false;
  }

  Box box_;
  std::vector<Point> representatives_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_WORD_CROSSING_H_
