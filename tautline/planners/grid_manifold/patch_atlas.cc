#include "tautline/planners/grid_manifold/patch_atlas.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr int kTileCells = kTileSide * kTileSide;

/// Bytes as a key, for things that many patches share.
template <class T>
std::string KeyOf(const T& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

/// Builds an atlas tile by tile: first patches and the words of their cells, then links.
class PatchCutter {
 public:
  PatchCutter(const CellGround& ground, PatchAtlas& atlas) : ground_(ground), atlas_(atlas) {}

  void Cut() {
    atlas_.tile_columns_ = (ground_.columns() + kTileSide - 1) / kTileSide;
    atlas_.tile_rows_ = (ground_.rows() + kTileSide - 1) / kTileSide;
    const int tiles = atlas_.tile_columns_ * atlas_.tile_rows_;
    for (int tile = 0; tile < tiles; ++tile) {
      atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
      CutTile(tile);
    }
    atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
    for (std::uint32_t patch = 0; patch < atlas_.patches_.size(); ++patch) AddLinks(patch);
  }

 private:
  using WordNumber = WordTrie::WordNumber;

  std::size_t step() const { return atlas_.connectivity_ == Connectivity::kEight ? 1 : 2; }

  GridCell CellAt(int tile, int cell) const {
    return {tile % atlas_.tile_columns_ * kTileSide + cell % kTileSide,
            tile / atlas_.tile_columns_ * kTileSide + cell / kTileSide};
  }

  static bool StaysInTile(int cell, std::size_t d) {
    const int column = cell % kTileSide + kStepColumns[d], row = cell / kTileSide + kStepRows[d];
    return column >= 0 && column < kTileSide && row >= 0 && row < kTileSide;
  }

  /// The word after a step. A diagonal one is taken by way of a free cell beside it: where both are free, no island is
  /// between.
  WordNumber AfterStep(WordNumber word, GridCell from, std::size_t d) {
    const int dx = kStepColumns[d];
    if (dx == 0) return word;
    const bool level_first = ground_.IsFree({from.column + dx, from.row});
    const int row = level_first ? from.row : from.row + kStepRows[d];
    const auto rays = ground_.RaysBefore(std::max(from.column, from.column + dx));
    const auto cross = [&](const CellGround::Ray& ray) {
      if (ray.above_row < row) word = atlas_.words_.Append(word, 2 * ray.obstacle.value() + (dx < 0 ? 1 : 0));
    };
    if (dx > 0) {
      for (const CellGround::Ray& ray : rays) cross(ray);
    } else {
      for (std::size_t i = rays.size(); i-- > 0;) cross(rays[i]);
    }
    return word;
  }

  void CutTile(int tile) {
    TileMask left = 0;
    for (int cell = 0; cell < kTileCells; ++cell) {
      if (ground_.IsFree(CellAt(tile, cell))) left |= TileMask{1} << cell;
    }
    while (left != 0) left &= ~AddPatch(tile, __builtin_ctzll(left));
  }

  /// The patch of a cell: a search from it gives every cell the word of the way on which it is first reached.
  TileMask AddPatch(int tile, int start) {
    PatchAtlas::Shape shape;
    std::array<int, kTileCells> order{};
    words_of_.fill(WordTrie::kEmpty);
    order[0] = start;
    shape.cells = TileMask{1} << start;
    shape.count = 1;
    for (int i = 0; i < shape.count; ++i) {
      const int cell = order[static_cast<std::size_t>(i)];
      const GridCell at = CellAt(tile, cell);
      for (std::size_t d = 0; d < kDirections; d += step()) {
        if (!StaysInTile(cell, d) || !ground_.CanStep(at, static_cast<int>(d))) continue;
        const int beside = cell + kStepRows[d] * kTileSide + kStepColumns[d];
        const WordNumber word = AfterStep(words_of_[static_cast<std::size_t>(cell)], at, d);
        if ((shape.cells >> beside & 1) == 0) {
          shape.cells |= TileMask{1} << beside;
          words_of_[static_cast<std::size_t>(beside)] = word;
          order[shape.count++] = beside;
        }
        // Also backwards later, when the search comes to `beside`.
        if (words_of_[static_cast<std::size_t>(beside)] == word) shape.moves[d] |= TileMask{1} << cell;
      }
    }
    FinishPatch(tile, shape);
    return shape.cells;
  }

  void FinishPatch(int tile, PatchAtlas::Shape& shape) {
    const auto patch = static_cast<std::uint32_t>(atlas_.patches_.size());
    std::uint8_t position = 0;
    for (int cell = 0; cell < kTileCells; ++cell) {
      if ((shape.cells >> cell & 1) == 0) continue;
      const auto at = static_cast<std::size_t>(cell);
      shape.position[at] = position++;
      if (words_of_[at] != WordTrie::kEmpty) atlas_.cell_words_.push_back({patch, cell, words_of_[at]});
    }
    shape.open = shape.moves == OpenMoves(atlas_.connectivity_ == Connectivity::kEight);
    const auto [found, added] = shape_numbers_.try_emplace(KeyOf(shape.moves) + KeyOf(shape.cells),
                                                           static_cast<std::uint32_t>(atlas_.shapes_.size()));
    if (added) atlas_.shapes_.push_back(shape);
    atlas_.patches_.push_back({static_cast<std::uint32_t>(tile), found->second, 0, 0});
  }

  /// What is appended to the word of the patch by a step from `from` to `to`.
  WordNumber Change(PatchAtlas::Place from, std::size_t d, PatchAtlas::Place to) {
    const WordNumber before = atlas_.WordOf(from), after = atlas_.WordOf(to);
    WordNumber word = AfterStep(before, atlas_.CellOf(from), d);
    for (WordNumber w = after; w != WordTrie::kEmpty; w = atlas_.words_.parent(w)) {
      word = atlas_.words_.Append(word, atlas_.words_.last(w) ^ 1);
    }
    return word;
  }

  void AddLinks(std::uint32_t patch) {
    const PatchAtlas::Shape shape = atlas_.shape(patch);
    std::map<std::tuple<std::uint32_t, WordNumber>, std::map<std::size_t, PatchAtlas::Crossing>> links;
    for (std::size_t d = 0; d < kDirections; d += step()) {
      for (TileMask cells = shape.cells & ~shape.moves[d]; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctzll(cells);
        const PatchAtlas::Place from{patch, cell};
        const GridCell at = atlas_.CellOf(from);
        if (!ground_.CanStep(at, static_cast<int>(d))) continue;
        const PatchAtlas::Place to = atlas_.PlaceOf({at.column + kStepColumns[d], at.row + kStepRows[d]});
        PatchAtlas::Crossing& crossing = links[{to.patch, Change(from, d, to)}][d];
        crossing.from |= TileMask{1} << cell;
        crossing.direction = static_cast<std::int8_t>(d);
        crossing.offset = static_cast<std::int8_t>(to.cell - cell);
      }
    }
    atlas_.patches_[patch].first_link = static_cast<std::uint32_t>(atlas_.links_.size());
    atlas_.patches_[patch].links = static_cast<std::uint32_t>(links.size());
    for (const auto& [target, by_direction] : links) {
      std::vector<PatchAtlas::Crossing> crossings;
      for (const auto& [d, crossing] : by_direction) crossings.push_back(crossing);
      atlas_.links_.push_back(
          {std::get<0>(target), std::get<1>(target), Intern(crossings), static_cast<std::uint32_t>(crossings.size())});
    }
  }

  /// Where these crossings stand; most patches have the same ones.
  std::uint32_t Intern(const std::vector<PatchAtlas::Crossing>& crossings) {
    std::string key;
    for (const PatchAtlas::Crossing& crossing : crossings) {
      key += KeyOf(crossing.from) + KeyOf(crossing.direction) + KeyOf(crossing.offset);
    }
    const auto [found, added] =
        crossing_numbers_.try_emplace(key, static_cast<std::uint32_t>(atlas_.crossings_.size()));
    if (added) atlas_.crossings_.insert(atlas_.crossings_.end(), crossings.begin(), crossings.end());
    return found->second;
  }

  const CellGround& ground_;
  PatchAtlas& atlas_;
  std::array<WordNumber, kTileCells> words_of_{};
  std::unordered_map<std::string, std::uint32_t> shape_numbers_, crossing_numbers_;
};

PatchAtlas::PatchAtlas(const CellGround& ground, Connectivity connectivity) : connectivity_(connectivity) {
  PatchCutter(ground, *this).Cut();
}

PatchAtlas::Place PatchAtlas::PlaceOf(GridCell cell) const {
  const auto tile = static_cast<std::size_t>(cell.row / kTileSide * tile_columns_ + cell.column / kTileSide);
  const int in_tile = cell.row % kTileSide * kTileSide + cell.column % kTileSide;
  for (PatchNumber patch = first_patch_[tile]; patch < first_patch_[tile + 1]; ++patch) {
    if ((shape(patch).cells >> in_tile & 1) != 0) return {patch, in_tile};
  }
  TAUTLINE_CHECK(false);
}

GridCell PatchAtlas::CellOf(Place place) const {
  const auto tile = static_cast<int>(patches_[place.patch].tile);
  return {tile % tile_columns_ * kTileSide + place.cell % kTileSide,
          tile / tile_columns_ * kTileSide + place.cell / kTileSide};
}

WordTrie::WordNumber PatchAtlas::WordOf(Place place) const {
  const auto found = std::lower_bound(
      cell_words_.begin(), cell_words_.end(), place,
      [](const CellWord& a, const Place& b) { return std::pair(a.patch, a.cell) < std::pair(b.patch, b.cell); });
  if (found == cell_words_.end() || found->patch != place.patch || found->cell != place.cell) return WordTrie::kEmpty;
  return found->word;
}

std::size_t PatchAtlas::bytes() const {
  return patches_.capacity() * sizeof(Patch) + first_patch_.capacity() * sizeof(PatchNumber) +
         shapes_.capacity() * sizeof(Shape) + links_.capacity() * sizeof(Link) +
         crossings_.capacity() * sizeof(Crossing) + cell_words_.capacity() * sizeof(CellWord) + words_.bytes();
}

}  // namespace tautline
