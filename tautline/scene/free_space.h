// The free space of a scene: walls and obstacles merged and grown by the clearance, as clean polygons with names.
#ifndef TAUTLINE_SCENE_FREE_SPACE_H_
#define TAUTLINE_SCENE_FREE_SPACE_H_

#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/geometry/polygon.h"
#include "tautline/scene/obstacle_id.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// One closed boundary curve of the free space. The free space lies on its left: outer rings run counter-clockwise,
/// rings around obstacles clockwise. No vertex is collinear with its neighbours; a ring may touch itself or another
/// ring in a point that is a vertex of either, never cross.
struct BoundaryRing {
  Ring points;          ///< Metres.
  ObstacleId obstacle;  ///< The island that it bounds; invalid when it bounds (something merged with) the wall.
};

/// A connected piece of the free space.
struct FreeComponent {
  BoundaryRing outer;               ///< Around it.
  std::vector<BoundaryRing> holes;  ///< Around the blocked ground inside it.
  double area = 0;                  ///< Square metres.
};

/// An island of blocked ground: a letter of the words of this free space.
struct Island {
  std::string name;                  ///< Of the first of `members`; a further piece of an obstacle that has no width
                                     ///< somewhere is called NAME_2, NAME_3, ...
  Point representative;              ///< Strictly inside; its upward ray writes the letter. That of the obstacle, where
                                     ///< it lies in this island.
  std::vector<std::string> members;  ///< Names of the obstacles merged into it, in the order of the scene.
  double area = 0;                   ///< Square metres, with clearance, without courtyards.
};

/// Obstacles that came to lie in one blocked piece of ground.
struct Merge {
  std::vector<std::string> members;  ///< In the order of the scene.
  bool with_wall = false;            ///< They are part of the wall and have no letter.
};

/// A boundary vertex that was moved onto another boundary nearer than the snap tolerance.
struct Snap {
  std::string obstacle;  ///< Whose vertex; "wall" for the outline.
  Point from;            ///< Where it was, metres.
  Point to;              ///< Where it is now.
  std::string onto;      ///< The obstacle (or "wall") that it was moved onto.
};

/// How the free space is made.
struct FreeSpaceOptions {
  /// Largest distance by which a rounded corner or a circle may be grown beyond the true arc, as a fraction of its
  /// radius.
  double arc_error = 0.01;
  /// Build with this clearance instead of the scene's.
  std::optional<double> clearance;
};

/// The closed free space: robot and tether may touch its boundary.
struct FreeSpace {
  std::vector<FreeComponent> components;  ///< Largest area first.
  std::vector<Island> islands;            ///< By ObstacleId, in the order of the scene; the alphabet of the words.
  std::vector<Merge> merges;              ///< In the order of their first members.
  std::vector<Snap> snaps;                ///< Every vertex that was moved.
  Box box;                                ///< Around the outline.
  double clearance = 0;                   ///< Metres, as built in.
  double snap = 0;                        ///< Metres, as used.
  double grid = 0;                        ///< The spacing of the coordinate grid that all vertices lie on, metres.

  /// The name of an island.
  const std::string& name(ObstacleId id) const { return islands[id.index()].name; }
};

/// Builds the free space of a world. Obstacles without a name get the one that a reader of scenes gives them. Errors:
/// no outline, or no area left inside it. O(n log n) for n vertices with few overlaps. All vertices are rounded to a
/// grid of about 1e-12 of the extent [Hobby1999]. Growth is never too small, and at most arc_error * clearance too
/// large, beyond that grid.
[[nodiscard]] Expected<FreeSpace> BuildFreeSpace(const World& world, const FreeSpaceOptions& options = {});

/// The depth in metres by which a point may lie outside of the free space and still be taken to be on its boundary:
/// what rounding of input and of printed results can cause, however far apart boundaries are joined.
double BoundaryTolerance(const FreeSpace& space);

/// Where the ray of an obstacle starts while it is an island of its own: at its representative, or else at the centre
/// of a circle or an InteriorPoint of a polygon. O(n).
Point RepresentativeOf(const Obstacle& obstacle);

/// Where a point is that is not free: "inside an obstacle or a wall", with the clearance when there is one.
std::string BlockedText(const FreeSpace& space);

/// The names of the islands, by ObstacleId.
std::vector<std::string> NamesOf(const FreeSpace& space);

/// The component that p lies in or on the boundary of, or nothing; `tolerance` metres count as touching. O(n).
std::optional<std::size_t> ComponentOf(const FreeSpace& space, Point p, double tolerance = 0);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_FREE_SPACE_H_
