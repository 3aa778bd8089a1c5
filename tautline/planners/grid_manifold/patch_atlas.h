// The ground cut into patches: pieces of tiles on which words do not change.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_ATLAS_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_ATLAS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tautline/planners/grid_manifold/cell_ground.h"
#include "tautline/planners/grid_manifold/tile_relaxation.h"
#include "tautline/planners/grid_manifold/tile_steps.h"
#include "tautline/planners/grid_manifold/word_trie.h"

namespace tautline {

/// The free cells of each tile of 8 x 8, by connected pieces: patches. Every cell of a patch has a word of its own,
/// such that steps inside the patch from the word w of the patch lead from w * (word of one cell) to w * (word of the
/// other). So a patch needs one word for all of its cells, although rays may pass through it. Steps that do not fit,
/// because patch and step go round an island, and steps to other tiles are links, which change the word of the patch.
class PatchAtlas {
 public:
  using PatchNumber = std::uint32_t;  ///< The number of a patch.

  /// The steps of a link in one direction.
  struct Crossing {
    TileMask from = 0;          ///< The cells that have such a step.
    std::int8_t direction = 0;  ///< Of the step.
    std::int8_t offset = 0;     ///< The number of the cell it leads to, less that of the cell it comes from.

    /// Whether both are equal.
    friend bool operator==(const Crossing&, const Crossing&) = default;
  };
  /// All steps from one patch to another that change the word in one way.
  struct Link {
    std::uint32_t ahead = 0;            ///< How much larger the number of the patch is that they lead to, modulo 2^32.
    WordTrie::WordNumber word = 0;      ///< What they append to the word of the patch, in words().
    std::uint32_t first_crossing = 0;   ///< Its crossings.
    std::uint16_t back = 0;             ///< Which link of that patch leads back.
    std::uint8_t crossings = 0;         ///< How many.
    std::uint8_t open_side = kNotOpen;  ///< The direction of a straight step across the side of a tile, where both
                                        ///< patches are whole tiles and all steps between them belong to the link.
  };
  static constexpr std::uint8_t kNotOpen = 0xff;  ///< Of links that are less than that.
  /// What patches of one form share.
  struct Shape {
    TileMask cells = 0;                       ///< Those of the patch.
    TileMoves moves{};                        ///< The steps inside of it.
    std::array<std::uint8_t, 64> position{};  ///< By cell of the patch, how many of its cells come before.
    std::uint8_t count = 0;                   ///< How many cells it has.
    bool open = false;                        ///< A rectangle with all steps.
  };
  /// A cell of a patch.
  struct Place {
    PatchNumber patch = 0;  ///< The patch.
    int cell = 0;           ///< The cell in its tile.
  };

  /// Cuts the ground within reach into patches. O(tiles + patches within reach * rays through them).
  PatchAtlas(const CellGround& ground, Connectivity connectivity, const TileReach& reach);

  /// How robots step in it.
  Connectivity connectivity() const { return connectivity_; }
  /// How many patches there are.
  std::size_t size() const { return patches_.size(); }
  /// The form of a patch.
  const Shape& shape(PatchNumber patch) const { return shapes_[patches_[patch].shape]; }
  /// Where its steps lead. Patches in the open share their links.
  std::span<const Link> links(PatchNumber patch) const {
    return std::span<const Link>(links_).subspan(patches_[patch].first_link, patches_[patch].links);
  }
  /// The patch that a link of a patch leads to.
  static PatchNumber LinkedTo(PatchNumber patch, const Link& link) { return patch + link.ahead; }
  /// The steps of a link.
  std::span<const Crossing> crossings(const Link& link) const {
    return std::span<const Crossing>(crossings_).subspan(link.first_crossing, link.crossings);
  }
  /// The words that links and cells use.
  const WordTrie& words() const { return words_; }

  /// The place of a cell; nothing where it is blocked or out of reach. O(patches of its tile).
  std::optional<Place> FindPlace(GridCell cell) const;
  /// The same where there is one.
  Place PlaceOf(GridCell cell) const;
  /// The cell of the ground that a cell of a patch is.
  GridCell CellOf(Place place) const;
  /// The word of a cell in its patch. O(log n).
  WordTrie::WordNumber WordOf(Place place) const;

  /// The memory it holds.
  std::size_t bytes() const;

 private:
  friend class PatchCutter;

  struct Patch {
    std::uint32_t tile = 0;
    std::uint32_t shape = 0;
    std::uint32_t first_link = 0;
    std::uint32_t links = 0;
  };
  /// Cells of one word in a patch that has several.
  struct Part {
    PatchNumber patch = 0;
    WordTrie::WordNumber word = 0;
    TileMask cells = 0;
  };

  Connectivity connectivity_;
  int tile_columns_ = 0;
  std::vector<Patch> patches_;            ///< By tile.
  std::vector<PatchNumber> first_patch_;  ///< By tile; one more at the end.
  std::vector<Shape> shapes_;
  std::vector<Link> links_;
  std::vector<Crossing> crossings_;
  std::vector<Part> parts_;  ///< By patch, for those with several.
  WordTrie words_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_ATLAS_H_
