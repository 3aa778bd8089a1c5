#include "tautline/homotopy/cover.h"

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// One straight walk. `pivot_` is the last point where the segment was pinned down: its start or a vertex on it.
class StraightWalk {
 public:
  StraightWalk(const FreeMesh& mesh, Point to, Walk& walk)
      : mesh_(mesh), to_(to), walk_(walk), pivot_(walk.at), at_(walk.sleeve.back()) {}

  std::optional<Point> Run() {
    while (!Arrived()) {
      const int vertex = VertexAtPivot();
      if (vertex >= 0 && !TurnAround(vertex) && !StartInOtherSector(vertex)) return pivot_;
      if (Arrived()) break;
      if (const auto blocked = LeaveTriangle()) return blocked;
    }
    walk_.at = to_;
    return std::nullopt;
  }

 private:
  Point CornerAt(TriangleId id, int i) const { return mesh_.triangulation().corner(id, i); }

  bool Arrived() const {
    for (int i = 0; i < 3; ++i) {
      if (Orientation(CornerAt(at_, i), CornerAt(at_, Next(i)), to_) < 0) return false;
    }
    return true;
  }

  int VertexAtPivot() const {
    for (int i = 0; i < 3; ++i) {
      if (CornerAt(at_, i) == pivot_) return i;
    }
    return -1;
  }

  void StepTo(TriangleId next) {
    at_ = next;
    walk_.sleeve.Step(next);
  }

  /// Whether the target lies in the closed cone of triangle `id` at its vertex i.
  bool Ahead(TriangleId id, int i) const {
    const Point v = CornerAt(id, i);
    return Orientation(v, CornerAt(id, Next(i)), to_) >= 0 && Orientation(v, CornerAt(id, Previous(i)), to_) <= 0;
  }

  /// Turns within the free sector around the vertex until the target is ahead; false when it never is.
  bool TurnAround(int i) {
    if (Ahead(at_, i)) return true;
    const VertexId vertex = mesh_.triangle(at_).vertex(i);
    for (const bool counter_clockwise : {true, false}) {
      std::vector<TriangleId> passed;
      TriangleId id = at_;
      int k = i;
      for (;;) {
        const auto side = static_cast<std::size_t>(counter_clockwise ? Next(k) : Previous(k));
        if (mesh_.triangle(id).constrained[side]) break;
        id = mesh_.triangle(id).neighbours[side];
        k = mesh_.triangle(id).IndexOf(vertex);
        passed.push_back(id);
        if (!Ahead(id, k)) continue;
        for (const TriangleId step : passed) StepTo(step);
        return true;
      }
    }
    return false;
  }

  /// A walk that begins on a vertex where blocked ground touches may leave through any sector.
  bool StartInOtherSector(int i) {
    if (!walk_.is_free_to_turn() || pivot_ != walk_.from) return false;
    bool found = false;
    mesh_.ForEachFreeAround(mesh_.triangle(at_).vertex(i), [&](TriangleId id, int k) {
      if (found || !Ahead(id, k)) return;
      found = true;
      at_ = id;
      walk_.sleeve = Sleeve(id);
    });
    return found;
  }

  /// Crosses the side through which the segment leaves the triangle, or stops at a vertex on the way.
  std::optional<Point> LeaveTriangle() {
    for (int i = 0;; ++i) {
      TAUTLINE_CHECK(i < 3);  // A segment that has not arrived leaves by one of the sides.
      const Point a = CornerAt(at_, Next(i)), b = CornerAt(at_, Previous(i));
      if (Orientation(a, b, to_) >= 0) continue;
      const int side_a = Orientation(pivot_, to_, a), side_b = Orientation(pivot_, to_, b);
      if (side_a > 0 || side_b < 0 || a == pivot_ || b == pivot_) continue;
      if (side_a == 0 || side_b == 0) {
        pivot_ = side_a == 0 ? a : b;
        return std::nullopt;
      }
      if (mesh_.triangle(at_).is_constrained(i)) return CrossingPoint(a, b);
      StepTo(mesh_.triangle(at_).neighbour(i));
      return std::nullopt;
    }
  }

  Point CrossingPoint(Point a, Point b) const {
    const double from_a = Cross(to_ - pivot_, a - pivot_), from_b = Cross(to_ - pivot_, b - pivot_);
    return from_a == from_b ? a : Lerp(a, b, from_a / (from_a - from_b));
  }

  const FreeMesh& mesh_;
  Point to_;
  Walk& walk_;
  Point pivot_;
  TriangleId at_;
};

/// The triangles after `start` around a vertex of it, up to `goal`; none when a wall comes before it.
std::vector<TriangleId> FanTo(const FreeMesh& mesh, TriangleId start, VertexId vertex, bool counter_clockwise,
                              TriangleId goal) {
  std::vector<TriangleId> passed;
  TriangleId at = start;
  do {
    const int k = mesh.triangle(at).IndexOf(vertex);
    const int side = counter_clockwise ? Next(k) : Previous(k);
    if (mesh.triangle(at).is_constrained(side)) return {};
    at = mesh.triangle(at).neighbour(side);
    passed.push_back(at);
  } while (at != goal && at != start);
  return at == goal ? passed : std::vector<TriangleId>{};
}

}  // namespace

Sleeve Sleeve::Reversed() const {
  Sleeve reversed = *this;
  reversed.triangles_.assign(triangles_.rbegin(), triangles_.rend());
  return reversed;
}

std::optional<Point> WalkStraight(const FreeMesh& mesh, Point to, Walk& walk) {
  return StraightWalk(mesh, to, walk).Run();
}

bool TurnInto(const FreeMesh& mesh, TriangleId triangle, Walk& walk) {
  const TriangleId start = walk.sleeve.back();
  if (start == triangle) return true;
  for (int i = 0; i < 3; ++i) {
    const Point tail = mesh.triangulation().corner(start, Next(i)),
                tip = mesh.triangulation().corner(start, Previous(i));
    if (mesh.triangle(start).is_constrained(i) || mesh.triangle(start).neighbour(i) != triangle) continue;
    if (!OnSegment(tail, tip, walk.at)) continue;
    walk.sleeve.Step(triangle);
    return true;
  }
  for (int i = 0; i < 3; ++i) {
    if (mesh.triangulation().corner(start, i) != walk.at) continue;
    for (const bool counter_clockwise : {true, false}) {
      std::vector<TriangleId> passed = FanTo(mesh, start, mesh.triangle(start).vertex(i), counter_clockwise, triangle);
      if (passed.empty()) continue;
      for (const TriangleId step : passed) walk.sleeve.Step(step);
      return true;
    }
  }
  return false;
}

std::optional<Point> WalkNearly(const FreeMesh& mesh, Point to, double tolerance, Walk& walk) {
  // Tried on a walk of its own, so that a failure leaves no trace and a success costs only what it crosses.
  Walk straight(Place{walk.at, walk.sleeve.back()});
  straight.rooted = !walk.is_free_to_turn();
  const auto blocked = WalkStraight(mesh, to, straight);
  if (!blocked) {
    if (walk.is_free_to_turn()) walk.sleeve = Sleeve(straight.sleeve.front());
    for (const TriangleId step : straight.sleeve.triangles()) walk.sleeve.Step(step);
    walk.at = to;
    return std::nullopt;
  }
  for (const VertexId vertex : mesh.VerticesNear(walk.at, to, tolerance)) {
    if (WalkStraight(mesh, mesh.point(vertex), walk)) return blocked;
  }
  return WalkStraight(mesh, to, walk) ? blocked : std::nullopt;
}

}  // namespace tautline
