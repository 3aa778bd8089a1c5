#include "tautline/planners/cable_workspace/side_crossing.h"

#include <algorithm>
#include <compare>
#include <optional>
#include <utility>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {
namespace {

/// A place on the boundary of a triangle, in counter-clockwise order from vertex 0: vertex i is 2i, the edge after it
/// 2i + 1. Points of one edge are told apart by how far along they are.
struct Spot {
  int at = 0;
  double along = 0;

  friend auto operator<=>(const Spot&, const Spot&) = default;
};

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

/// A walk read forwards or backwards.
struct Reading {
  const Walk& walk;
  bool forwards;

  std::size_t size() const { return walk.sleeve.size(); }
  TriangleId operator[](std::size_t i) const {
    return walk.sleeve.triangles()[forwards ? i : walk.sleeve.size() - 1 - i];
  }
  Point first() const { return forwards ? walk.from : walk.at; }
  Point last() const { return forwards ? walk.at : walk.from; }
};

/// The edge through which a triangle is left to a neighbour.
Spot SpotTowards(const FreeMesh& mesh, TriangleId from, TriangleId to) {
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangle(from).neighbour(i) == to && !mesh.triangle(from).is_constrained(i)) return EdgeSpot(i);
  }
  return {};
}

/// Where a reading comes into its i-th triangle, and where it leaves it.
std::optional<Spot> EntryOf(const Ground& ground, const Reading& r, std::size_t i) {
  return i == 0 ? EndSpot(ground, r[0], r.first()) : SpotTowards(ground.mesh, r[i], r[i - 1]);
}
std::optional<Spot> ExitOf(const Ground& ground, const Reading& r, std::size_t i) {
  return i + 1 == r.size() ? EndSpot(ground, r[i], r.last()) : SpotTowards(ground.mesh, r[i], r[i + 1]);
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

/// Whether two readings part to opposite sides at the two ends of what they share from triangles i and k on. Nothing is
/// to be shared before.
bool CrossAlong(const Ground& ground, const Reading& a, const Reading& b, std::size_t i, std::size_t k) {
  const std::size_t first_a = i, first_b = k;
  while (i + 1 < a.size() && k + 1 < b.size() && a[i + 1] == b[k + 1]) ++i, ++k;
  const auto entry_a = EntryOf(ground, a, first_a), entry_b = EntryOf(ground, b, first_b);
  const auto exit_a = ExitOf(ground, a, i), exit_b = ExitOf(ground, b, k);
  if (i == first_a) return Alternate(entry_a, exit_a, entry_b, exit_b);
  // Counter-clockwise from the edge ahead comes the left, from the edge behind the right.
  const int left_at_first = CompareFrom(SpotTowards(ground.mesh, a[first_a], a[first_a + 1]), entry_a, entry_b);
  const int right_at_last = CompareFrom(SpotTowards(ground.mesh, a[i], a[i - 1]), exit_a, exit_b);
  return left_at_first * right_at_last > 0;
}

/// The places of a walk's triangles, sorted by triangle.
std::vector<std::pair<TriangleId, std::size_t>> PlacesOf(const Reading& r) {
  std::vector<std::pair<TriangleId, std::size_t>> places;
  for (std::size_t i = 0; i < r.size(); ++i) places.emplace_back(r[i], i);
  std::sort(places.begin(), places.end());
  return places;
}

bool CrossInOneDirection(const Ground& ground, const Reading& a, const Reading& b) {
  const auto places = PlacesOf(b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    auto at = std::lower_bound(places.begin(), places.end(), std::pair<TriangleId, std::size_t>(a[i], 0));
    for (; at != places.end() && at->first == a[i]; ++at) {
      const std::size_t k = at->second;
      if (i > 0 && k > 0 && a[i - 1] == b[k - 1]) continue;
      if (CrossAlong(ground, a, b, i, k)) return true;
    }
  }
  return false;
}

}  // namespace

bool CablesCross(const TautSpace& space, const Walk& a, const Walk& b) {
  const Ground ground{space.mesh(), space.tolerance()};
  // With itself, a walk shares all of itself, and parts nowhere.
  return CrossInOneDirection(ground, {a, true}, {b, true}) || CrossInOneDirection(ground, {a, true}, {b, false});
}

bool EndsOnBoundary(const TautSpace& space, const Place& place) {
  return EndSpot({space.mesh(), space.tolerance()}, place.triangle, place.point).has_value();
}

}  // namespace tautline
