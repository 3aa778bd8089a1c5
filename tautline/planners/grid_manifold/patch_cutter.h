// How the ground is cut into patches: tile by tile, by operations on sets of cells.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_CUTTER_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_CUTTER_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tautline/planners/grid_manifold/patch_atlas.h"

namespace tautline {

/// Builds an atlas: first the patches and the words of their cells, then the links.
class PatchCutter {
 public:
  /// Prepares to fill an atlas that is empty.
  PatchCutter(const CellGround& ground, const TileReach& reach, PatchAtlas& atlas);

  /// Everything.
  void Cut();

 private:
  using WordNumber = WordTrie::WordNumber;
  using PatchNumber = PatchAtlas::PatchNumber;
  using Part = PatchAtlas::Part;

  /// How far a tile is from anything that makes it special.
  enum class Openness : std::uint8_t {
    kNone,   ///< Not whole, or a ray is near.
    kPlain,  ///< It is whole and free, and no ray is near.
    kAmong,  ///< So are all tiles around it: its links are the plain ones.
    kDeep,   ///< Those around it are kAmong: its links lead back as everywhere.
  };

  /// A link while its steps are collected: at most one crossing for each direction.
  struct GrowingLink {
    PatchNumber to = 0;
    WordNumber word = 0;
    std::uint8_t count = 0;
    std::array<PatchAtlas::Crossing, kDirections> crossings{};
  };

  void FindLowestRays();
  bool HasRay(int tile) const;
  void FindOpenness();
  bool AllBeside(int tile, Openness least) const;
  GridCell CellAt(int tile, int cell) const;
  TileMoves RayCrossings(int tile) const;
  WordNumber AfterStep(WordNumber word, GridCell from, std::size_t d);
  WordNumber Quotient(WordNumber word, WordNumber divisor);

  void CutTile(int tile);
  void CutAcrossRays(int tile, TileMask cells, const TileMoves& inside);
  void AddPatch(int tile, TileMask cells, const TileMoves& moves);
  std::uint32_t ShapeNumber(TileMask cells, const TileMoves& moves);
  std::span<const Part> PartsOf(PatchNumber patch, Part& whole) const;

  void LinkTile(int tile);
  void KeepPlainLinks(PatchNumber patch);
  void CopyPlainLinks(PatchNumber patch);
  void SharePlainLinks(PatchNumber patch);
  void FindLinks(PatchNumber patch, const TileMoves& steps, const TileMoves& crossings);
  void AddExits(PatchNumber patch, std::size_t d, TileMask from, const TileMoves& crossings);
  void AddExitsTo(PatchNumber patch, std::size_t d, TileMask from, int offset, int to_tile, TileMask across);
  void AddSteps(PatchNumber to, WordNumber word, std::size_t d, int offset, TileMask from);
  void StoreLinks(PatchNumber patch);
  std::uint8_t OpenSide(PatchNumber patch, const GrowingLink& link) const;
  std::uint32_t CrossingNumber(const GrowingLink& link);
  void PairLinks();

  const CellGround& ground_;
  PatchAtlas& atlas_;
  TileSteps steps_;
  std::vector<int> lowest_at_;             ///< By column, the row above which the lowest ray before it runs.
  std::vector<int> lowest_ray_;            ///< By column of tiles; the number of rows where there is none.
  std::vector<Openness> openness_;         ///< By tile.
  std::vector<std::uint32_t> first_part_;  ///< By patch; kNone where it has one word.
  std::optional<std::uint32_t> open_shape_;
  std::vector<std::pair<int, PatchAtlas::Link>> plain_links_;  ///< With how much later their tiles come.
  std::uint32_t shared_north_ = 0, shared_south_ = 0;  ///< How far ahead patches to the north and south are for the...
  std::uint32_t shared_links_ = 0xffffffffU;           ///< ...links that were shared last.
  std::vector<GrowingLink> growing_;
  std::unordered_map<std::uint64_t, std::uint32_t> shape_numbers_, crossing_numbers_;  ///< By a hash of what they are.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_PATCH_CUTTER_H_
