// The pictures of fleets: layouts of cable lines, plans, what a plan comes to, and a film of it.
#ifndef TAUTLINE_DRAW_DRAW_FLEET_H_
#define TAUTLINE_DRAW_DRAW_FLEET_H_

#include <string>
#include <vector>

#include "tautline/planners/fleet/fleet_plan.h"
#include "tautline/planners/fleet/playback.h"

namespace tautline {

/// A place of a layout that the picture rings.
struct LayoutMark {
  Point at;          ///< Where, metres.
  std::string text;  ///< What is wrong there, a few words: "r1 and r2 cross".
};

/// What the picture of a layout shows.
struct LayoutPicture {
  std::string title;               ///< The answer in words.
  std::vector<std::string> notes;  ///< Sentences below it.
  /// The cable lines; absent where they are faulty: then they are drawn as the scene has them. Empty: none are drawn.
  const FleetLayout* layout = nullptr;
  std::vector<LayoutMark> marks;  ///< Ringed; of many only the first have their text on the map.
};

/// The cable lines beside each other where they share edges, with starts and targets, and what is wrong ringed. As SVG,
/// as all of these. Deterministic.
std::string DrawLayout(const Scene& scene, const FleetGround& ground, const LayoutPicture& picture);

/// What the picture of several layouts shows.
struct LayoutsPicture {
  std::string title;                        ///< The answer in words.
  std::vector<std::string> notes;           ///< Sentences below it.
  std::vector<const FleetLayout*> layouts;  ///< The first kMostLayoutsDrawn are drawn.
};

inline constexpr std::size_t kMostLayoutsDrawn = 12;  ///< Small maps on one page.

/// Small maps of layouts with their total length. Requires a layout. Deterministic.
std::string DrawLayouts(const Scene& scene, const FleetGround& ground, const LayoutsPicture& picture);

/// What the picture of a plan shows.
struct FleetPlanPicture {
  const FleetLayout& layout;            ///< That comes out.
  const FleetPlan& plan;                ///< How.
  std::vector<std::string> notes = {};  ///< Sentences besides those about modes and detours.
};

/// The layout; the paths with their crossings and who passes first; both interaction graphs; the schedule with its
/// waits. Graphs of more than kMostInGraphs robots, and labels where there are too many, are left out. Deterministic.
std::string DrawFleetPlan(const Scene& scene, const FleetGround& ground, const FleetPlanPicture& picture);

inline constexpr std::size_t kMostInGraphs = 12;  ///< Robots.

/// What the picture of a playback shows.
struct SimulatePicture {
  const FleetLayout& layout;  ///< That was to come out; may be empty.
  const Playback& playback;   ///< What came out.
};

/// The cables at the end over the cable lines that they were to become, differences red and dashed, and the crossings
/// that were passed in the wrong order. Deterministic.
std::string DrawSimulate(const Scene& scene, const FleetGround& ground, const SimulatePicture& picture);

/// How many moments make a film of so many robots: fewer of more robots, so that files stay small.
int FilmFrames(std::size_t robots);

/// What a film of a plan shows.
struct FleetFilm {
  const FleetLayout& layout;                 ///< Drawn pale; may be empty.
  const FleetPlan& plan;                     ///< That is played; of a motion without a plan, its schedule and time.
  const std::vector<PlaybackFrame>& frames;  ///< In order of time, at least one.
  std::string title = {};                    ///< Empty: what the plan takes.
};

/// A picture that moves in every browser, over and over: robots drive, taut cables bend around those that push them,
/// and a line runs over the schedule. Viewers without animation show the end. Deterministic.
std::string AnimateFleet(const Scene& scene, const FleetGround& ground, const FleetFilm& film);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_FLEET_H_
