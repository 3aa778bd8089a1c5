// A plan played: robots drive, taut cables are pushed and bend. It knows nothing of the planner's graphs.
#ifndef TAUTLINE_PLANNERS_FLEET_PLAYBACK_H_
#define TAUTLINE_PLANNERS_FLEET_PLAYBACK_H_

#include <optional>
#include <string>
#include <vector>

#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// What is played.
struct PlaybackOptions {
  /// At most this many moments for pictures, spread evenly over the motion; 0: none.
  int frames = 0;
  /// Carries ray words along as a second witness (homotopy/moving.h), for fleets up to this size.
  std::size_t words_up_to = 60;
  /// Cables are measured at this many moments times robots, at most; at all moments where there are fewer, and at the
  /// two ends of the motion in any case. What is measured takes most of the time of large fleets.
  std::size_t measured = 2'000'000;
  Watcher watch = {};  ///< Told how far the playback has come.
};

/// Robots and cables at a moment.
struct PlaybackFrame {
  double t = 0;                  ///< s.
  std::vector<Point> robots;     ///< By RobotId, metres.
  std::vector<Polyline> cables;  ///< By RobotId, taut, metres.
};

/// Two robots passed a crossing in the other order than was asked for.
struct BrokenOrder {
  RobotId first;   ///< Should have passed first.
  RobotId second;  ///< Passed before it.
  Point at;        ///< Where, metres.
};

/// The longest that a cable is during the motion.
struct LongestTether {
  double length = 0;  ///< Metres.
  double t = 0;       ///< When, s.
};

/// What came of a plan.
struct Playback {
  std::vector<Route> final_routes;     ///< The cables at the end, by RobotId.
  std::vector<RobotId> differing;      ///< The robots whose cables are not of the class of their cable lines.
  std::vector<BrokenOrder> broken;     ///< Orders that were not kept.
  std::vector<LongestTether> longest;  ///< By RobotId; at the moments when robots pass, start or stop.
  std::vector<PlaybackFrame> frames;   ///< In order of time.
  std::optional<bool> words_agree;     ///< Whether the words of the final cables say the same; absent: not asked.

  /// Whether the layout came out and every order was kept.
  bool matches() const { return differing.empty() && broken.empty() && words_agree.value_or(true); }
};

/// Robots that would meet at a point at one time, with no order between them.
struct PlaybackCollision {
  RobotId a;     ///< Who.
  RobotId b;     ///< And with whom.
  Point at;      ///< Where, metres.
  double t = 0;  ///< When, s.
};

/// Plays a schedule by RobotId. `passings` say who goes first where two robots come to a crossing at one time, and are
/// the orders to be kept. `layout` may be empty: then nothing differs. Errors: two robots meet where none goes first.
/// Throws Stopped when the watcher says stop. Cost: as TautStrings::Move for each crossing and bend.
tl::expected<Playback, PlaybackCollision> Play(const FleetGround& ground, const FleetLayout& layout,
                                               const std::vector<RobotSchedule>& schedule,
                                               const std::vector<Passing>& passings,
                                               const PlaybackOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PLAYBACK_H_
