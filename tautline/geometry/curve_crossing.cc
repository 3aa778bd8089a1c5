#include "tautline/geometry/curve_crossing.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Where two segments cross that cross properly, rounded.
Point CrossingPoint(Point a, Point b, Point c, Point d) {
  const double t = Cross(c - a, d - c) / Cross(b - a, d - c);
  return Lerp(a, b, std::clamp(t, 0.0, 1.0));
}

std::optional<Point> FindProperCrossing(std::span<const Point> curve) {
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    for (std::size_t j = i + 2; j + 1 < curve.size(); ++j) {
      if (CrossProperly(curve[i], curve[i + 1], curve[j], curve[j + 1])) {
        return CrossingPoint(curve[i], curve[i + 1], curve[j], curve[j + 1]);
      }
    }
  }
  return std::nullopt;
}

/// The curve with its own vertices put in wherever it passes through them: then it meets itself in vertices alone, or
/// along whole segments.
Polyline CutAtOwnVertices(std::span<const Point> curve) {
  Polyline cut;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const Point a = curve[i], b = curve[i + 1];
    Polyline between;
    for (const Point p : curve) {
      if (p != a && p != b && OnSegment(a, b, p)) between.push_back(p);
    }
    // On one line, points are ordered by their coordinates exactly as they are along it.
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    if (b < a) std::reverse(between.begin(), between.end());
    cut.push_back(a);
    cut.insert(cut.end(), between.begin(), between.end());
  }
  if (!curve.empty()) cut.push_back(curve.back());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

/// Reads a curve cut at its own vertices twice at once: forwards from vertex i on, and from vertex j on in a direction.
class DoubleReading {
 public:
  DoubleReading(std::span<const Point> cut, std::size_t i, std::size_t j, bool forwards)
      : cut_(cut), i_(i), j_(j), forwards_(forwards) {}

  /// Whether both come from the same point: then the run that they share began before.
  bool StartsBefore() const { return HasFirst(-1) && HasSecond(-1) && First(-1) == Second(-1); }

  /// Whether both part to opposite sides at the two ends of what they share from here on.
  bool Crosses() const {
    std::ptrdiff_t last = 0;
    while (!Meets(last) && HasFirst(last + 1) && HasSecond(last + 1) && First(last + 1) == Second(last + 1)) ++last;
    if (!HasFirst(-1) || !HasSecond(-1) || !HasFirst(last + 1) || !HasSecond(last + 1) || Meets(last)) return false;
    if (last == 0) return CrossesAtOnce();
    // Counter-clockwise from the direction ahead the left comes first, from that behind the right.
    const bool left_at_first = WithinTurn(First(0), First(1), Second(-1), First(-1));
    const bool right_at_last = WithinTurn(First(last), First(last - 1), Second(last + 1), First(last + 1));
    return left_at_first == right_at_last;
  }

 private:
  bool CrossesAtOnce() const {
    const std::array<Point, 2> first{First(-1), First(1)}, second{Second(-1), Second(1)};
    for (const Point p : second) {
      // They share a segment: it is looked at as a run, from one of its ends, in one of the directions.
      if (p == first[0] || p == first[1]) return false;
    }
    return WithinTurn(First(0), first[0], first[1], second[0]) != WithinTurn(First(0), first[0], first[1], second[1]);
  }

  bool Has(std::ptrdiff_t k) const { return k >= 0 && k < static_cast<std::ptrdiff_t>(cut_.size()); }
  std::ptrdiff_t FirstAt(std::ptrdiff_t k) const { return static_cast<std::ptrdiff_t>(i_) + k; }
  std::ptrdiff_t SecondAt(std::ptrdiff_t k) const { return static_cast<std::ptrdiff_t>(j_) + (forwards_ ? k : -k); }
  bool HasFirst(std::ptrdiff_t k) const { return Has(FirstAt(k)); }
  bool HasSecond(std::ptrdiff_t k) const { return Has(SecondAt(k)); }
  Point First(std::ptrdiff_t k) const { return cut_[static_cast<std::size_t>(FirstAt(k))]; }
  Point Second(std::ptrdiff_t k) const { return cut_[static_cast<std::size_t>(SecondAt(k))]; }
  /// Whether the readings have come together in a fold of the curve.
  bool Meets(std::ptrdiff_t k) const { return !forwards_ && FirstAt(k) >= SecondAt(k); }

  std::span<const Point> cut_;
  std::size_t i_, j_;
  bool forwards_;
};

bool IsCounterClockwise(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  const auto lowest = static_cast<std::size_t>(std::min_element(ring.begin(), ring.end()) - ring.begin());
  return Orientation(ring[(lowest + n - 1) % n], ring[lowest], ring[(lowest + 1) % n]) > 0;
}

/// Nearest to `a` of the points that the segments ab and cd share.
std::optional<Point> FirstShared(Point a, Point b, Point c, Point d) {
  if (OnSegment(c, d, a)) return a;
  std::optional<Point> nearest;
  const auto offer = [&](Point p) {
    if (!nearest || Distance(a, p) < Distance(a, *nearest)) nearest = p;
  };
  if (CrossProperly(a, b, c, d)) offer(CrossingPoint(a, b, c, d));
  if (OnSegment(a, b, c)) offer(c);
  if (OnSegment(a, b, d)) offer(d);
  if (OnSegment(c, d, b)) offer(b);
  return nearest;
}

}  // namespace

std::optional<Point> FindCurveCrossing(std::span<const Point> curve) {
  if (const auto proper = FindProperCrossing(curve)) return proper;
  const Polyline cut = CutAtOwnVertices(curve);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    for (std::size_t j = i + 1; j < cut.size(); ++j) {
      if (cut[i] != cut[j]) continue;
      for (const bool forwards : {true, false}) {
        const DoubleReading reading(cut, i, j, forwards);
        if (!reading.StartsBefore() && reading.Crosses()) return cut[i];
      }
    }
  }
  return std::nullopt;
}

bool EntersRing(std::span<const Point> ring, Point a, Point b) {
  for (const Point p : {a, b}) {
    const Winding winding = WindingNumber(ring, p);
    if (!winding.on_boundary && winding.number != 0) return true;
  }
  const bool counter_clockwise = IsCounterClockwise(ring);
  const std::size_t n = ring.size();
  // Whether one leaves a point of the boundary inwards, towards an end of the segment.
  const auto leaves_inwards = [&](Point before, Point apex, Point after) {
    if (!counter_clockwise) std::swap(before, after);
    return (a != apex && WithinTurn(apex, after, before, a)) || (b != apex && WithinTurn(apex, after, before, b));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point tail = ring[i], tip = ring[(i + 1) % n];
    if (CrossProperly(a, b, tail, tip)) return true;
    if (OnSegment(a, b, tail) && leaves_inwards(ring[(i + n - 1) % n], tail, tip)) return true;
    for (const Point end : {a, b}) {
      if (end != tail && end != tip && OnSegment(tail, tip, end) && leaves_inwards(tail, end, tip)) return true;
    }
  }
  return false;
}

std::optional<CurveMeeting> FindFirstMeeting(std::span<const Point> curve, std::span<const Point> other) {
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    std::optional<CurveMeeting> first;
    for (std::size_t k = 0; k + 1 < other.size(); ++k) {
      const auto shared = FirstShared(curve[i], curve[i + 1], other[k], other[k + 1]);
      if (!shared) continue;
      if (!first || Distance(curve[i], *shared) < Distance(curve[i], first->at)) first = CurveMeeting{i, k, *shared};
    }
    if (first) return first;
  }
  return std::nullopt;
}

}  // namespace tautline
