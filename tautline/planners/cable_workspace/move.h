// The motion of the robot to a goal inside its workspace, and what each winch does meanwhile [Wang2018, Sec. V].
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVE_H_

#include <optional>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/planners/cable_workspace/cable_sections.h"
#include "tautline/planners/cable_workspace/region_path.h"
#include "tautline/planners/cable_workspace/speed_profile.h"

namespace tautline {

/// How the robot drives.
struct MoveOptions {
  double speed = 1;                         ///< The most, metres per second.
  std::optional<double> acceleration = {};  ///< Metres per second squared; absent: constant speed.
  std::vector<double> winch_limits = {};    ///< The most that a winch reels in or pays out, metres per second: one
                                            ///< number for all or one per winch; empty: no limit.
};

/// A straight piece of the way.
struct MovePiece {
  Point from;                                     ///< Where it starts.
  Point to;                                       ///< Where it ends.
  double begin_m = 0;                             ///< Of the piece, along the path.
  double begin_s = 0;                             ///< When it starts.
  SpeedProfile profile;                           ///< How it is driven.
  std::vector<std::vector<CableSection>> cables;  ///< By winch.
};

/// A cable changes the corner from which it runs straight to the robot.
struct CornerSwitch {
  double t_s = 0;          ///< When.
  std::size_t anchor = 0;  ///< Whose cable.
  Point from;              ///< The corner before.
  Point to;                ///< The corner from then on.
  std::size_t piece = 0;   ///< In which piece; at a corner of the path in the one after it.
  double distance_m = 0;   ///< Where in that piece.
};

/// A motion.
struct Move {
  TautPath path;                       ///< Of the robot.
  std::vector<MovePiece> pieces;       ///< One after the other; one of no length where start and goal are one place.
  std::vector<CornerSwitch> switches;  ///< By time, then winch.
  double duration_s = 0;               ///< From start to goal.
  std::optional<Point> outside;        ///< The first place at which the path leaves the workspace, see FirstOutside.
};

/// The robot and its cables at one moment.
struct MoveSample {
  double t_s = 0;               ///< When.
  Point robot;                  ///< Where.
  double speed = 0;             ///< Metres per second.
  std::vector<double> lengths;  ///< By winch: of its cable with the stub, metres.
  std::vector<double> rates;    ///< By winch: how fast it pays out, metres per second; negative where it reels in. The
                                ///< paper counts towards the winch, with the opposite sign.
  std::vector<Point> corners;   ///< By winch: where its cable runs to from the robot.
};

/// The taut cables of the robot in one piece of a motion, at a distance from its start: by winch, from its exit to the
/// robot.
std::vector<Polyline> CablesAt(const Move& move, std::size_t piece, double distance_m);

/// Whether options can be meant for so many winches. Errors: a number is not positive and finite; neither one limit nor
/// one per winch.
[[nodiscard]] Expected<void> CheckMoveOptions(const MoveOptions& options, std::size_t anchors);

/// The shortest motion of the robot from start to goal in the workspace, each cable taut all the time. Every straight
/// piece is driven as its profile says, as fast as all limits allow on all of it: the speed is `speed`, or less by what
/// the fastest winch of that piece would exceed its limit. With an acceleration the robot halts at each corner of the
/// path, since it could not turn there at speed. Requires options that CheckMoveOptions accepts. Errors: kStartOutside,
/// kGoalOutside. Cost: a taut curve per pair of ways, and one per winch and corner of the path.
tl::expected<Move, OutsideFault> PlanMove(const WorkspaceRegion& region, Point start, Point goal,
                                          const MoveOptions& options = {});

/// The robot in one piece of a motion, at a distance from its start. In a constant speed the rates are those of
/// this piece at its ends too. O(winches * sections).
MoveSample SampleAt(const Move& move, std::size_t piece, double distance_m);

/// A motion moment by moment: at every multiple of `dt_s`, and also wherever the path turns, a cable switches, and at
/// the end. Where the path turns at constant speed the rates jump: they are then those of the piece that begins.
/// Requires dt_s > 0. O(duration / dt_s).
std::vector<MoveSample> SampleMove(const Move& move, double dt_s);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_MOVE_H_
