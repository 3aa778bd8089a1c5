#include "tautline/cable/cable_chain.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// How far a link may be stretched where the passes have not come to their end, of its length.
constexpr double kStretch = 0.05;

/// The point at `length_m` from `from` towards `to`; due east where they coincide.
Point Towards(Point from, Point to, double length_m) {
  const Point way = to - from;
  const double squared = Dot(way, way);
  return squared > 0 ? from + (length_m / std::sqrt(squared)) * way : from + Point{length_m, 0};
}

/// Nodes one link apart in a straight line each, from the tail back to the base; the base is last.
std::vector<Point> ChainBackwards(std::span<const Point> laid, double link_m) {
  std::vector<Point> nodes = {laid.back()};
  Point from = laid.back();
  for (std::size_t k = laid.size() - 1; k-- > 0;) {
    const Point to = laid[k];
    // Where the segment leaves the circle around the last node.
    while (Distance(nodes.back(), to) > link_m) {
      const Point along = to - from, off = from - nodes.back();
      const double a = Dot(along, along), b = Dot(along, off), c = Dot(off, off) - link_m * link_m;
      if (a == 0) break;
      const double t = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
      from = Lerp(from, to, std::clamp(t, 0.0, 1.0));
      nodes.push_back(from);
    }
    from = to;
  }
  if (nodes.size() > 1 && nodes.back() == laid.front()) return nodes;
  nodes.push_back(laid.front());
  return nodes;
}

/// What is left of a pull where the base takes back most of it is pulled for again by no more than the inverse of this.
constexpr double kLeastGain = 0.1;

}  // namespace

CableChain::CableChain(std::span<const Point> laid, const CableChainOptions& options) : options_(options) {
  TAUTLINE_CHECK(!laid.empty() && options.link_length_m > 0);
  nodes_ = ChainBackwards(laid, options.link_length_m);
  std::reverse(nodes_.begin(), nodes_.end());
  first_link_m_ = std::min(Distance(nodes_[0], nodes_[1]), options.link_length_m);
}

bool CableChain::Pull(Point to) {
  if (Distance(base(), to) > options_.length_m) return false;
  before_ = nodes_;
  const double first_before = first_link_m_;
  Point pull = to - tail();
  for (int round = 0; round < options_.max_rounds; ++round) {
    const Point from = tail();
    FollowTail(from + pull);
    if (PayOut()) {
      if (round == 0) return true;
      break;
    }
    FollowBase();
    const Point left = to - tail();
    const double squared = Dot(pull, pull);
    if (Norm(left) <= options_.tolerance_m || squared == 0) break;
    // The base takes back a share of each pull: pull by as much more.
    pull = (1 / std::clamp(Dot(tail() - from, pull) / squared, kLeastGain, 1.0)) * left;
  }
  // Rods that are folded may be stuck: the last one is then shorter for a while.
  const std::size_t last = nodes_.size() - 1;
  const double last_link_m = last > 1 ? options_.link_length_m : first_link_m_;
  if (Distance(nodes_[last - 1], to) <= (1 + kStretch) * last_link_m) {
    nodes_.back() = to;
    return true;
  }
  nodes_ = before_;
  first_link_m_ = first_before;
  return false;
}

void CableChain::FollowTail(Point to) {
  nodes_.back() = to;
  for (std::size_t i = nodes_.size() - 1; i-- > 1;) {
    nodes_[i] = Towards(nodes_[i + 1], nodes_[i], options_.link_length_m);
  }
}

bool CableChain::PayOut() {
  const double needed = Distance(base(), nodes_[1]);
  if (needed <= first_link_m_ + options_.tolerance_m) return true;
  const double link = options_.link_length_m;
  const double on_reel = std::max(0.0, options_.length_m - paid_out_m());
  const bool enough = needed - first_link_m_ <= on_reel;
  first_link_m_ += std::min(needed - first_link_m_, on_reel);
  while (first_link_m_ > link) {
    const Point entered = Towards(nodes_[1], base(), link);
    nodes_.insert(nodes_.begin() + 1, entered);
    first_link_m_ -= link;
  }
  return enough;
}

void CableChain::FollowBase() {
  nodes_[1] = Towards(nodes_[0], nodes_[1], first_link_m_);
  for (std::size_t i = 2; i < nodes_.size(); ++i) {
    nodes_[i] = Towards(nodes_[i - 1], nodes_[i], options_.link_length_m);
  }
}

}  // namespace tautline
