// A free space prepared for taut curves: mesh, corners, reduced visibility graph and rays.
#ifndef TAUTLINE_HOMOTOPY_TAUT_SPACE_H_
#define TAUTLINE_HOMOTOPY_TAUT_SPACE_H_

#include <optional>
#include <span>

#include "tautline/homotopy/corners.h"
#include "tautline/homotopy/cover.h"
#include "tautline/homotopy/free_mesh.h"
#include "tautline/homotopy/rays.h"
#include "tautline/homotopy/taut.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/homotopy/visibility_graph.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Where a polyline leaves the free space.
struct Departure {
  std::size_t segment = 0;  ///< By its first point; 0 as well when the first point of all is outside.
  /// The place itself, metres.
  Point at;
};

/// Everything that queries share. Immutable after construction; safe to use from several threads.
class TautSpace {
 public:
  /// O(n log n) for the mesh and the size of all corners' sight for the graph.
  /// Throws Stopped when `watch` says stop.
  explicit TautSpace(FreeSpace space, const Watcher& watch = {});

  /// The same where what the corners see is known: that of graph().sight() of an equal space. O(n log n).
  TautSpace(FreeSpace space, const SightList& sight);

  /// The free space that it was made from.
  const FreeSpace& free_space() const { return space_; }
  /// Its triangulation.
  const FreeMesh& mesh() const { return mesh_; }
  /// Where taut curves can bend.
  const Corners& corners() const { return corners_; }
  /// The lines that taut curves run along.
  const VisibilityGraph& graph() const { return graph_; }
  /// What words are read from.
  const Rays& rays() const { return rays_; }

  /// Points and segments that are outside of the free space by no more than this are moved onto its boundary, metres.
  double tolerance() const { return tolerance_; }

  /// Where p is in the closed free space, or nothing. O(1) expected.
  std::optional<Place> Locate(Point p) const { return mesh_.Locate(p, tolerance_); }

  /// Follows a polyline through the free space, from its first point or from where `walk` stands; says where it
  /// leaves it, if it does. Requires at least one point.
  std::optional<Departure> Follow(std::span<const Point> polyline, std::optional<Walk>& walk) const;

  /// The taut curve of a walk, with its word.
  TautPath Pull(const Walk& walk) const;

  /// The taut curve as it is handed out: points, length and word of `points`.
  TautPath MakePath(Polyline points) const;

 private:
  FreeSpace space_;
  FreeMesh mesh_;
  Corners corners_;
  VisibilityGraph graph_;
  Rays rays_;
  double tolerance_;
};

/// A polyline pulled tight, or where it leaves the free space.
struct Shortened {
  /// Its taut curve; empty when it leaves the free space.
  TautPath path;
  /// Where it leaves the free space, if it does.
  std::optional<Departure> departure;
};

/// Pulls a polyline tight in its class. Requires a point. O(triangles crossed).
Shortened Shorten(const TautSpace& space, std::span<const Point> polyline);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_TAUT_SPACE_H_
