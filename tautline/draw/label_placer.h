// Finds room for labels: what is drawn is entered as taken, and each label goes where it disturbs
// least.
#ifndef TAUTLINE_DRAW_LABEL_PLACER_H_
#define TAUTLINE_DRAW_LABEL_PLACER_H_

#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// All coordinates are pixels. Greedy: places are taken in the order of the calls.
class LabelPlacer {
 public:
  /// Labels should stand within `frame`.
  explicit LabelPlacer(const Box& frame) : frame_(frame) {}

  /// Marks room as taken by symbols or text.
  void Take(const Box& box) { taken_.push_back(box); }

  /// Marks room that a label should rather not, but may, cover.
  void Discourage(const Box& box) { discouraged_.push_back(box); }

  /// Marks a line, which a label should not cover.
  void TakeLine(std::span<const Point> line);

  /// How much a label in `box` disturbs: 0 in open ground; kOverlap and more on top of something
  /// taken or outside.
  double Cost(const Box& box) const;

  /// Where a label can stand.
  struct Place {
    Box box;          ///< The room of the label.
    double cost = 0;  ///< How much it disturbs there; see Cost.
  };

  /// The place for a label of `size` beside `around`: right, left, above, below, and at the
  /// corners, the first of those that disturb least. Not yet taken.
  Place FindBeside(const Box& around, Point size) const;

  /// The place among `centres` that disturbs least, when each costs `later` more than the one
  /// before it.
  Place FindAt(std::span<const Point> centres, Point size, double later = kTieBreak) const;

  static constexpr double kOverlap = 100;    ///< Cost of covering something taken.
  static constexpr double kCrossing = 20;    ///< Cost of covering a line.
  static constexpr double kTieBreak = 0.01;  ///< Cost by which earlier places are preferred.

 private:
  struct Segment {
    Point a;
    Point b;
  };

  Box frame_;
  std::vector<Box> taken_;
  std::vector<Box> discouraged_;
  std::vector<Segment> lines_;
};

/// Whether two boxes share more than their edges.
bool Overlap(const Box& a, const Box& b);

/// Whether the closed segment ab meets the box.
bool Meets(const Box& box, Point a, Point b);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_LABEL_PLACER_H_
