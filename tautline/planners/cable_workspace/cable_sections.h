// How the taut cable of a robot on a straight way changes: its length in closed form, corner by corner.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_SECTIONS_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_SECTIONS_H_

#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// A part of a straight way on which the cable runs straight to the robot from one corner. Distances are metres along
/// the way.
struct CableSection {
  Polyline via;          ///< The taut cable from its exit to the corner; from there it runs straight to the robot.
  Point corner;          ///< The switching corner: where the cable bends last, or where it starts. The end of `via`.
  double to_corner = 0;  ///< The length of the cable from the winch to the corner.
  double along = 0;      ///< Of the corner's foot on the line of the way.
  double off = 0;        ///< How far the corner is from that line, at least 0.
  double begin = 0;      ///< Of the part.
  double end = 0;        ///< Of the part.

  /// The length of the cable when the robot is at a distance.
  double LengthAt(double distance) const;

  /// Its derivative by the distance: from -1, the robot drives towards the corner, to 1. At the corner itself the
  /// limit from within the section.
  double SlopeAt(double distance) const;
};

/// The two taut cables at the ends of a straight way of the robot.
struct CableEnds {
  std::span<const Point> before;  ///< From the winch's exit to the start of the way, taut.
  std::span<const Point> after;   ///< From the same to the end of the way, taut, in the class that the way leads to.
  double stub_length = 0;         ///< Between the winch and its exit.
};

/// The sections of a way, in order, from 0 to its length; at least one. The cables share a part, and then form with the
/// way a triangle with sides that bend inwards [Wang2018, Sec. V-B]. Where the edges of these sides, prolonged, hit the
/// way, the corner switches; the slope is continuous there and grows along the whole way, since the taut length is
/// convex. A corner on the way itself splits its section: the slope jumps from -1 to 1. O(corners^2).
std::vector<CableSection> CableSections(const CableEnds& cables);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_CABLE_SECTIONS_H_
