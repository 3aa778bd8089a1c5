// How a robot drives along a straight piece of its path: at constant speed, or from rest to rest.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_SPEED_PROFILE_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_SPEED_PROFILE_H_

#include <optional>

namespace tautline {

/// Distance and speed over time along one piece, from time 0 at distance 0 to its end. Without an acceleration the
/// speed is constant. With one the robot starts and ends at rest: it speeds up to its cruise speed, keeps it, and slows
/// down; on a short piece it slows down as soon as it is half way.
class SpeedProfile {
 public:
  /// Requires length >= 0, cruise > 0 (metres per second) and a positive acceleration (metres per second squared).
  SpeedProfile(double length_m, double cruise, std::optional<double> acceleration);

  /// Where the robot is at a time, and how fast it drives.
  struct State {
    double distance = 0;  ///< Metres.
    double speed = 0;     ///< Metres per second.
  };

  /// At `t_s` seconds, between 0 and the duration; both ends are limits. A piece of no length has speed 0.
  State At(double t_s) const;

  /// The state at a distance, between 0 and the length; both ends are limits.
  State AtDistance(double distance_m) const;

  /// When the robot is there, seconds.
  double TimeAt(double distance_m) const;

  double length_m() const { return length_m_; }      ///< Of the piece.
  double duration_s() const { return duration_s_; }  ///< From end to end.
  double top_speed() const { return top_speed_; }    ///< The greatest, metres per second.

 private:
  double length_m_;
  std::optional<double> acceleration_;
  double top_speed_ = 0;
  double ramp_s_ = 0;  ///< How long it takes to reach the top speed from rest.
  double ramp_m_ = 0;  ///< On which distance.
  double duration_s_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_SPEED_PROFILE_H_
