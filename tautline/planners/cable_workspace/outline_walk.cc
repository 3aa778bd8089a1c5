#include "tautline/planners/cable_workspace/outline_walk.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {

OutlineWalk::OutlineWalk(Ring ring) : ring_(std::move(ring)) {
  TAUTLINE_CHECK(ring_.size() >= 3);
  double length = 0;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    starts_.push_back(length);
    length += Distance(ring_[i], ring_[(i + 1) % ring_.size()]);
    TAUTLINE_CHECK(length > starts_.back());
  }
  starts_.push_back(length);
}

double OutlineWalk::Wrapped(double position) const {
  const double rest = std::fmod(position, length());
  const double wrapped = rest < 0 ? rest + length() : rest;
  // A little less than nothing, plus the length, rounds to the length.
  return wrapped < length() ? wrapped : 0;
}

Point OutlineWalk::At(double position) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end() - 1, position);
  const std::size_t edge = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - starts_.begin(), 1)) - 1;
  const Point from = ring_[edge], to = ring_[(edge + 1) % ring_.size()];
  if (position <= starts_[edge]) return from;
  const double share = (position - starts_[edge]) / (starts_[edge + 1] - starts_[edge]);
  return share >= 1 ? to : from + share * (to - from);
}

std::optional<double> OutlineWalk::Beyond(Point from, Point through) const {
  const Point ahead = through - from;
  std::optional<double> position;
  double nearest = 0;
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Point edge = ring_[(i + 1) % ring_.size()] - ring_[i], to_edge = ring_[i] - through;
    const double turn = Cross(ahead, edge);
    if (turn == 0) continue;
    const double beyond = Cross(to_edge, edge) / turn, along = Cross(to_edge, ahead) / turn;
    if (!(beyond > 0 && along >= 0 && along <= 1) || (position && beyond >= nearest)) continue;
    nearest = beyond;
    position = Wrapped(starts_[i] + along * (starts_[i + 1] - starts_[i]));
  }
  return position;
}

double OutlineWalk::NextCorner(double position) const {
  const auto next = std::upper_bound(corners().begin(), corners().end(), position);
  return next == corners().end() ? 0 : *next;
}

double OutlineWalk::PreviousCorner(double position) const {
  const auto here = std::lower_bound(starts_.begin(), starts_.end() - 1, position);
  return here == starts_.begin() ? corners().back() : *(here - 1);
}

}  // namespace tautline
