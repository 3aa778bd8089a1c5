// Where the tether, caught by an obstacle, can lock the robot in [Igarashi2010, Sec. 4.4].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_DEADLOCKS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_DEADLOCKS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// A contact vertex: a blocked cell shares a side or a corner with its cell, and none does with that of its parent.
/// Ground outside of the grid is blocked.
struct TetherContact {
  ManifoldVertex vertex;               ///< Where the tether comes to the obstacle.
  std::optional<ObstacleId> obstacle;  ///< The island that it touches first; nothing: it touches walls only.
  std::size_t run = 0;  ///< Contacts of one run touch each other and one obstacle: the number of the nearest of them.
};

/// A contact that locks the robot in on one side of its tether.
struct Deadlock {
  std::size_t contact = 0;       ///< Its number among the contacts.
  std::int64_t region = 0;       ///< Vertices on that side.
  LatticeDistance farthest = 0;  ///< The way from the contact to the farthest of them.
  std::int64_t beyond = 0;       ///< Those that are farther from the base than the contact: 1 or more.
  std::int64_t closed = 0;       ///< Those of them that this deadlock was the first to close.
};

/// What a manifold has of deadlocks. It refers to its manifold, which must outlive it. 1 bit a vertex.
class DeadlockAreas {
 public:
  /// Looks at every contact that is not closed yet, nearest first. The path from it to the base is a tether; a side is
  /// all that can be reached from the contact without entering or crossing the cells of the path. A side from which
  /// the robot comes round to the other side of the path is not separated, and neither is ground behind the contact
  /// that lies on no side. A contact is resolvable on a side where the way from it to the farthest vertex is longer
  /// than what the tether has left: going there pulls the tether off. Other sides are deadlocks, if they have vertices
  /// that are farther from the base than the contact, and close those. Where `keep_going` says no, later contacts are
  /// left out. O(vertices + contacts * vertices within the tether's rest of them); 5 bytes a vertex and a cell
  /// meanwhile.
  explicit DeadlockAreas(const GridManifold& manifold, const KeepGoing& keep_going = {});

  /// All contacts, nearest to the base first; equally far ones by page and cell.
  const std::vector<TetherContact>& contacts() const { return contacts_; }
  /// The deadlocks, in the order of their contacts.
  const std::vector<Deadlock>& deadlocks() const { return deadlocks_; }
  /// Contacts before this one were looked at: all, unless it was stopped.
  std::size_t examined() const { return examined_; }
  /// Whether a vertex can be locked in. Requires that the manifold has it.
  bool IsClosed(ManifoldVertex v) const { return closed_[ValueOf(v)]; }
  /// How many are closed.
  std::int64_t closed_vertices() const { return closed_count_; }
  /// How many cells have vertices, all of which are closed. O(vertices).
  std::int64_t LostCells() const;

 private:
  friend class DeadlockSearch;

  std::size_t ValueOf(ManifoldVertex v) const {
    const auto& shape = manifold_.atlas().shape(manifold_.patch(v.page));
    return manifold_.first_value(v.page) + shape.position[static_cast<std::size_t>(v.cell)];
  }

  const GridManifold& manifold_;
  std::vector<TetherContact> contacts_;
  std::vector<Deadlock> deadlocks_;
  std::size_t examined_ = 0;
  std::vector<bool> closed_;  ///< By value.
  std::int64_t closed_count_ = 0;
};

/// The neighbour of a vertex that is next on the way to the base: of those on shortest ways the nearest to the base, of
/// equally near ones the first direction. Nothing for the base. O(1).
std::optional<int> DirectionToBase(const GridManifold& manifold, ManifoldVertex v);

/// The vertices from v to the base by DirectionToBase, both included. O(steps).
std::vector<ManifoldVertex> PathToBase(const GridManifold& manifold, ManifoldVertex v);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_DEADLOCKS_H_
