#include "tautline/planners/tether/circle_span.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace tautline {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

constexpr AngleRange kNothing{0, -1};
constexpr AngleRange kEverything{0, std::numbers::pi};

double AngleOf(Point direction) { return std::atan2(direction.y, direction.x); }

}  // namespace

Chord ChordOf(const Disc& disc, Point a, Point b) {
  if (b < a) std::swap(a, b);
  Chord chord;
  const double length = Distance(a, b);
  chord.along = {(b.x - a.x) / length, (b.y - a.y) / length};
  const Point to_centre = disc.centre - a;
  chord.offset = Cross(chord.along, to_centre);
  chord.foot = a + Dot(chord.along, to_centre) * chord.along;
  const double square = (disc.radius - chord.offset) * (disc.radius + chord.offset);
  chord.crosses = square > 0;
  chord.half = chord.crosses ? std::sqrt(square) : 0;
  return chord;
}

AngleRange LeftOfLine(const Disc& disc, Point a, Point b) {
  const Chord chord = ChordOf(disc, a, b);
  const bool forward = a < b;
  const double offset = forward ? chord.offset : -chord.offset;
  if (!chord.crosses) return offset > 0 ? kEverything : kNothing;
  const Point left = forward ? Point{-chord.along.y, chord.along.x} : Point{chord.along.y, -chord.along.x};
  return {AngleOf(left), std::atan2(chord.half, -offset)};
}

AngleRange InsideDisc(const Disc& disc, const Disc& other, bool wins_tie) {
  const double apart = Distance(disc.centre, other.centre), sum = disc.radius + other.radius;
  const double difference = disc.radius - other.radius;
  if (apart == 0) {
    if (difference == 0) return wins_tie ? kEverything : kNothing;
    return difference < 0 ? kEverything : kNothing;
  }
  if (apart >= sum || difference >= apart) return kNothing;
  if (-difference >= apart) return kEverything;
  // Symmetric in the two discs, so that both circles are cut at the same points.
  const double half =
      std::sqrt((sum + apart) * (sum - apart)) * std::sqrt((apart + difference) * (apart - difference)) / (2 * apart);
  const double towards = 0.5 * (apart + difference * sum / apart);
  return {AngleOf(other.centre - disc.centre), std::atan2(half, towards)};
}

std::vector<AngleSpan> Intersect(std::span<const AngleSpan> spans, const AngleRange& range) {
  if (range.half >= std::numbers::pi) return {spans.begin(), spans.end()};
  std::vector<AngleSpan> parts;
  if (range.half < 0) return parts;
  for (const AngleSpan& span : spans) {
    const double first = range.middle + kTurn * std::floor((span.low - range.middle) / kTurn);
    for (int turn = -1; turn <= 2; ++turn) {
      const double middle = first + kTurn * turn;
      const AngleSpan part{std::max(span.low, middle - range.half), std::min(span.high, middle + range.half)};
      if (part.low < part.high) parts.push_back(part);
    }
  }
  return parts;
}

std::vector<AngleSpan> Uncovered(const AngleSpan& span, std::vector<AngleSpan> covers, double least) {
  std::sort(covers.begin(), covers.end(), [](const AngleSpan& a, const AngleSpan& b) { return a.low < b.low; });
  std::vector<AngleSpan> rest;
  double at = span.low;
  for (const AngleSpan& cover : covers) {
    if (cover.low - at > least) rest.push_back({at, std::min(cover.low, span.high)});
    at = std::max(at, cover.high);
  }
  if (span.high - at > least) rest.push_back({at, span.high});
  return rest;
}

Point PointAt(const Disc& disc, double angle) {
  return disc.centre + disc.radius * Point{std::cos(angle), std::sin(angle)};
}

}  // namespace tautline
