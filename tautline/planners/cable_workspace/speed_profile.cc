#include "tautline/planners/cable_workspace/speed_profile.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"

namespace tautline {

SpeedProfile::SpeedProfile(double length_m, double cruise, std::optional<double> acceleration)
    : length_m_(length_m), acceleration_(acceleration) {
  TAUTLINE_CHECK(length_m >= 0 && cruise > 0 && (!acceleration || *acceleration > 0));
  if (length_m == 0) return;
  top_speed_ = cruise;
  if (!acceleration) {
    duration_s_ = length_m / cruise;
    return;
  }
  top_speed_ = std::min(cruise, std::sqrt(length_m * *acceleration));
  ramp_s_ = top_speed_ / *acceleration;
  ramp_m_ = std::min(0.5 * top_speed_ * ramp_s_, 0.5 * length_m);
  duration_s_ = 2 * ramp_s_ + (length_m - 2 * ramp_m_) / top_speed_;
}

SpeedProfile::State SpeedProfile::At(double t_s) const {
  if (length_m_ == 0) return {};
  const double t = std::clamp(t_s, 0.0, duration_s_), left = duration_s_ - t;
  if (t < ramp_s_ && t <= left) return {0.5 * *acceleration_ * t * t, *acceleration_ * t};
  if (left < ramp_s_) return {length_m_ - 0.5 * *acceleration_ * left * left, *acceleration_ * left};
  return {left == 0 ? length_m_ : std::min(ramp_m_ + (t - ramp_s_) * top_speed_, length_m_), top_speed_};
}

SpeedProfile::State SpeedProfile::AtDistance(double distance_m) const {
  const double distance = std::clamp(distance_m, 0.0, length_m_), left = length_m_ - distance;
  if (distance < ramp_m_ && distance <= left) return {distance, std::sqrt(2 * *acceleration_ * distance)};
  if (left < ramp_m_) return {distance, std::sqrt(2 * *acceleration_ * left)};
  return {distance, top_speed_};
}

double SpeedProfile::TimeAt(double distance_m) const {
  if (length_m_ == 0) return 0;
  const double distance = std::clamp(distance_m, 0.0, length_m_), left = length_m_ - distance;
  if (distance < ramp_m_ && distance <= left) return std::sqrt(2 * distance / *acceleration_);
  if (left < ramp_m_) return duration_s_ - std::sqrt(2 * left / *acceleration_);
  return std::min(ramp_s_ + (distance - ramp_m_) / top_speed_, duration_s_);
}

}  // namespace tautline
