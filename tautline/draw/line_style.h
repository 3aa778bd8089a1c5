// The look of every kind of line: colour, width and pattern all differ, so that a picture survives
// grey printing and colour blindness (colours after [Okabe2008]).
#ifndef TAUTLINE_DRAW_LINE_STYLE_H_
#define TAUTLINE_DRAW_LINE_STYLE_H_

#include <string>

namespace tautline {

struct LineStyle {
  std::string colour = "#1a1a1a";
  double width = 1.5;   ///< Pixels, with its casing.
  std::string casing;   ///< Colour of a thin edge on both sides; "": none.
  std::string dashes;   ///< Lengths of dashes and gaps, pixels; "": solid.
  bool wavy = false;    ///< Drawn as a wave about the line: slack cable.
  bool arrows = false;  ///< With arrow heads along its direction.
};

/// The lines of a plan from the widest to the narrowest: where they share an edge, each still shows
/// beside the next.
inline const LineStyle kGoalTetherLine = {.colour = "#f7c65b", .width = 10, .casing = "#8f6400"};
inline const LineStyle kStartTetherLine = {.colour = "#8fd9bf", .width = 6, .casing = "#00684c"};
inline const LineStyle kPathLine = {.colour = "#0b4a8f", .width = 2.2, .arrows = true};
inline const LineStyle kLaidLine = {.colour = "#333333", .width = 1.3, .wavy = true};
inline const LineStyle kRejectedLine = {.colour = "#b8400a", .width = 2, .dashes = "10 4 2 4"};
inline const LineStyle kForbiddenLine = {.colour = "#b8400a", .width = 4, .dashes = "4 3"};
inline const LineStyle kTautLine = {.colour = "#0b4a8f", .width = 3};
inline const LineStyle kReachLine = {.colour = "#0b4a8f", .width = 2.4};
inline const LineStyle kSheetLine = {.colour = "#0b4a8f", .width = 0.7, .dashes = "4 2"};
inline const LineStyle kOtherClassLine = {.colour = "#9a9a9a", .width = 0.9};
inline const LineStyle kRayLine = {.colour = "#7a7a7a", .width = 0.9, .dashes = "1.5 3"};

/// The ground.
inline constexpr char kFreeColour[] = "#ffffff";
inline constexpr char kBlockedColour[] = "#b9bec5";
inline constexpr char kBoundaryColour[] = "#4b5057";
inline constexpr char kClearanceColour[] = "#eef0f2";
inline constexpr char kClearanceLineColour[] = "#cfd3d8";

/// Text and symbols.
inline constexpr char kInkColour[] = "#1a1a1a";
inline constexpr char kSecondaryInkColour[] = "#555555";
inline constexpr char kWarningColour[] = "#b8400a";
inline constexpr char kHaloColour[] = "#ffffff";
inline constexpr char kBlockedHaloColour[] = "#d3d7dc";  ///< Of text that stands on blocked ground.

/// The style of the class with position `rank` (from 0) among `count` shown ones: dark and solid to
/// light and dashed.
LineStyle ClassLine(int rank, int count);

/// A pale colour for the component with position `rank` (from 1; the largest, 0, is kFreeColour).
std::string ComponentTint(int rank);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_LINE_STYLE_H_
