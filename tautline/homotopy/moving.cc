#include "tautline/homotopy/moving.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

Letter InverseOf(Letter letter) { return {letter.obstacle, !letter.inverse}; }

Word Conjugated(const Word& word, ObstacleId letter, Letter by) {
  Word conjugated;
  for (const Letter each : word.letters()) {
    if (each.obstacle != letter) {
      conjugated.Append(each);
      continue;
    }
    conjugated.Append(by);
    conjugated.Append(each);
    conjugated.Append(InverseOf(by));
  }
  return conjugated;
}

}  // namespace

MovingPunctures::MovingPunctures(std::vector<Point> punctures, std::vector<Point> ends)
    : punctures_(std::move(punctures)), ends_(std::move(ends)) {
  for (std::size_t i = 0; i < punctures_.size(); ++i) by_column_.emplace_back(i);
  std::sort(by_column_.begin(), by_column_.end(), [this](ObstacleId a, ObstacleId b) { return IsBefore(a, b); });
}

bool MovingPunctures::IsBefore(ObstacleId a, ObstacleId b) const {
  return std::tie(punctures_[a.index()].x, a) < std::tie(punctures_[b.index()].x, b);
}

/// The punctures with low <= x <= high.
std::span<const ObstacleId> MovingPunctures::InColumns(double low, double high) const {
  const auto begin = std::lower_bound(by_column_.begin(), by_column_.end(), low,
                                      [this](ObstacleId id, double x) { return punctures_[id.index()].x < x; });
  const auto end = std::upper_bound(begin, by_column_.end(), high,
                                    [this](double x, ObstacleId id) { return x < punctures_[id.index()].x; });
  return {by_column_.data() + (begin - by_column_.begin()), static_cast<std::size_t>(end - begin)};
}

std::optional<PunctureCollision> MovingPunctures::FindCollision(ObstacleId puncture, Point to) const {
  const Point from = punctures_[puncture.index()];
  for (const ObstacleId other : InColumns(std::min(from.x, to.x), std::max(from.x, to.x))) {
    if (other != puncture && OnSegment(from, to, punctures_[other.index()])) return PunctureCollision{other, {}};
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    if (OnSegment(from, to, ends_[i])) return PunctureCollision{{}, i};
  }
  return std::nullopt;
}

std::vector<MovingPunctures::Meeting> MovingPunctures::Meetings(ObstacleId puncture, Point to) const {
  const Point from = punctures_[puncture.index()];
  const bool rightwards = from.x < to.x;
  // Whether the way passes above a point of one of its columns; it does not lead through it.
  const auto passes_above = [&](Point p) { return rightwards == (Orientation(from, to, p) < 0); };
  std::vector<Meeting> meetings;
  for (const ObstacleId other : InColumns(std::min(from.x, to.x), std::max(from.x, to.x))) {
    const Point p = punctures_[other.index()];
    const bool was_before = std::tie(from.x, puncture) < std::tie(p.x, other);
    const bool is_before = std::tie(to.x, puncture) < std::tie(p.x, other);
    if (other == puncture || was_before == is_before) continue;
    // The upper one is conjugated by the lower one, forwards when it passes to the right.
    const bool above = passes_above(p);
    const ObstacleId upper = above ? puncture : other, lower = above ? other : puncture;
    meetings.push_back({p.x, other.index(), {{}, upper, {lower, above != rightwards}}});
  }
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const bool was_before = from.x <= ends_[i].x, is_before = to.x <= ends_[i].x;
    if (was_before == is_before || passes_above(ends_[i])) continue;
    meetings.push_back({ends_[i].x, punctures_.size(), {i, puncture, {puncture, rightwards}}});
  }
  std::sort(meetings.begin(), meetings.end(), [rightwards](const Meeting& a, const Meeting& b) {
    return rightwards ? std::tie(a.x, a.rank) < std::tie(b.x, b.rank) : std::tie(b.x, b.rank) < std::tie(a.x, a.rank);
  });
  return meetings;
}

tl::expected<void, PunctureCollision> MovingPunctures::Move(ObstacleId puncture, Point to) {
  if (to == punctures_[puncture.index()]) return {};
  if (const auto collision = FindCollision(puncture, to)) return tl::unexpected(*collision);
  for (const Meeting& meeting : Meetings(puncture, to)) passages_.push_back(meeting.passage);
  const auto before = [this](ObstacleId a, ObstacleId b) { return IsBefore(a, b); };
  by_column_.erase(std::lower_bound(by_column_.begin(), by_column_.end(), puncture, before));
  punctures_[puncture.index()] = to;
  by_column_.insert(std::lower_bound(by_column_.begin(), by_column_.end(), puncture, before), puncture);
  return {};
}

std::optional<Word> MovingPunctures::Carry(const Word& word, std::size_t start, std::size_t end) const {
  TAUTLINE_CHECK(start < ends_.size() && end < ends_.size());
  const std::size_t most = kMostCarriedLetters + 4 * (word.size() + passages_.size());
  Word carried = word;
  for (const Passage& passage : passages_) {
    if (!passage.end) carried = Conjugated(carried, passage.letter, passage.by);
    if (passage.end == start) {
      Word longer;
      longer.Append(InverseOf(passage.by));
      longer.Append(carried);
      carried = std::move(longer);
    }
    if (passage.end == end) carried.Append(passage.by);
    if (carried.size() > most) return std::nullopt;
  }
  return carried;
}

}  // namespace tautline
