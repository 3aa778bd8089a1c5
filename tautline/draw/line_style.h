// The look of every kind of line: colour, width and pattern all differ, so that a picture survives
// grey printing and colour blindness (colours after [Okabe2008]).
#ifndef TAUTLINE_DRAW_LINE_STYLE_H_
#define TAUTLINE_DRAW_LINE_STYLE_H_

#include <string>

namespace tautline {

/// How a line of a picture is drawn.
struct LineStyle {
  std::string colour = "#1a1a1a";  ///< A CSS colour.
  double width = 1.5;              ///< Pixels, with its casing.
  std::string casing;              ///< Colour of a thin edge on both sides; "": none.
  std::string dashes;              ///< Lengths of dashes and gaps, pixels; "": solid.
  bool wavy = false;               ///< Drawn as a wave about the line: slack cable.
  bool arrows = false;             ///< With arrow heads along its direction.
};

// The lines of a plan from the widest to the narrowest: where they share an edge, each still shows
// beside the next.

/// The tether at the goal.
inline const LineStyle kGoalTetherLine = {.colour = "#f7c65b", .width = 10, .casing = "#8f6400"};
/// The tether at the start, pulled taut.
inline const LineStyle kStartTetherLine = {.colour = "#8fd9bf", .width = 6, .casing = "#00684c"};
/// The robot's way.
inline const LineStyle kPathLine = {.colour = "#0b4a8f", .width = 2.2, .arrows = true};
/// The cable as it lies.
inline const LineStyle kLaidLine = {.colour = "#333333", .width = 1.3, .wavy = true};
/// The way that the tether forbids.
inline const LineStyle kRejectedLine = {.colour = "#b8400a", .width = 2, .dashes = "10 4 2 4"};
/// The way on which the cable would cross itself.
inline const LineStyle kCrossingLine = {.colour = "#7a2f8f", .width = 2, .dashes = "6 3"};
/// A tether that is too long.
inline const LineStyle kForbiddenLine = {.colour = "#b8400a", .width = 4, .dashes = "4 3"};
/// A taut curve.
inline const LineStyle kTautLine = {.colour = "#0b4a8f", .width = 3};
/// The boundary of what a tether reaches.
inline const LineStyle kReachLine = {.colour = "#0b4a8f", .width = 2.4};
/// The boundary of what it reaches in one class.
inline const LineStyle kSheetLine = {.colour = "#0b4a8f", .width = 0.7, .dashes = "4 2"};
/// The boundary of a workspace.
inline const LineStyle kWorkspaceLine = {.colour = "#00684c", .width = 2.6};
/// A taut cable that moves the robot.
inline const LineStyle kCableLine = {.colour = "#8f6400", .width = 2.2};
/// A side that is at fault.
inline const LineStyle kFaultLine = {.colour = "#b8400a", .width = 3.2, .dashes = "9 3"};
/// Classes beyond those that are numbered.
inline const LineStyle kOtherClassLine = {.colour = "#9a9a9a", .width = 0.9};
/// The ray of an obstacle.
inline const LineStyle kRayLine = {.colour = "#7a7a7a", .width = 0.9, .dashes = "1.5 3"};

// The ground.
inline constexpr char kFreeColour[] = "#ffffff";           ///< Free ground.
inline constexpr char kBlockedColour[] = "#b9bec5";        ///< Obstacles and walls.
inline constexpr char kBoundaryColour[] = "#4b5057";       ///< The boundary of obstacles and walls.
inline constexpr char kClearanceColour[] = "#eef0f2";      ///< What the clearance adds.
inline constexpr char kClearanceLineColour[] = "#cfd3d8";  ///< The hatching of what the clearance adds.

// Text and symbols.
inline constexpr char kInkColour[] = "#1a1a1a";           ///< Text and axes.
inline constexpr char kSecondaryInkColour[] = "#555555";  ///< Text of lesser weight.
inline constexpr char kWarningColour[] = "#b8400a";       ///< What is wrong or forbidden.
inline constexpr char kHaloColour[] = "#ffffff";          ///< Around text that stands on a drawing.
inline constexpr char kBlockedHaloColour[] = "#d3d7dc";   ///< Of text that stands on blocked ground.

/// The style of the class with position `rank` (from 0) among `count` shown ones: dark and solid to
/// light and dashed.
LineStyle ClassLine(int rank, int count);

/// A pale colour for the component with position `rank` (from 1; the largest, 0, is kFreeColour).
std::string ComponentTint(int rank);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_LINE_STYLE_H_
