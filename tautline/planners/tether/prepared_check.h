// What must hold for the content of a prepared map before anything is built from it.
#ifndef TAUTLINE_PLANNERS_TETHER_PREPARED_CHECK_H_
#define TAUTLINE_PLANNERS_TETHER_PREPARED_CHECK_H_

#include "tautline/homotopy/visibility_graph.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Throws std::logic_error unless every number of the free space is finite, every vertex lies on its grid and within
/// its box, every ring has three vertices and no edge without length, and every obstacle is one of its islands. That
/// rings do not cross and have free ground on their left is found when the mesh is built. O(n).
void CheckPreparedSpace(const FreeSpace& space);

/// Throws std::logic_error unless the list tells of as many sightings as it holds, each of another corner, on a side,
/// and sorted. O(n).
void CheckPreparedSight(const SightList& sight);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_PREPARED_CHECK_H_
