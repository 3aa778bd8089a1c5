#include "tautline/planners/cable_workspace/side_crossing.h"

#include <algorithm>
#include <compare>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// A place on the boundary of a triangle, in counter-clockwise order from vertex 0: vertex i is 2i, the edge after it
/// 2i + 1. Points of one edge are told apart by how far along they are.
struct Spot {
  int at = 0;
  double along = 0;

  friend auto operator<=>(const Spot&, const Spot&) = default;
};

constexpr std::uint8_t kUnknown = 255;

/// Where the walks are.
struct Ground {
  const FreeMesh& mesh;
  double tolerance;
};

/// The spot of the edge opposite to vertex i.
Spot EdgeSpot(int i) { return {2 * Next(i) + 1, 0}; }

/// Where a walk ends in a triangle; nothing when it ends in the open. On a slanted wall a point is off the line by its
/// rounding.
std::optional<Spot> EndSpot(const Ground& ground, TriangleId id, Point p) {
  const FreeMesh& mesh = ground.mesh;
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangulation().corner(id, i) == p) return Spot{2 * i, 0};
  }
  for (int i = 0; i < 3; ++i) {
    const Point tail = mesh.triangulation().corner(id, Next(i)), tip = mesh.triangulation().corner(id, Previous(i));
    if (!mesh.triangle(id).is_constrained(i) || DistanceToSegment(p, tail, tip) > ground.tolerance) continue;
    return Spot{EdgeSpot(i).at, Dot(p - tail, tip - tail)};
  }
  return std::nullopt;
}

/// The edge through which a triangle is left to a neighbour.
Spot SpotTowards(const FreeMesh& mesh, TriangleId from, TriangleId to) {
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangle(from).neighbour(i) == to && !mesh.triangle(from).is_constrained(i)) return EdgeSpot(i);
  }
  return {};
}

/// Whether a walk ends in the open on the edge that leads into its last triangle: it does not pass what runs along that
/// edge.
bool EndsOnEdge(const Ground& ground, TriangleId before, TriangleId last, Point end) {
  if (EndSpot(ground, last, end)) return false;
  const int i = ground.mesh.triangle(last).IndexOf(before);
  return OnSegment(ground.mesh.triangulation().corner(last, Next(i)),
                   ground.mesh.triangulation().corner(last, Previous(i)), end);
}

/// The triangles of a walk, without those that it only touches at its ends.
std::span<const TriangleId> PassedTriangles(const Ground& ground, const Walk& walk) {
  std::span<const TriangleId> passed = walk.sleeve.triangles();
  std::size_t n = passed.size();
  if (n > 1 && EndsOnEdge(ground, passed[n - 2], passed[n - 1], walk.at)) passed = passed.first(--n);
  if (n > 1 && EndsOnEdge(ground, passed[1], passed[0], walk.from)) passed = passed.subspan(1);
  return passed;
}

/// Counter-clockwise from `from`: -1 when a comes before b, 1 after, 0 when they are one or one is unknown.
int CompareFrom(Spot from, const std::optional<Spot>& a, const std::optional<Spot>& b) {
  if (!a || !b || *a == *b) return 0;
  const bool a_wraps = *a < from, b_wraps = *b < from;
  if (a_wraps != b_wraps) return a_wraps ? 1 : -1;
  return *a < *b ? -1 : 1;
}

/// Whether chords of one triangle alternate strictly.
bool Alternate(const std::optional<Spot>& a, const std::optional<Spot>& b, const std::optional<Spot>& c,
               const std::optional<Spot>& d) {
  if (!a || !b || !c || !d || *c == *a || *c == *b || *d == *a || *d == *b) return false;
  return (CompareFrom(*a, b, c) < 0) != (CompareFrom(*a, b, d) < 0);
}

}  // namespace

WalkSpots::WalkSpots(const TautSpace& space, const Walk& walk) {
  const Ground ground{space.mesh(), space.tolerance()};
  const auto passed = PassedTriangles(ground, walk);
  triangles_.assign(passed.begin(), passed.end());
  const auto add = [this](const std::optional<Spot>& spot, double& along) {
    spots_.push_back(spot ? static_cast<std::uint8_t>(spot->at) : kUnknown);
    if (spot) along = spot->along;
  };
  const auto towards = [&](std::size_t from, std::size_t to) {
    spots_.push_back(static_cast<std::uint8_t>(SpotTowards(ground.mesh, triangles_[from], triangles_[to]).at));
  };
  const std::size_t n = triangles_.size();
  places_.reserve(n);
  spots_.reserve(2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    places_.emplace_back(triangles_[i], static_cast<std::uint32_t>(i));
    if (i == 0) {
      add(EndSpot(ground, triangles_[0], walk.from), first_along_);
    } else {
      towards(i, i - 1);
    }
    if (i + 1 == n) {
      add(EndSpot(ground, triangles_[i], walk.at), last_along_);
    } else {
      towards(i, i + 1);
    }
  }
  std::sort(places_.begin(), places_.end());
}

/// A walk read forwards or backwards.
struct WalkSpots::Reading {
  const WalkSpots& spots;
  bool forwards;

  std::size_t size() const { return spots.triangles_.size(); }
  /// The place in the walk of the i-th triangle, and the other way round.
  std::size_t Place(std::size_t i) const { return forwards ? i : size() - 1 - i; }
  TriangleId operator[](std::size_t i) const { return spots.triangles_[Place(i)]; }
  /// Where the reading comes into its i-th triangle, and where it leaves it.
  std::optional<Spot> Entry(std::size_t i) const { return At(Place(i), !forwards); }
  std::optional<Spot> Exit(std::size_t i) const { return At(Place(i), forwards); }

 private:
  std::optional<Spot> At(std::size_t place, bool exit) const {
    const std::uint8_t at = spots.spots_[2 * place + (exit ? 1 : 0)];
    if (at == kUnknown) return std::nullopt;
    if (!exit && place == 0) return Spot{at, spots.first_along_};
    if (exit && place + 1 == size()) return Spot{at, spots.last_along_};
    return Spot{at, 0};
  }
};

/// Whether two readings part to opposite sides at the two ends of what they share from triangles i and k on. Nothing is
/// to be shared before.
bool WalkSpots::CrossAlong(const Reading& a, const Reading& b, std::size_t i, std::size_t k) {
  const std::size_t first_a = i, first_b = k;
  while (i + 1 < a.size() && k + 1 < b.size() && a[i + 1] == b[k + 1]) ++i, ++k;
  if (i == first_a) return Alternate(a.Entry(first_a), a.Exit(i), b.Entry(first_b), b.Exit(k));
  // Counter-clockwise from the edge ahead comes the left, from the edge behind the right.
  const int left_at_first = CompareFrom(*a.Exit(first_a), a.Entry(first_a), b.Entry(first_b));
  const int right_at_last = CompareFrom(*a.Entry(i), a.Exit(i), b.Exit(k));
  return left_at_first * right_at_last > 0;
}

bool WalkSpots::CrossInOneDirection(const Reading& a, const Reading& b) {
  auto first = b.spots.places_.begin();
  const auto last = b.spots.places_.end();
  for (const auto& [triangle, place] : a.spots.places_) {
    while (first != last && first->first < triangle) ++first;
    for (auto at = first; at != last && at->first == triangle; ++at) {
      const std::size_t i = a.Place(place), k = b.Place(at->second);
      if (i > 0 && k > 0 && a[i - 1] == b[k - 1]) continue;
      if (CrossAlong(a, b, i, k)) return true;
    }
  }
  return false;
}

bool CablesCross(const WalkSpots& a, const WalkSpots& b) {
  // With itself, a walk shares all of itself, and parts nowhere.
  return WalkSpots::CrossInOneDirection({a, true}, {b, true}) || WalkSpots::CrossInOneDirection({a, true}, {b, false});
}

bool CablesCross(const TautSpace& space, const Walk& a, const Walk& b) {
  return CablesCross(WalkSpots(space, a), WalkSpots(space, b));
}

bool EndsOnBoundary(const TautSpace& space, const Place& place) {
  return EndSpot({space.mesh(), space.tolerance()}, place.triangle, place.point).has_value();
}

}  // namespace tautline
