// The configuration-space manifold of a tethered robot on a grid [Igarashi2010, Sec. 3].
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_GRID_MANIFOLD_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_GRID_MANIFOLD_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tautline/base/stop.h"
#include "tautline/homotopy/word.h"
#include "tautline/planners/grid_manifold/cell_ground.h"
#include "tautline/planners/grid_manifold/chunked_array.h"
#include "tautline/planners/grid_manifold/lattice_distance.h"
#include "tautline/planners/grid_manifold/patch_atlas.h"

namespace tautline {

/// Calls `work` on ranges that together are [0, count), possibly several at a time, and returns when all are done. An
/// empty one means one range in the calling thread.
using ParallelRanges =
    std::function<void(std::size_t count, const std::function<void(std::size_t begin, std::size_t end)>& work)>;

/// What a manifold is built for, and when building gives up.
struct ManifoldOptions {
  GridCell base;                                     ///< Where the tether is tied.
  double length_m = 0;                               ///< Of the tether: 0 or more, metres.
  Connectivity connectivity = Connectivity::kEight;  ///< How the robot steps.
  std::int64_t max_vertices = 200'000'000;           ///< Vertices after which to stop.
  std::int64_t max_bytes = std::int64_t{8} << 30;    ///< Memory after which to stop.
  KeepGoing keep_going = {};                         ///< At a no, building stops as at a budget.
  ParallelRanges parallel = {};                      ///< The result does not depend on it, to the bit.
};

/// What building stopped at.
enum class ManifoldStop {
  kNone,      ///< The manifold is complete.
  kVertices,  ///< max_vertices.
  kBytes,     ///< max_bytes.
  kAsked,     ///< keep_going said no.
  kDistance,  ///< The tether is longer than kFarthestCells cells, and there are vertices that far.
};

/// A vertex: a page of the manifold and a cell in it. Only the manifold that gave it out knows it.
struct ManifoldVertex {
  std::uint32_t page = 0;  ///< A patch with a word.
  int cell = 0;            ///< Of its tile.

  /// Whether both are equal.
  friend bool operator==(const ManifoldVertex&, const ManifoldVertex&) = default;
};

/// How large a manifold is.
struct ManifoldCounts {
  std::int64_t vertices = 0;               ///< Pairs of cell and word.
  std::int64_t edges = 0;                  ///< Steps between them, each counted once.
  std::vector<std::int64_t> multiplicity;  ///< How many cells carry 1, 2, 3 ... vertices.
  LatticeDistance farthest = 0;            ///< The largest distance from the base.
};

/// All (cell, word) whose shortest way from the base is no longer than the tether: one vertex for each homotopy class
/// of each cell. Two vertices are joined when a step leads from one to the other. Immutable; safe to read from several
/// threads. About 6 to 15 bytes a vertex.
class GridManifold {
 public:
  /// Builds the manifold from the base outwards. Where it stops early, it has all vertices up to some distance and none
  /// beyond it. Requires a free base. O(vertices) where the length is small against 2^31 / kStraightStep cells.
  static GridManifold Build(CellGround ground, const ManifoldOptions& options);

  /// The ground.
  const CellGround& ground() const { return ground_; }
  /// How it is cut.
  const PatchAtlas& atlas() const { return atlas_; }
  /// Where the tether is tied.
  GridCell base() const { return base_; }
  /// The tether's length, metres.
  double length_m() const { return length_m_; }
  /// The largest distance that a vertex may have.
  LatticeDistance limit() const { return limit_; }
  /// Why building stopped; then all vertices nearer than complete_up_to() are there and no others.
  ManifoldStop stop() const { return stop_; }
  /// Every vertex nearer than this is there; one more than limit() when the manifold is complete.
  LatticeDistance complete_up_to() const { return complete_up_to_; }

  /// The vertices, edges and multiplicities. O(vertices).
  ManifoldCounts Count() const;
  /// How many vertices each cell of the ground carries, by its index in the grid. O(vertices).
  std::vector<std::uint32_t> Multiplicity() const;

  /// How many pages there are; their numbers are the ones below.
  std::size_t pages() const { return page_count_; }
  /// The patch of a page.
  PatchAtlas::PatchNumber patch(std::uint32_t page) const { return pages_[page].patch; }
  /// The cells of a page that are vertices.
  TileMask vertices(std::uint32_t page) const { return pages_[page].cells; }
  /// Whether there is such a vertex.
  bool Has(ManifoldVertex v) const { return (pages_[v.page].cells >> v.cell & 1) != 0; }
  /// The base itself.
  ManifoldVertex base_vertex() const { return {0, atlas_.PlaceOf(base_).cell}; }
  /// Its distance from the base.
  LatticeDistance distance(ManifoldVertex v) const {
    return values_[pages_[v.page].first_value + atlas_.shape(patch(v.page)).position[static_cast<std::size_t>(v.cell)]];
  }
  /// The same in metres.
  double DistanceM(ManifoldVertex v) const { return CellsOf(distance(v)) * ground_.cell_m(); }
  /// The cell that it lies in.
  GridCell CellOf(ManifoldVertex v) const { return atlas_.CellOf({patch(v.page), v.cell}); }
  /// The word of its shortest ways. O(letters).
  Word WordOf(ManifoldVertex v) const;
  /// The vertices of a cell, nearest first. O(pages of its patch).
  std::vector<ManifoldVertex> VerticesAt(GridCell cell) const;
  /// The vertex that a word leads to, or nothing. O(letters + vertices of the cell).
  std::optional<ManifoldVertex> Find(GridCell cell, const Word& word) const;
  /// The vertex that a step leads to, or nothing. Requires Has(v). O(1).
  std::optional<ManifoldVertex> Step(ManifoldVertex v, int direction) const {
    const PatchAtlas::Shape& shape = atlas_.shape(patch(v.page));
    if ((shape.moves[static_cast<std::size_t>(direction)] >> v.cell & 1) == 0) return StepOut(v, direction);
    const ManifoldVertex to{v.page, v.cell + OffsetOf(static_cast<std::size_t>(direction))};
    return Has(to) ? std::optional(to) : std::nullopt;
  }

  /// The page that a link of a page leads to, or kNoPage.
  std::uint32_t linked(std::uint32_t page, std::size_t link) const { return links_[pages_[page].first_link + link]; }
  static constexpr std::uint32_t kNoPage = 0xffffffffU;  ///< No page.

  /// Where the distances of a page begin, in an array of value_count() of them: those of its patch's cells in order.
  std::size_t first_value(std::uint32_t page) const { return pages_[page].first_value; }
  /// The length of an array with a value for every vertex.
  std::size_t value_count() const { return values_.end(); }
  /// The memory it holds.
  std::size_t bytes() const;

 private:
  friend class ManifoldBuilder;
  friend class ManifoldFile;
  friend class ManifoldFileContent;

  struct Page {
    WordTrie::WordNumber word = 0;
    PatchAtlas::PatchNumber patch = 0;
    std::uint32_t first_value = 0;
    std::uint32_t first_link = 0;
    LatticeDistance key = kUnreached;  ///< While building: the least distance that it was given and has not handed on.
    LatticeDistance queued = kUnreached;  ///< While building: the key that it was put into a bucket with.
    TileMask cells = 0;                   ///< While building: cells whose neighbours are to hear of them.
  };

  GridManifold(CellGround ground, const ManifoldOptions& options);
  void IndexPages();
  std::optional<ManifoldVertex> StepOut(ManifoldVertex v, int direction) const;

  CellGround ground_;
  GridCell base_;
  double length_m_ = 0;
  LatticeDistance limit_ = 0;
  PatchAtlas atlas_;
  LatticeDistance complete_up_to_ = 0;
  ManifoldStop stop_ = ManifoldStop::kNone;

  WordTrie words_;
  std::size_t page_count_ = 0;
  ChunkedArray<Page> pages_;
  ChunkedArray<LatticeDistance> values_;
  ChunkedArray<std::uint32_t> links_;
  std::vector<std::uint32_t> page_table_;  ///< While building: open addressing over (patch, word).
  std::vector<std::uint32_t> first_of_patch_, pages_of_patch_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_GRID_MANIFOLD_H_
