// The universal cover of the triangulated free space: homotopy classes as sleeves.
#ifndef TAUTLINE_HOMOTOPY_COVER_H_
#define TAUTLINE_HOMOTOPY_COVER_H_

#include <optional>
#include <span>
#include <vector>

#include "tautline/homotopy/free_mesh.h"

namespace tautline {

/// A walk in the dual graph of the free triangles without immediate backtracking: the canonical form of a homotopy
/// class from its first triangle to its last. It is the one path in the dual tree of the universal cover.
class Sleeve {
 public:
  /// The class that stays in a triangle.
  explicit Sleeve(TriangleId first) : triangles_{first} {}

  /// Steps to a neighbouring triangle (or stays), cancelling a step that is undone. O(1).
  void Step(TriangleId next) {
    const std::size_t n = triangles_.size();
    if (triangles_[n - 1] == next) return;
    if (n >= 2 && triangles_[n - 2] == next) {
      triangles_.pop_back();
    } else {
      triangles_.push_back(next);
    }
  }

  /// The triangles in the order of the walk, each a neighbour of the one before it.
  std::span<const TriangleId> triangles() const { return triangles_; }
  /// The first triangle.
  TriangleId front() const { return triangles_.front(); }
  /// The last triangle.
  TriangleId back() const { return triangles_.back(); }
  /// How many triangles; at least one.
  std::size_t size() const { return triangles_.size(); }

  /// The same class walked from its end to its start. O(n).
  Sleeve Reversed() const;

  /// Whether both pass the same triangles: walks between the same ends are then of one class.
  friend bool operator==(const Sleeve&, const Sleeve&) = default;

 private:
  std::vector<TriangleId> triangles_;
};

/// A walk through the free space: where it is, and the class that took it there.
struct Walk {
  /// A walk that has not left its start.
  explicit Walk(Place start) : from(start.point), at(start.point), sleeve(start.triangle) {}

  Point from;           ///< Where the walk began, in the first triangle of the sleeve.
  Point at;             ///< Where the walk stands, in the last triangle of the sleeve.
  Sleeve sleeve;        ///< Its class.
  bool rooted = false;  ///< On a vertex with several free sectors, it must leave by that of its first triangle.

  /// Whether it may still leave its first point by any sector.
  bool is_free_to_turn() const { return !rooted && sleeve.size() == 1 && from == at; }
};

/// Walks along the straight segment from walk.at to `to`, which may graze boundaries and pass along them. Exact.
/// A walk that has not left its first point, and is not rooted, may start in any sector there. Nothing when it arrived;
/// otherwise the place where the segment leaves the free space, and the walk stands in the last free triangle before
/// it. O(triangles crossed).
std::optional<Point> WalkStraight(const FreeMesh& mesh, Point to, Walk& walk);

/// Turns a walk on the spot into a free triangle that holds the place where it stands: around a vertex within its
/// sector, or across the edge that it stands on. False, and nothing done, when the triangle is not to be had so.
/// O(degree).
bool TurnInto(const FreeMesh& mesh, TriangleId triangle, Walk& walk);

/// As WalkStraight, but a segment that cuts a corner by up to `tolerance` metres is led around it.
std::optional<Point> WalkNearly(const FreeMesh& mesh, Point to, double tolerance, Walk& walk);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_COVER_H_
