// Ray words as input: the class that a word names.
#ifndef TAUTLINE_HOMOTOPY_WORD_PATH_H_
#define TAUTLINE_HOMOTOPY_WORD_PATH_H_

#include <cstdint>
#include <optional>

#include "tautline/homotopy/taut_space.h"

namespace tautline {

struct WordPathOptions {
  std::int64_t budget = 1'000'000;  ///< Triangles of the cover that may be looked at.
};

struct WordPath {
  std::optional<TautPath> path;  ///< The taut path of the class.
  bool budget_exceeded = false;  ///< Nothing was found within the budget. Every reduced word names a class between two
                                 ///< points of a free space whose islands all lie in one component; others may not.
};

/// The taut path from one place to another whose reduced ray word is `word`. Searches the dual tree of the universal
/// cover, nearest word first; a class is one node of that tree, so the first match is the only one. Requires both
/// places in one component.
WordPath FindWordPath(const TautSpace& space, Place from, Place to, const Word& word,
                      const WordPathOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_WORD_PATH_H_
