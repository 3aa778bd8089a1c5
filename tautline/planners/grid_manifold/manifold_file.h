// A manifold as bytes: built once for a map, loaded where it is used.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_FILE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_FILE_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/planners/grid_manifold/grid_manifold.h"

namespace tautline {

/// Writes and reads what building a manifold found: its pages, their words and their distances. The bytes are a line
/// that names the format and its version, a line with the checksum of the rest, and integers, least byte first; the
/// same on every machine.
class ManifoldFile {
 public:
  /// The manifold of a world; `world` is its digest (WorldDigest). O(vertices).
  static std::string Write(const GridManifold& manifold, std::uint64_t world);

  /// The manifold that was written, as Build(ground, options) would make it, with the budgets that it was made with:
  /// only those of `options` that change the manifold itself are looked at. Errors: not such a file, of another
  /// version, damaged, or made for another world, other cells, another base, length or connectivity. O(cells +
  /// vertices), without a search.
  [[nodiscard]] static Expected<GridManifold> Read(std::string_view bytes, std::uint64_t world, CellGround ground,
                                                   const ManifoldOptions& options);
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_MANIFOLD_FILE_H_
