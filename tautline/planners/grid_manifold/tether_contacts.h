// The contact vertices of a manifold [Igarashi2010, Sec. 4.4].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_TETHER_CONTACTS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_TETHER_CONTACTS_H_

#include <vector>

#include "tautline/planners/grid_manifold/deadlocks.h"

namespace tautline {

/// Every contact, nearest to the base first; equally far ones by page and cell. O(cells + vertices + contacts log
/// contacts).
std::vector<TetherContact> FindTetherContacts(const GridManifold& manifold);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_TETHER_CONTACTS_H_
