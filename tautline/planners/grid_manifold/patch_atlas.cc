#include "tautline/planners/grid_manifold/patch_atlas.h"

#include <algorithm>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/patch_cutter.h"

namespace tautline {

PatchAtlas::PatchAtlas(const CellGround& ground, Connectivity connectivity, const TileReach& reach)
    : connectivity_(connectivity) {
  PatchCutter(ground, reach, *this).Cut();
}

std::optional<PatchAtlas::Place> PatchAtlas::FindPlace(GridCell cell) const {
  const int number = cell.row / kTileSide * tile_columns_ + cell.column / kTileSide;
  const auto tile = static_cast<std::size_t>(number);
  const int in_tile = cell.row % kTileSide * kTileSide + cell.column % kTileSide;
  for (PatchNumber patch = first_patch_[tile]; patch < first_patch_[tile + 1]; ++patch) {
    if ((shape(patch).cells >> in_tile & 1) != 0) return Place{patch, in_tile};
  }
  return std::nullopt;
}

PatchAtlas::Place PatchAtlas::PlaceOf(GridCell cell) const {
  const auto place = FindPlace(cell);
  TAUTLINE_CHECK(place.has_value());
  return *place;
}

GridCell PatchAtlas::CellOf(Place place) const {
  const auto tile = static_cast<int>(patches_[place.patch].tile);
  return {tile % tile_columns_ * kTileSide + place.cell % kTileSide,
          tile / tile_columns_ * kTileSide + place.cell / kTileSide};
}

WordTrie::WordNumber PatchAtlas::WordOf(Place place) const {
  auto part = std::lower_bound(parts_.begin(), parts_.end(), place.patch,
                               [](const Part& a, PatchNumber patch) { return a.patch < patch; });
  for (; part != parts_.end() && part->patch == place.patch; ++part) {
    if ((part->cells >> place.cell & 1) != 0) return part->word;
  }
  return WordTrie::kEmpty;
}

std::size_t PatchAtlas::bytes() const {
  return patches_.capacity() * sizeof(Patch) + first_patch_.capacity() * sizeof(PatchNumber) +
         shapes_.capacity() * sizeof(Shape) + links_.capacity() * sizeof(Link) +
         crossings_.capacity() * sizeof(Crossing) + parts_.capacity() * sizeof(Part) + words_.bytes();
}

}  // namespace tautline
