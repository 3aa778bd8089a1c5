// A cell of sight cut by the rays of the words.
#ifndef TAUTLINE_PLANNERS_TETHER_CELL_SLABS_H_
#define TAUTLINE_PLANNERS_TETHER_CELL_SLABS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/homotopy/free_mesh.h"
#include "tautline/planners/tether/cone_sight.h"
#include "tautline/planners/tether/region_ring.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// The columns of rays that pass each free triangle, above the start of a ray.
class RayCuts {
 public:
  /// Columns no farther than `sliver` metres beside a triangle pass it, too.
  RayCuts(const FreeSpace& space, const FreeMesh& mesh, double sliver);

  /// The columns, x in metres, from left to right.
  std::span<const double> In(TriangleId id) const {
    return std::span(columns_).subspan(first_[id.index()], first_[id.index() + 1] - first_[id.index()]);
  }

 private:
  std::vector<double> columns_;
  std::vector<std::size_t> first_;
};

/// A piece of a cell, within its disc, that no ray crosses: all of it has one word.
struct CellSlab {
  Point sample;                     ///< A point strictly inside, apart from the disc.
  double area = 0;                  ///< Square metres.
  std::vector<RegionPiece> pieces;  ///< Its share in the boundary of a sheet: walls, arcs and cuts.
};

struct SlabOptions {
  Disc disc;          ///< About the eye of the cell.
  double join = 0;    ///< Metres; what reaches less deep into the disc is rounding.
  double sliver = 0;  ///< Metres; slabs no wider than this are rounding and go to their neighbour.
};

/// The slabs of a cell from left to right, without those beyond the disc. Where a cell ends at another, no piece is
/// made.
std::vector<CellSlab> SlabsOf(const FreeMesh& mesh, const RayCuts& cuts, const SightCell& cell,
                              const SlabOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_CELL_SLABS_H_
