// In which order the robots of a playback pass where their tracks meet. Internal to the playback.
#ifndef TAUTLINE_PLANNERS_FLEET_PASSING_ORDER_H_
#define TAUTLINE_PLANNERS_FLEET_PASSING_ORDER_H_

#include <cstddef>
#include <tl/expected.hpp>
#include <vector>

#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/track_crossings.h"

namespace tautline {

/// A place on a robot's way where its track meets others.
struct Meeting {
  RobotId robot;                   ///< Whose.
  double along = 0;                ///< Of the first crossing there, metres; all are one up to rounding.
  double last = 0;                 ///< Of the last.
  double t = 0;                    ///< When the robot has passed, s.
  std::vector<std::size_t> after;  ///< Meetings that come later.
  std::size_t waits_for = 0;       ///< How many come earlier.
};

/// Whose moments and places count as one.
struct Closeness {
  double moment = 0;  ///< s.
  double place = 0;   ///< Metres; rounding is below it.
  double event = 0;   ///< Metres; a robot as near as that to where an event of its schedule happens is there.
};

/// When a robot has passed a place of its way, s: where it waits there, when it goes on. O(log n) for n events.
double PassingTime(const RobotSchedule& schedule, double along, const Closeness& close);

/// How far a robot has come at a time, metres. O(log n) for n events.
double AlongAt(const RobotSchedule& schedule, double t);

/// All meetings, each after those that it waits for, by the times of the schedule; of two robots that pass at one
/// moment, the one goes first that `passings` say. Times do not decrease in the list. Errors: two pass at one moment
/// with no order between them; a robot drives over the base of another, or over one that has arrived; robots wait for
/// each other in a circle at one moment (then both are one of these). O(c log c) for c crossings.
tl::expected<std::vector<Meeting>, PlaybackCollision> SortMeetings(const std::vector<Track>& tracks,
                                                                   const std::vector<RobotSchedule>& schedule,
                                                                   const std::vector<Passing>& passings,
                                                                   const Closeness& close);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PASSING_ORDER_H_
