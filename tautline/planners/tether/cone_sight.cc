#include "tautline/planners/tether/cone_sight.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Whether there is anything between two lines through one eye.
bool IsOpen(const SightLine& right, const SightLine& left, Point eye) {
  return left.tip == eye ? left.SideOf(right.tip) < 0 : right.SideOf(left.tip) > 0;
}

/// Spreads cones of sight through the sides of free triangles as far as a disc reaches.
class Spread {
 public:
  Spread(const FreeMesh& mesh, const Disc& disc) : mesh_(mesh), disc_(disc) {}

  SightLine LineTo(Point p) const { return {disc_.centre, p}; }

  /// Adds the part of a triangle at the eye between two lines, and all that is seen through its side `exit`.
  void Add(const SightCell& cell, int exit) {
    if (!IsOpen(cell.right, cell.left, disc_.centre)) return;
    cells_.push_back(cell);
    Push(cell, exit);
    while (!windows_.empty()) {
      const Window window = windows_.back();
      windows_.pop_back();
      Enter(window);
    }
  }

  /// The whole view through one side of a triangle that holds the eye.
  void AddThroughSide(TriangleId id, int side) {
    const Point right = mesh_.triangulation().corner(id, Next(side));
    const Point left = mesh_.triangulation().corner(id, Previous(side));
    Add({id, LineTo(right), LineTo(left)}, side);
  }

  std::vector<SightCell> Finish() { return std::move(cells_); }

 private:
  /// A cell, and the side through which to look on.
  struct Window {
    SightCell cell;
    int side;
  };

  void Push(const SightCell& cell, int side) {
    if (mesh_.triangle(cell.triangle).is_constrained(side)) return;
    if (!IsOpen(cell.right, cell.left, disc_.centre)) return;
    const auto part = PartInCone(mesh_, cell, side);
    if (!part) return;
    const Point a = Lerp(part->low, part->high, part->from), b = Lerp(part->low, part->high, part->to);
    if (DistanceToSegment(disc_.centre, a, b) >= disc_.radius) return;
    windows_.push_back({cell, side});
  }

  void Enter(const Window& window) {
    const TriangleId id = mesh_.triangle(window.cell.triangle).neighbour(window.side);
    const int apex = mesh_.triangle(id).IndexOf(window.cell.triangle);
    const Point c = mesh_.triangulation().corner(id, apex);
    const SightLine right = window.cell.right, left = window.cell.left;
    const int from_right = right.SideOf(c), from_left = left.SideOf(c);
    cells_.push_back({id, right, left});
    // The entered side runs from its left end, Next(apex), to its right end, Previous(apex).
    if (from_right > 0) Push({id, right, from_left < 0 ? LineTo(c) : left}, Next(apex));
    if (from_left < 0) Push({id, from_right > 0 ? LineTo(c) : right, left}, Previous(apex));
  }

  const FreeMesh& mesh_;
  const Disc disc_;
  std::vector<SightCell> cells_;
  std::vector<Window> windows_;
};

/// The free triangles around a vertex from one of them on, counter-clockwise, up to the next wall.
std::vector<TriangleId> Fan(const FreeMesh& mesh, VertexId vertex, TriangleId first) {
  std::vector<TriangleId> fan{first};
  for (;;) {
    const Triangle& at = mesh.triangle(fan.back());
    const int across = Next(at.IndexOf(vertex));
    if (at.is_constrained(across) || at.neighbour(across) == first) return fan;
    fan.push_back(at.neighbour(across));
  }
}

/// The first triangle, clockwise, of the free sector at a vertex that holds a triangle.
TriangleId FirstOfSector(const FreeMesh& mesh, VertexId vertex, TriangleId at) {
  for (;;) {
    const int side = Previous(mesh.triangle(at).IndexOf(vertex));
    if (mesh.triangle(at).is_constrained(side)) return at;
    at = mesh.triangle(at).neighbour(side);
  }
}

/// Fractions of the way from a to b on the side of `line` where `sign` * SideOf >= 0, cut out of [from, to].
bool ClipBy(const SightLine& line, int sign, SidePart& part) {
  const int a = sign * line.SideOf(part.low), b = sign * line.SideOf(part.high);
  if (a >= 0 && b >= 0) return true;
  if (a <= 0 && b <= 0) return false;
  const Point along = line.tip - line.tail;
  const double at_low = Cross(along, part.low - line.tail), at_high = Cross(along, part.high - line.tail);
  const double crossing = std::clamp(at_low / (at_low - at_high), 0.0, 1.0);
  if (a < 0) {
    part.from = std::max(part.from, crossing);
  } else {
    part.to = std::min(part.to, crossing);
  }
  return part.from < part.to;
}

}  // namespace

int SightLine::SideOf(Point p) const { return Orientation(tail, tip, p); }

std::vector<SightCell> SeeAround(const FreeMesh& mesh, Place place, const Disc& disc) {
  Spread spread(mesh, disc);
  const Triangle& here = mesh.triangle(place.triangle);
  for (int i = 0; i < 3; ++i) {
    const VertexId vertex = here.vertex(i);
    if (mesh.point(vertex) != place.point) continue;
    for (const TriangleId id : Fan(mesh, vertex, FirstOfSector(mesh, vertex, place.triangle))) {
      spread.AddThroughSide(id, mesh.triangle(id).IndexOf(vertex));
    }
    return spread.Finish();
  }
  for (int i = 0; i < 3; ++i) {
    const Point a = mesh.triangulation().corner(place.triangle, Next(i));
    const Point b = mesh.triangulation().corner(place.triangle, Previous(i));
    if (Orientation(a, b, place.point) != 0) {
      spread.AddThroughSide(place.triangle, i);
    } else if (const TriangleId across = here.neighbour(i); mesh.IsFree(across) && !here.is_constrained(i)) {
      const int back = mesh.triangle(across).IndexOf(place.triangle);
      spread.AddThroughSide(across, Next(back));
      spread.AddThroughSide(across, Previous(back));
    }
  }
  return spread.Finish();
}

std::vector<SightCell> SeeBeyond(const FreeMesh& mesh, const Turn& turn, const Disc& disc) {
  const Corner& corner = *turn.corner;
  std::vector<TriangleId> fan = Fan(mesh, corner.vertex, corner.first);
  Spread spread(mesh, disc);
  const SightLine straight{turn.from, corner.point};
  const bool left = turn.head == Side::kLeft;
  // From the obstacle's face back to the straight continuation.
  if (left) std::reverse(fan.begin(), fan.end());
  for (const TriangleId id : fan) {
    const int i = mesh.triangle(id).IndexOf(corner.vertex);
    const Point right_end = mesh.triangulation().corner(id, Next(i));
    const Point left_end = mesh.triangulation().corner(id, Previous(i));
    const int right_side = straight.SideOf(right_end), left_side = straight.SideOf(left_end);
    if (left ? left_side <= 0 : right_side >= 0) break;
    SightCell cell{id, spread.LineTo(right_end), spread.LineTo(left_end)};
    const bool last = left ? right_side <= 0 : left_side >= 0;
    if (last && left) cell.right = straight;
    if (last && !left) cell.left = straight;
    spread.Add(cell, i);
    if (last) break;
  }
  return spread.Finish();
}

std::optional<SidePart> PartInCone(const FreeMesh& mesh, const SightCell& cell, int i) {
  SidePart part{mesh.triangulation().corner(cell.triangle, Next(i)),
                mesh.triangulation().corner(cell.triangle, Previous(i)), 0, 1};
  if (part.high < part.low) std::swap(part.low, part.high);
  if (!ClipBy(cell.right, 1, part) || !ClipBy(cell.left, -1, part)) return std::nullopt;
  return part;
}

std::optional<SidePart> PartInDisc(const SidePart& part, const Disc& disc) {
  const Chord chord = ChordOf(disc, part.low, part.high);
  if (!chord.crosses) return std::nullopt;
  const double length = Distance(part.low, part.high);
  const double middle = Dot(chord.along, chord.foot - part.low);
  SidePart inside = part;
  inside.from = std::max(part.from, (middle - chord.half) / length);
  inside.to = std::min(part.to, (middle + chord.half) / length);
  if (inside.from >= inside.to) return std::nullopt;
  return inside;
}

std::vector<AngleSpan> ArcsIn(const FreeMesh& mesh, const SightCell& cell, const Disc& disc) {
  const AngleRange right = LeftOfLine(disc, cell.right.tail, cell.right.tip);
  std::vector<AngleSpan> arcs{{right.middle - right.half, right.middle + right.half}};
  arcs = Intersect(arcs, LeftOfLine(disc, cell.left.tip, cell.left.tail));
  for (int i = 0; i < 3 && !arcs.empty(); ++i) {
    arcs = Intersect(arcs, LeftOfLine(disc, mesh.triangulation().corner(cell.triangle, Next(i)),
                                      mesh.triangulation().corner(cell.triangle, Previous(i))));
  }
  return arcs;
}

}  // namespace tautline
