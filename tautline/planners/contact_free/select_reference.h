// The choice of the reference path: the shortest class from the robot to the goal whose tether fits.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_SELECT_REFERENCE_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_SELECT_REFERENCE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/homotopy/socket.h"
#include "tautline/homotopy/taut_ground.h"
#include "tautline/planners/contact_free/reference_path.h"

namespace tautline {

/// The world as the robot's centre has it: grown by the larger one of its radius and 2 %, so that the disc does not
/// touch along its edges, and the clearance. Errors: as
/// TautGround::Prepare, and a radius that is negative or not finite.
[[nodiscard]] Expected<TautGround> PrepareRobotGround(World world, double robot_radius_m, const Watcher& watch = {});

/// Where the robot is, where it shall go, and its cable.
struct ReferenceTask {
  Polyline laid;              ///< From the base to the robot's centre, metres; one point: the robot stands at the base.
  double cable_length_m = 0;  ///< All of it; taken to end at the robot's centre.
  Point goal;                 ///< For the robot's centre.
};

/// The laid cable in the ground of the robot's centre.
struct LaidTether {
  Socket base;   ///< Where the cable comes out of its socket, if it is tied in one.
  Socket robot;  ///< Where the robot comes out, if it stands in one; the exits are one if it stands at the base.
  Walk walk;     ///< From the one exit to the other, in the class of the cable.

  /// The cable pulled taut.
  TautPath Pull(const TautSpace& space) const { return TetherAlong(space, walk); }
  /// The stub of the base's socket, and a walk from its exit pulled taut.
  TautPath TetherAlong(const TautSpace& space, const Walk& from_exit) const;
  /// A path from where the robot comes out, led on from where it stands.
  TautPath PathFromRobot(const TautSpace& space, Polyline from_exit) const;
  /// The start of any tether that can take this one's place.
  Walk Root() const;
};

/// How it ended.
enum class ReferenceOutcome {
  kFound,             ///< There is a reference path.
  kStartBlocked,      ///< Base or robot stands in blocked ground.
  kLaidCableBlocked,  ///< The cable lies in a class that the robot's centre could not have drawn it into.
  kGoalBlocked,       ///< The goal lies in blocked ground, or too near to it for the robot.
  kGoalUnreachable,   ///< No free path leads to it.
  kTetherTooShort,    ///< No class has a tether that fits.
  kBudgetExceeded,    ///< The search gave up; nothing is proved.
};

/// The name of an outcome in results: "goal_unreachable"; empty for kFound.
std::string ToString(ReferenceOutcome outcome);

/// A class from the robot to the goal.
struct ReferenceCandidate {
  TautPath path;                   ///< From the robot to the goal.
  Word tether_word;                ///< Of laid cable and path.
  std::optional<TautPath> tether;  ///< The taut one of that class; absent where the paper's dictionary lacks it.
  bool fits = false;               ///< The tether is known and no longer than the cable.
};

/// The reference, or why there is none.
struct ReferenceSelection {
  ReferenceOutcome outcome = ReferenceOutcome::kFound;  ///< How it ended.
  std::optional<ReferencePath> reference;               ///< For kFound.
  /// The shortest classes, as many as were asked for; the paper's way lists all that it knows.
  std::vector<ReferenceCandidate> candidates;
  bool all_listed = false;                  ///< There are no other classes.
  std::optional<TautPath> shortest_tether;  ///< For kTetherTooShort: over all classes that the method knows.
  std::string explanation;                  ///< One sentence with the numbers where there is no reference.
};

/// How hard to search.
struct SelectReferenceOptions {
  std::int64_t list = 0;            ///< How many of the shortest classes to list.
  std::int64_t budget = 5'000'000;  ///< Search states after which to give up.
  KeepGoing keep_going = {};        ///< Asked now and then; at a no the search ends with kBudgetExceeded.
};

/// The shortest path to the goal over all classes whose taut tether at the goal fits the cable [Shimada2024, Alg. 2],
/// decided by the exact engine, complete: no path is found only where none exists. A laid cable that leaves the grown
/// ground, as one that has slid does, has the class of its word. As a rule ChooseClass finds the class without listing
/// those before it; where the cable as laid is too long already, all tethers that fit are looked at.
/// Requires finite points, a cable length that is finite and not negative, and a laid cable of a point or more.
ReferenceSelection SelectReference(const TautGround& ground, const ReferenceTask& task,
                                   const SelectReferenceOptions& options = {});

/// The laid cable of a task, or why it cannot lie so; `explanation` tells then. Never kFound without a value.
struct FollowedTether {
  std::optional<LaidTether> laid;                              ///< The cable.
  ReferenceOutcome outcome = ReferenceOutcome::kStartBlocked;  ///< Without one: why.
  std::string explanation;                                     ///< In a sentence.
};

/// Finds the class of a laid cable in the ground of the robot's centre.
FollowedTether FollowTether(const TautGround& ground, const Polyline& laid);

/// "the cable of 8 m is 1.2 m too short: ...; choose another goal": what a user is told where no tether fits.
std::string ExplainTetherTooShort(const TautSpace& space, const TautPath& shortest, double cable_length_m);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_SELECT_REFERENCE_H_
