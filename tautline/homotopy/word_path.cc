#include "tautline/homotopy/word_path.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tautline/base/check.h"
#include "tautline/base/rng.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/word_drawing.h"

namespace tautline {
namespace {

/// A side of a free triangle that is part of a wall.
struct WallSide {
  TriangleId triangle;
  int side;

  friend bool operator==(const WallSide&, const WallSide&) = default;
};

/// Once around a boundary ring, free ground on the left: the triangles that touch it, and where its sides come.
struct RingTour {
  std::vector<TriangleId> triangles;  ///< From the first side's triangle round to it again.
  std::vector<WallSide> sides;
  std::vector<std::size_t> at;  ///< The place of each side's triangle in `triangles`.
};

RingTour TourFrom(const FreeMesh& mesh, WallSide first) {
  RingTour tour{{first.triangle}, {}, {}};
  WallSide here = first;
  do {
    tour.sides.push_back(here);
    tour.at.push_back(tour.triangles.size() - 1);
    const VertexId pivot = mesh.triangle(here.triangle).vertex(Previous(here.side));
    here.side = Next(here.side);
    while (!mesh.triangle(here.triangle).is_constrained(here.side)) {
      here.triangle = mesh.triangle(here.triangle).neighbour(here.side);
      here.side = Previous(mesh.triangle(here.triangle).IndexOf(pivot));
      tour.triangles.push_back(here.triangle);
    }
  } while (here != first);
  return tour;
}

/// Carries a drawing, which may pass through obstacles but not through vertices, into the free space.
class Carrier {
 public:
  Carrier(const TautSpace& space, Place from)
      : space_(space),
        mesh_(space.mesh()),
        component_(mesh_.ComponentOf(from.triangle)),
        walk_(from),
        at_(from.triangle) {}

  /// False when the drawing met a vertex by chance. Requires that it starts and ends inside free triangles.
  bool Carry(const Polyline& drawing) {
    for (std::size_t i = 1; i < drawing.size(); ++i) {
      if (!CarrySegment(drawing[i - 1], drawing[i])) return false;
      if (!InComponent(at_)) outside_.push_back(drawing[i]);
    }
    return InComponent(at_);
  }

  /// The walk in the class of the drawing, ended at a point of its last triangle.
  Walk Finish(Point to) {
    walk_.at = to;
    return std::move(walk_);
  }

 private:
  bool InComponent(TriangleId id) const { return mesh_.IsFree(id) && mesh_.ComponentOf(id) == component_; }
  Point CornerAt(int i) const { return mesh_.triangulation().corner(at_, i); }

  bool CarrySegment(Point a, Point b) {
    for (;;) {
      int exit = -1;
      for (int i = 0; i < 3; ++i) {
        const Point right = CornerAt(Next(i)), left = CornerAt(Previous(i));
        if (Orientation(right, left, b) >= 0) continue;
        const int side_right = Orientation(a, b, right), side_left = Orientation(a, b, left);
        if (side_right == 0 || side_left == 0) return false;
        if (side_right < 0 && side_left > 0) exit = i;
      }
      if (exit < 0) return true;
      Cross(exit, CrossingPoint(a, b, CornerAt(Next(exit)), CornerAt(Previous(exit))));
    }
  }

  static Point CrossingPoint(Point a, Point b, Point p, Point q) {
    const double from_p = tautline::Cross(b - a, p - a), from_q = tautline::Cross(b - a, q - a);
    return Lerp(p, q, from_p / (from_p - from_q));
  }

  void Cross(int side, Point where) {
    const TriangleId next = mesh_.triangle(at_).neighbour(side);
    if (InComponent(at_) && InComponent(next)) walk_.sleeve.Step(next);
    if (InComponent(at_) && !InComponent(next)) {
      left_through_ = {at_, side};
      outside_ = {where};
    }
    if (!InComponent(at_) && InComponent(next)) {
      outside_.push_back(where);
      GoAround({next, mesh_.triangle(next).IndexOf(at_)});
    }
    at_ = next;
  }

  /// Replaces the passage through what is not free, from the side left to the side `back`, by one along the ring
  /// between them that winds as often around the ring's representative.
  void GoAround(WallSide back) {
    const RingTour tour = TourFrom(mesh_, left_through_);
    const auto found = std::find(tour.sides.begin(), tour.sides.end(), back);
    TAUTLINE_CHECK(found != tour.sides.end());
    const auto position = static_cast<std::size_t>(found - tour.sides.begin());
    Polyline along{outside_.front()};
    Ring ring;
    for (std::size_t k = 0; k < tour.sides.size(); ++k) {
      ring.push_back(mesh_.triangulation().corner(tour.sides[k].triangle, Previous(tour.sides[k].side)));
      if (k < position) along.push_back(ring.back());
    }
    along.push_back(outside_.back());
    const std::vector<int> drawn = space_.rays().HomologyOf(outside_), walked = space_.rays().HomologyOf(along);
    int turns = 0;
    if (const auto island = Witness(ring)) {
      // Around an island the tour runs clockwise and crosses its ray to the right; around the component, to the left.
      turns = (drawn[island->index()] - walked[island->index()]) * (SignedArea(ring) < 0 ? 1 : -1);
    }
    for (; turns > 0; --turns) Step(tour.triangles.begin(), tour.triangles.end());
    for (; turns < 0; ++turns) Step(tour.triangles.rbegin(), tour.triangles.rend());
    Step(tour.triangles.begin(), tour.triangles.begin() + static_cast<std::ptrdiff_t>(tour.at[position]) + 1);
  }

  template <class Iterator>
  void Step(Iterator begin, Iterator end) {
    for (; begin != end; ++begin) walk_.sleeve.Step(*begin);
  }

  /// An island whose ray tells how often a curve winds around the ring: one inside of it.
  std::optional<ObstacleId> Witness(const Ring& ring) const {
    const std::vector<Island>& islands = space_.free_space().islands;
    for (std::size_t i = 0; i < islands.size(); ++i) {
      if (WindingNumber(ring, islands[i].representative).number != 0) return ObstacleId(i);
    }
    return std::nullopt;
  }

  const TautSpace& space_;
  const FreeMesh& mesh_;
  std::int32_t component_;
  Walk walk_;
  TriangleId at_;
  WallSide left_through_{};
  Polyline outside_;  ///< The drawing since it left the component.
};

/// A random point inside the place's triangle.
Point PointInside(const FreeMesh& mesh, Place place, Rng& rng) {
  const double u = rng.Uniform(0.2, 0.4), v = rng.Uniform(0.2, 0.4);
  const auto corner = [&](int i) { return mesh.triangulation().corner(place.triangle, i); };
  return corner(0) + u * (corner(1) - corner(0)) + v * (corner(2) - corner(0));
}

}  // namespace

std::optional<TautPath> FindWordPath(const TautSpace& space, Place from, Place to, const Word& word) {
  // Random lines meet a vertex exactly with a chance that is practically zero; the seed is fixed for equal answers.
  constexpr int kMostTries = 100;
  Rng rng(1);
  for (int i = 0; i < kMostTries; ++i) {
    const Point start = PointInside(space.mesh(), from, rng), end = PointInside(space.mesh(), to, rng);
    const Point first_leg[] = {from.point, start}, last_leg[] = {end, to.point};
    const Word drawn = space.rays().WordOf(first_leg).Inverse() * word * space.rays().WordOf(last_leg).Inverse();
    Carrier carrier(space, from);
    if (!carrier.Carry(WordDrawing(space.free_space(), rng).Draw(start, drawn, end))) continue;
    TautPath path = space.Pull(carrier.Finish(to.point));
    if (path.word == word) return path;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace tautline
