// Symbols of a picture.
#ifndef TAUTLINE_DRAW_MARKER_H_
#define TAUTLINE_DRAW_MARKER_H_

#include <string>

#include "tautline/draw/svg_writer.h"

namespace tautline {

/// The symbols of pictures.
enum class Marker {
  kBase,       ///< A socket: where the tether is tied.
  kRobot,      ///< A disc: where the robot stands.
  kGoal,       ///< A flag, its foot on the goal.
  kPoint,      ///< A small ring: any other point.
  kBlocked,    ///< A forbidding sign: what cannot be there.
  kTetherEnd,  ///< A cross: where a tether ends.
  kSnap,       ///< A diamond: boundaries joined.
  kWinch,      ///< A drum: an anchor of a cable.
  kTask,       ///< A small square: a place to visit or to hold.
  kStart,      ///< A coloured square: where a robot of a fleet starts and is tied.
  kTarget,     ///< A coloured ring: where a robot of a fleet shall end.
  kCrossing,   ///< A dot: where two lines meet.
  kRing,       ///< A wide ring around something wrong.
  kStar,       ///< A star: a contact that locks the robot in.
};

/// Draws a symbol of about 16 pixels at a point. Only kStart and kTarget have the colour; "": that of text.
void DrawMarker(SvgWriter& svg, Marker marker, Point at, const std::string& colour = "");

/// The room that a symbol takes.
Box MarkerBox(Marker marker, Point at);

/// A number in a disc with a coloured edge.
void DrawBadge(SvgWriter& svg, const std::string& number, Point at, const std::string& colour);

inline constexpr double kBadgeRadius = 8.5;  ///< Pixels.

}  // namespace tautline

#endif  // TAUTLINE_DRAW_MARKER_H_
