#include "tautline/homotopy/socket.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// A segment, or what is left of it.
struct Part {
  Point a;
  Point b;
};

/// Cuts off what lies on the right of the line from `tail` to `tip`; false when nothing is left. What is cut is decided
/// exactly, where it is cut is rounded.
bool KeepLeft(Point tail, Point tip, Part& part) {
  const int side_a = Orientation(tail, tip, part.a), side_b = Orientation(tail, tip, part.b);
  if (side_a < 0 && side_b < 0) return false;
  if (side_a >= 0 && side_b >= 0) return true;
  const double at_a = Cross(tip - tail, part.a - tail), at_b = Cross(tip - tail, part.b - tail);
  const double share = at_a == at_b ? 0.5 : std::clamp(at_a / (at_a - at_b), 0.0, 1.0);
  const Point cut = Lerp(part.a, part.b, share);
  (side_a < 0 ? part.a : part.b) = cut;
  return true;
}

/// The point of the grown free space nearest to an eye outside of it, among those that the eye sees through the ungrown
/// one: cones of sight spread through the sides of its triangles, as in SeeFromPoint, and each is searched for
/// boundaries of the grown space. [Bungiu2014]
class ExitSearch {
 public:
  /// Looks no farther than `radius` metres.
  ExitSearch(const FreeMesh& grown, const FreeMesh& ungrown, Point eye, double radius)
      : grown_(grown), mesh_(ungrown), eye_(eye), radius_(radius) {}

  /// Nothing when no exit is in sight within the radius.
  std::optional<Point> Run(Place place) {
    for (const TriangleId id : TrianglesAt(place)) {
      for (int i = 0; i < 3; ++i) {
        const Point right = CornerAt(id, Next(i)), left = CornerAt(id, Previous(i));
        if (Orientation(right, left, eye_) > 0) Look({id, i, right, left});
      }
    }
    return exit_;
  }

 private:
  /// A side of a free triangle with the part of it in sight: between the rays through `right` and `left`, which may be
  /// one. All of the cone as far as the side is seen.
  struct Window {
    TriangleId triangle;
    int side;
    Point right;
    Point left;
  };

  Point CornerAt(TriangleId id, int i) const { return mesh_.triangulation().corner(id, i); }

  /// The free triangles that hold the eye: all sectors of a vertex, both sides of an edge.
  std::vector<TriangleId> TrianglesAt(Place place) const {
    std::vector<TriangleId> triangles{place.triangle};
    const Triangle& here = mesh_.triangle(place.triangle);
    for (int i = 0; i < 3; ++i) {
      if (mesh_.point(here.vertex(i)) == eye_) {
        triangles.clear();
        mesh_.ForEachFreeAround(here.vertex(i), [&](TriangleId id, int) { triangles.push_back(id); });
        return triangles;
      }
      const bool on_side =
          Orientation(CornerAt(place.triangle, Next(i)), CornerAt(place.triangle, Previous(i)), eye_) == 0;
      if (on_side && !here.is_constrained(i)) triangles.push_back(here.neighbour(i));
    }
    return triangles;
  }

  void Look(const Window& first) {
    std::vector<Window> windows{first};
    while (!windows.empty()) {
      const Window window = windows.back();
      windows.pop_back();
      SearchBefore(window);
      const TriangleId id = mesh_.triangle(window.triangle).neighbour(window.side);
      if (mesh_.triangle(window.triangle).is_constrained(window.side) || IsBeyond(window)) continue;
      const int apex = mesh_.triangle(id).IndexOf(window.triangle);
      const Point c = CornerAt(id, apex);
      const int from_right = Orientation(eye_, window.right, c), from_left = Orientation(eye_, window.left, c);
      // In this triangle the entered side runs from its left end, Next(apex), to its right end, Previous(apex).
      if (from_right >= 0) windows.push_back({id, Next(apex), window.right, from_left <= 0 ? c : window.left});
      if (from_left <= 0) windows.push_back({id, Previous(apex), from_right >= 0 ? c : window.right, window.left});
    }
  }

  bool InCone(const Window& window, Part& part) const {
    return KeepLeft(eye_, window.right, part) && KeepLeft(window.left, eye_, part);
  }

  /// Whether the window is farther away than the radius or the best exit.
  bool IsBeyond(const Window& window) const {
    Part side{CornerAt(window.triangle, Next(window.side)), CornerAt(window.triangle, Previous(window.side))};
    return InCone(window, side) && DistanceToSegment(eye_, side.a, side.b) > radius_;
  }

  /// Finds exits in the cone, in the window's triangle; what is nearer was searched before.
  void SearchBefore(const Window& window) {
    Box box;
    for (int i = 0; i < 3; ++i) box.Add(CornerAt(window.triangle, i));
    const Point reach{radius_, radius_}, low = eye_ - reach, high = eye_ + reach;
    box.low = {std::max(box.low.x, low.x), std::max(box.low.y, low.y)};
    box.high = {std::min(box.high.x, high.x), std::min(box.high.y, high.y)};
    if (box.low.x > box.high.x || box.low.y > box.high.y) return;
    const Point right = CornerAt(window.triangle, Next(window.side));
    const Point left = CornerAt(window.triangle, Previous(window.side));
    grown_.ForEachBoundaryNear(box, [&](Point a, Point b) {
      Part part{a, b};
      if (InCone(window, part) && KeepLeft(right, left, part)) Offer(NearestOnSegment(eye_, part.a, part.b), window);
    });
  }

  void Offer(Point exit, const Window& window) {
    // Where the cone is one ray, its line goes on behind the eye.
    if (Dot(exit - eye_, window.right - eye_) < 0 && Dot(exit - eye_, window.left - eye_) < 0) return;
    const double distance = Distance(eye_, exit);
    if (distance > radius_ || (exit_ && distance == radius_ && !(exit < *exit_))) return;
    radius_ = distance;
    exit_ = exit;
  }

  const FreeMesh& grown_;
  const FreeMesh& mesh_;
  Point eye_;
  double radius_;  ///< That of the best exit, once there is one.
  std::optional<Point> exit_;
};

}  // namespace

std::optional<Socket> FindSocket(const TautSpace& space, const FreeMesh& ungrown, Point base) {
  if (const auto place = space.Locate(base)) return Socket{place->point, *place, 0};
  const auto start = ungrown.Locate(base, space.tolerance());
  if (!start) return std::nullopt;
  // Exits are near as a rule, so that little of the ground must be looked at.
  const Point size = space.free_space().box.size();
  const double farthest = size.x + size.y;
  for (double radius = 2 * space.free_space().clearance;; radius *= 2) {
    const auto exit = ExitSearch(space.mesh(), ungrown, start->point, radius).Run(*start);
    if (exit) {
      if (const auto place = space.Locate(*exit)) return Socket{base, *place, Distance(base, place->point)};
    }
    if (!(radius > 0) || radius > farthest) return std::nullopt;
  }
}

}  // namespace tautline
