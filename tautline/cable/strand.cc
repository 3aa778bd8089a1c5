#include "tautline/cable/strand.h"

#include <algorithm>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The side between two neighbouring triangles, seen by a traveller from the first to the second.
struct Portal {
  VertexId right, left;
};

Portal PortalBetween(const FreeMesh& mesh, TriangleId from, TriangleId to) {
  const Triangle& here = mesh.triangle(from);
  const int i = here.IndexOf(to);
  return {here.vertex(Next(i)), here.vertex(Previous(i))};
}

/// Whether the straight segment runs through all portals of the sleeve in order.
bool RunsStraight(const FreeMesh& mesh, Point first, Point second, const std::vector<TriangleId>& sleeve) {
  if (sleeve.size() == 1) return true;
  if (first == second) return false;  // Perhaps all the way around an obstacle.
  for (std::size_t k = 0; k + 1 < sleeve.size(); ++k) {
    const Portal portal = PortalBetween(mesh, sleeve[k], sleeve[k + 1]);
    const int right = Orientation(first, second, mesh.point(portal.right));
    const int left = Orientation(first, second, mesh.point(portal.left));
    // Along a portal the segment tells nothing of the direction in which it passes it.
    if (right > 0 || left < 0 || right == left) return false;
  }
  return true;
}

bool InClosedTriangle(const FreeMesh& mesh, TriangleId id, Point p) {
  const Triangle& triangle = mesh.triangle(id);
  const Point a = mesh.point(triangle.vertex(0)), b = mesh.point(triangle.vertex(1)),
              c = mesh.point(triangle.vertex(2));
  return Orientation(a, b, p) >= 0 && Orientation(b, c, p) >= 0 && Orientation(c, a, p) >= 0;
}

}  // namespace

void Strand::StepSecond(TriangleId next) {
  const std::size_t n = sleeve.size();
  if (sleeve[n - 1] == next) return;
  if (n >= 2 && sleeve[n - 2] == next) {
    sleeve.pop_back();
  } else {
    sleeve.push_back(next);
  }
}

void Strand::StepFirst(TriangleId next) {
  if (sleeve[0] == next) return;
  if (sleeve.size() >= 2 && sleeve[1] == next) {
    sleeve.erase(sleeve.begin());
  } else {
    sleeve.insert(sleeve.begin(), next);
  }
}

void PullTight(const FreeMesh& mesh, Point first, Point second, Strand& strand) {
  strand.bends.clear();
  if (RunsStraight(mesh, first, second, strand.sleeve)) {
    strand.length = Distance(first, second);
    return;
  }
  Walk walk(Place{first, strand.sleeve[0]});
  for (const TriangleId step : strand.sleeve) walk.sleeve.Step(step);
  walk.at = second;
  const TautCurve curve = PullTaut(mesh, walk);
  if (curve.points.size() > 2) strand.bends.assign(curve.points.begin() + 1, curve.points.end() - 1);
  strand.length = curve.length;
}

Strand StrandOf(const Walk& walk, const TautCurve& taut) {
  Strand strand(walk.sleeve.front());
  strand.sleeve.assign(walk.sleeve.triangles().begin(), walk.sleeve.triangles().end());
  if (taut.points.size() > 2) strand.bends.assign(taut.points.begin() + 1, taut.points.end() - 1);
  strand.length = taut.length;
  return strand;
}

void Join(Strand& strand, const Strand& other) {
  for (const TriangleId step : other.sleeve) strand.StepSecond(step);
}

Point MoveInto(const FreeMesh& mesh, TriangleId triangle, Point p) {
  if (InClosedTriangle(mesh, triangle, p)) return p;
  const Triangle& t = mesh.triangle(triangle);
  const Point a = mesh.point(t.vertex(0)), b = mesh.point(t.vertex(1)), c = mesh.point(t.vertex(2));
  const Point middle = (1.0 / 3) * (a + b + c);
  for (double share = 0x1p-52; share < 1; share *= 4) {
    const Point moved = Lerp(p, middle, share);
    if (InClosedTriangle(mesh, triangle, moved)) return moved;
  }
  // A triangle so thin that no double is inside: its vertices are.
  return std::min({a, b, c}, [p](Point u, Point v) { return Distance(p, u) < Distance(p, v); });
}

bool StrandCursor::HasPassed(std::size_t portal, double share) {
  const Portal sides = PortalBetween(mesh_, strand_.sleeve[portal], strand_.sleeve[portal + 1]);
  const Point right = mesh_.point(sides.right), left = mesh_.point(sides.left);
  // The portals that end in a knot follow each other, and the curve crosses all of them there, perhaps through more
  // than half a turn: the sides of portals tell only about the straight pieces between knots.
  if (at_knot_ && knot_ <= strand_.bends.size() && right != Knot(knot_) && left != Knot(knot_)) {
    ++knot_;
    at_knot_ = false;
  }
  at_knot_ = at_knot_ || right == Knot(knot_) || left == Knot(knot_);
  if (at_knot_ || knot_ != bends_passed_ + 1) return knot_ <= bends_passed_;
  // Where the straight piece crosses the portal. Along a portal, or nearly so, rounding puts that anywhere on it, and
  // then both triangles are right for what lies beside it.
  const Point along = Knot(knot_) - from_;
  const double from_right = Cross(right - from_, along), from_left = Cross(along, left - from_);
  const double sum = from_right + from_left;
  const Point crossing = sum > 0 ? Lerp(right, left, std::clamp(from_right / sum, 0.0, 1.0)) : right;
  return Dot(crossing - from_, along) < share * Dot(along, along);
}

void StrandCursor::MoveTo(double s) {
  if (s >= strand_.length) {
    place_ = second_;
    position_ = strand_.sleeve.size() - 1;
    bends_passed_ = strand_.bends.size();
    return;
  }
  double piece = Distance(from_, Knot(bends_passed_ + 1));
  while (bends_passed_ < strand_.bends.size() && passed_m_ + piece <= s) {
    passed_m_ += piece;
    from_ = Knot(++bends_passed_);
    piece = Distance(from_, Knot(bends_passed_ + 1));
  }
  const double share = piece > 0 ? std::clamp((s - passed_m_) / piece, 0.0, 1.0) : 0;
  while (position_ + 1 < strand_.sleeve.size() && HasPassed(position_, share)) ++position_;
  const TriangleId triangle = strand_.sleeve[position_];
  place_ = {MoveInto(mesh_, triangle, Lerp(from_, Knot(bends_passed_ + 1), share)), triangle};
}

void SlideFirst(const FreeMesh& mesh, Place& first, Place second, double by, Strand& strand, Strand* before) {
  StrandCursor cursor(mesh, first, second, strand);
  cursor.MoveTo(by);
  first = cursor.place();
  const auto passed = static_cast<std::ptrdiff_t>(cursor.position());
  if (passed > 0) {
    if (before != nullptr) {
      for (std::ptrdiff_t k = 1; k <= passed; ++k) before->StepSecond(strand.sleeve[static_cast<std::size_t>(k)]);
    }
    strand.sleeve.erase(strand.sleeve.begin(), strand.sleeve.begin() + passed);
  }
  PullTight(mesh, first.point, second.point, strand);
}

void SlideSecond(const FreeMesh& mesh, Place first, Place& second, double by, Strand& strand, Strand* after) {
  StrandCursor cursor(mesh, first, second, strand);
  cursor.MoveTo(strand.length - by);
  second = cursor.place();
  const std::size_t kept = cursor.position() + 1;
  if (kept < strand.sleeve.size()) {
    if (after != nullptr) {
      for (std::size_t k = strand.sleeve.size() - 1; k-- > kept - 1;) after->StepFirst(strand.sleeve[k]);
    }
    strand.sleeve.resize(kept, strand.sleeve[0]);
  }
  PullTight(mesh, first.point, second.point, strand);
}

}  // namespace tautline
