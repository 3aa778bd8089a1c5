// Ray words as input: the class that a word names.
#ifndef TAUTLINE_HOMOTOPY_WORD_PATH_H_
#define TAUTLINE_HOMOTOPY_WORD_PATH_H_

#include <optional>

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// The taut path from one place to another whose reduced ray word is `word`; nothing when no path between them has that
/// word, which happens only where an island lies in another component of the free space. The word is drawn as a
/// polyline around the representative points, and that is pushed out of the obstacles, around each of them on the
/// side, and as often, as their representatives ask for. Requires that the places are connected. O(letters * triangles
/// across the map) without columns shared by many rays.
std::optional<TautPath> FindWordPath(const TautSpace& space, Place from, Place to, const Word& word);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_WORD_PATH_H_
