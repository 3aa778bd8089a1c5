#include "tautline/homotopy/visibility.h"

#include <algorithm>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Expands a cone of sight through the sides of free triangles. Cones are closed and may be a single ray, so that
/// sight along touching obstacles is kept.
class Expansion {
 public:
  Expansion(const FreeMesh& mesh, const Corners& corners, Point eye, const Corner* own)
      : mesh_(mesh), corners_(corners), eye_(eye), own_(own) {}

  /// Everything in free triangle `id` and through its sides, from an eye in its interior.
  void LookAround(TriangleId id) {
    for (int i = 0; i < 3; ++i) {
      See(id, i);
      LookThroughSide(id, i);
    }
  }

  /// The two vertices and everything through the side opposite to vertex i, from an eye on that vertex.
  void LookFromVertex(TriangleId id, int i) {
    See(id, Next(i));
    See(id, Previous(i));
    LookThroughSide(id, i);
  }

  /// As LookAround, from an eye on the side opposite to vertex i.
  void LookFromSide(TriangleId id, int i) {
    for (int k = 0; k < 3; ++k) See(id, k);
    LookThroughSide(id, Next(i));
    LookThroughSide(id, Previous(i));
  }

  std::vector<Sighting> Finish() {
    std::sort(sightings_.begin(), sightings_.end());
    sightings_.erase(std::unique(sightings_.begin(), sightings_.end()), sightings_.end());
    return std::move(sightings_);
  }

 private:
  /// A side of a free triangle with the part of it in sight: between the rays through `right` and `left`.
  struct Window {
    TriangleId triangle;
    int side;
    Point right;
    Point left;
  };

  void LookThroughSide(TriangleId id, int side) {
    Push({id, side, mesh_.triangulation().corner(id, Next(side)), mesh_.triangulation().corner(id, Previous(side))});
    while (!windows_.empty()) {
      const Window window = windows_.back();
      windows_.pop_back();
      LookInto(window);
    }
  }

  /// Adds the window unless its side is a wall or no taut curve from the own corner can pass it.
  void Push(const Window& window) {
    if (mesh_.triangle(window.triangle).is_constrained(window.side)) return;
    if (own_ != nullptr && Orientation(own_->previous, eye_, window.right) > 0 &&
        Orientation(own_->next, eye_, window.left) < 0) {
      return;
    }
    windows_.push_back(window);
  }

  void LookInto(const Window& window) {
    const TriangleId id = mesh_.triangle(window.triangle).neighbour(window.side);
    const int apex = mesh_.triangle(id).IndexOf(window.triangle);
    const Point c = mesh_.triangulation().corner(id, apex);
    const int from_right = Orientation(eye_, window.right, c), from_left = Orientation(eye_, window.left, c);
    if (from_right >= 0 && from_left <= 0) See(id, apex);
    // In this triangle the entered side runs from its left end, Next(apex), to its right end, Previous(apex).
    if (from_right >= 0) Push({id, Next(apex), window.right, from_left <= 0 ? c : window.left});
    if (from_left <= 0) Push({id, Previous(apex), from_right >= 0 ? c : window.right, window.left});
  }

  void See(TriangleId id, int i) {
    const CornerId corner = corners_.At(id, i);
    if (!corner.valid() || corners_[corner].point == eye_) return;
    const Side tail = own_ == nullptr ? Side::kNone : TailSide(corners_[corner].point);
    if (own_ != nullptr && tail == Side::kNone) return;
    const Side head = corners_[corner].TangentFrom(eye_);
    if (head != Side::kNone) sightings_.push_back({corner, tail, head});
  }

  /// The side of the own obstacle for a traveller who leaves towards p; kNone when no taut curve can.
  Side TailSide(Point p) const {
    const Side seen_backwards = own_->TangentFrom(p);
    return Opposite(seen_backwards);
  }

  const FreeMesh& mesh_;
  const Corners& corners_;
  Point eye_;
  const Corner* own_;
  std::vector<Window> windows_;
  std::vector<Sighting> sightings_;
};

/// The first triangle, clockwise, of the free sector at a vertex that holds a triangle.
TriangleId FirstOfSector(const FreeMesh& mesh, VertexId vertex, TriangleId at) {
  for (;;) {
    const int side = Previous(mesh.triangle(at).IndexOf(vertex));
    if (mesh.triangle(at).is_constrained(side)) return at;
    at = mesh.triangle(at).neighbour(side);
  }
}

/// Looks through all triangles of a sector, from its first one, counter-clockwise.
void LookFromSector(const FreeMesh& mesh, VertexId vertex, TriangleId first, Expansion& expansion) {
  for (TriangleId at = first;;) {
    const int i = mesh.triangle(at).IndexOf(vertex);
    expansion.LookFromVertex(at, i);
    if (mesh.triangle(at).is_constrained(Next(i))) return;
    at = mesh.triangle(at).neighbour(Next(i));
  }
}

}  // namespace

std::vector<Sighting> SeeFromPoint(const FreeMesh& mesh, const Corners& corners, Place place) {
  Expansion expansion(mesh, corners, place.point, nullptr);
  const Triangle& here = mesh.triangle(place.triangle);
  for (int i = 0; i < 3; ++i) {
    const Point a = mesh.triangulation().corner(place.triangle, Next(i));
    const Point b = mesh.triangulation().corner(place.triangle, Previous(i));
    if (mesh.point(here.vertex(i)) == place.point) {
      LookFromSector(mesh, here.vertex(i), FirstOfSector(mesh, here.vertex(i), place.triangle), expansion);
      return expansion.Finish();
    }
    if (a == place.point || b == place.point || Orientation(a, b, place.point) != 0) continue;
    expansion.LookFromSide(place.triangle, i);
    const TriangleId across = here.neighbour(i);
    if (mesh.IsFree(across)) expansion.LookFromSide(across, mesh.triangle(across).IndexOf(place.triangle));
    return expansion.Finish();
  }
  expansion.LookAround(place.triangle);
  return expansion.Finish();
}

std::vector<Sighting> SeeFromCorner(const FreeMesh& mesh, const Corners& corners, CornerId id) {
  const Corner& corner = corners[id];
  Expansion expansion(mesh, corners, corner.point, &corner);
  LookFromSector(mesh, corner.vertex, corner.first, expansion);
  return expansion.Finish();
}

}  // namespace tautline
