// How a pull runs through the cable.
#include <algorithm>
#include <utility>

#include "tautline/cable/cable.h"

namespace tautline {
namespace {

/// A pull shorter than this share of a link is rounding and ends there.
constexpr double kNoiseShare = 1e-9;
/// A link that is longer than it should be by no more than this share has come to rest. [Shimada2024, Sec. 5.2]
constexpr double kRestShare = 1e-3;

/// A cable pulled along its whole length slips by so many times what it must: then most pulls end in the slack that the
/// last slip left near the robot, as with a rope that sticks and slips, and few cost a pass over all nodes.
constexpr double kSlipFactor = 3;

/// Some triangles of a sleeve in a row, both ends included.
Strand Slice(const Strand& strand, std::size_t first, std::size_t last) {
  Strand slice(strand.sleeve[first]);
  slice.sleeve.assign(strand.sleeve.begin() + static_cast<std::ptrdiff_t>(first),
                      strand.sleeve.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  return slice;
}

}  // namespace

double Cable::PullFromRobot() {
  const FreeMesh& mesh = space_->mesh();
  const double link_m = options_.link_length_m;
  for (std::size_t i = links_.size(); i-- > 1;) {
    PullTight(mesh, nodes_[i].point, nodes_[i + 1].point, links_[i]);
    const double excess_m = links_[i].length - link_m;
    // Friction holds all the rest where it lies.
    if (excess_m <= kNoiseShare * link_m) return 0;
    SlideFirst(mesh, nodes_[i], nodes_[i + 1], excess_m, links_[i], &links_[i - 1]);
  }
  PullTight(mesh, nodes_[0].point, nodes_[1].point, links_[0]);
  return std::max(0.0, links_[0].length - first_link_m_);
}

double Cable::PullFromBase() {
  const FreeMesh& mesh = space_->mesh();
  for (std::size_t i = 0;; ++i) {
    PullTight(mesh, nodes_[i].point, nodes_[i + 1].point, links_[i]);
    const double excess_m = links_[i].length - RestLength(i);
    if (excess_m <= kNoiseShare * options_.link_length_m) return 0;
    if (i + 1 == links_.size()) return excess_m;
    SlideSecond(mesh, nodes_[i], nodes_[i + 1], excess_m, links_[i], &links_[i + 1]);
  }
}

void Cable::PayOut(double length_m) {
  first_link_m_ += length_m;
  while (first_link_m_ > options_.link_length_m * (1 + kNoiseShare)) SplitFirstLink();
}

void Cable::SplitFirstLink() {
  const FreeMesh& mesh = space_->mesh();
  StrandCursor cursor(mesh, nodes_[0], nodes_[1], links_[0]);
  cursor.MoveTo(std::max(0.0, links_[0].length - options_.link_length_m));
  const Place node = cursor.place();
  Strand before = Slice(links_[0], 0, cursor.position());
  Strand after = Slice(links_[0], cursor.position(), links_[0].sleeve.size() - 1);
  PullTight(mesh, nodes_[0].point, node.point, before);
  PullTight(mesh, node.point, nodes_[1].point, after);
  nodes_.insert(nodes_.begin() + 1, node);
  links_[0] = std::move(before);
  links_.insert(links_.begin() + 1, std::move(after));
  first_link_m_ -= options_.link_length_m;
}

void Cable::DropPulledIn() {
  while (first_link_m_ <= 0 && links_.size() > 1) {
    Join(links_[0], links_[1]);
    links_.erase(links_.begin() + 1);
    nodes_.erase(nodes_.begin() + 1);
    first_link_m_ += options_.link_length_m;
  }
  first_link_m_ = std::max(0.0, first_link_m_);
}

void Cable::Relax(double excess_m, const Strand& taut) {
  if (excess_m <= kRestShare * options_.link_length_m) return;
  SpreadFromBase(excess_m);
  BlendWith(taut);
}

/// Shares what the first link is too long by evenly among all links: node i of n slides towards the base by (n - i) / n
/// of it, so that no link grows by more than an n-th.
void Cable::SpreadFromBase(double excess_m) {
  const FreeMesh& mesh = space_->mesh();
  const std::size_t n = links_.size();
  for (std::size_t i = 1; i < n; ++i) {
    PullTight(mesh, nodes_[i - 1].point, nodes_[i].point, links_[i - 1]);
    const double by_m = excess_m * static_cast<double>(n - i) / static_cast<double>(n);
    SlideSecond(mesh, nodes_[i - 1], nodes_[i], std::min(by_m, links_[i - 1].length), links_[i - 1], &links_[i]);
  }
  PullTight(mesh, nodes_[n - 1].point, nodes_[n].point, links_[n - 1]);
}

/// Distances between nodes are convex along the motion that takes each node straight, in its class, to its place on the
/// taut cable, where no link is too long. So some share of that motion mends every link.
void Cable::BlendWith(const Strand& taut) {
  const FreeMesh& mesh = space_->mesh();
  const double shrink = std::min(1.0, taut.length / paid_out_m());
  double share = 0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const double rest_m = RestLength(i), excess_m = links_[i].length - rest_m;
    if (excess_m > 0) share = std::max(share, excess_m / (links_[i].length - rest_m * shrink));
  }
  share = std::min(1.0, kSlipFactor * share);
  StrandCursor target(mesh, nodes_.front(), nodes_.back(), taut);
  Strand way(nodes_[0].triangle), last_way = way;
  double target_m = 0;
  for (std::size_t i = 1; i < links_.size(); ++i) {
    // From this node back to the one before it, over to the taut cable and along that.
    std::swap(way, last_way);
    way.sleeve.assign(links_[i - 1].sleeve.rbegin(), links_[i - 1].sleeve.rend());
    Join(way, last_way);
    const std::size_t begin = target.position();
    target.MoveTo(target_m += RestLength(i - 1) * shrink);
    for (std::size_t k = begin; k <= target.position(); ++k) way.StepSecond(taut.sleeve[k]);
    PullTight(mesh, nodes_[i].point, target.place().point, way);
    SlideNode(i, target.place(), share * way.length, way);
    PullTight(mesh, nodes_[i - 1].point, nodes_[i].point, links_[i - 1]);
  }
  PullTight(mesh, nodes_[links_.size() - 1].point, nodes_.back().point, links_.back());
}

/// A node slides along a way to somewhere, and both of its links follow. The way is what is left of it, and out of
/// date.
void Cable::SlideNode(std::size_t node, Place target, double by_m, Strand& way) {
  StrandCursor cursor(space_->mesh(), nodes_[node], target, way);
  cursor.MoveTo(by_m);
  for (std::size_t k = 1; k <= cursor.position(); ++k) {
    links_[node - 1].StepSecond(way.sleeve[k]);
    links_[node].StepFirst(way.sleeve[k]);
  }
  way.sleeve.erase(way.sleeve.begin(), way.sleeve.begin() + static_cast<std::ptrdiff_t>(cursor.position()));
  nodes_[node] = cursor.place();
}

/// Replaces the chain by the taut strand between its ends, with nodes at these arc lengths.
void Cable::CutAt(const Strand& taut, std::span<const double> at_m) {
  const FreeMesh& mesh = space_->mesh();
  const Place base = nodes_.front(), robot = nodes_.back();
  nodes_ = {base};
  links_.clear();
  StrandCursor cursor(mesh, base, robot, taut);
  std::size_t begun = 0;
  const auto end_link = [&](const Place& node, std::size_t position) {
    links_.push_back(Slice(taut, begun, position));
    PullTight(mesh, nodes_.back().point, node.point, links_.back());
    nodes_.push_back(node);
    begun = position;
  };
  for (const double s : at_m) {
    cursor.MoveTo(s);
    end_link(cursor.place(), cursor.position());
  }
  end_link(robot, taut.sleeve.size() - 1);
}

double Cable::Retract(double length_m) {
  const double before_m = paid_out_m(), wanted_m = std::max(0.0, before_m - std::max(0.0, length_m));
  const Strand taut = TautStrand(ClassWalk());
  if (taut.length >= wanted_m) {
    LayTaut(taut);
  } else {
    first_link_m_ -= before_m - wanted_m;
    DropPulledIn();
    // Where the pull comes to the robot, who stands, it comes back.
    if (PullFromBase() > 0) Relax(PullFromRobot(), taut);
  }
  StepResult unused;
  FindContacts(unused);
  return before_m - paid_out_m();
}

void Cable::LayTaut(const Strand& taut) {
  const double link_m = options_.link_length_m;
  const double full_links = std::max(0.0, std::ceil(taut.length / link_m * (1 - kNoiseShare)) - 1);
  first_link_m_ = taut.length - full_links * link_m;
  std::vector<double> at_m;
  for (double i = 0; i < full_links; ++i) at_m.push_back(first_link_m_ + i * link_m);
  CutAt(taut, at_m);
}

}  // namespace tautline
