#include "tautline/planners/grid_manifold/patch_atlas.h"

#include <algorithm>
#include <optional>
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
    FindLowestRays();
    patch_of_cell_.assign(ground_.grid().cells.size(), 0);
    word_of_cell_.assign(ground_.grid().cells.size(), WordTrie::kEmpty);
    for (int tile = 0; tile < tiles; ++tile) plain_.push_back(IsPlain(tile));
    for (int tile = 0; tile < tiles; ++tile) {
      atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
      CutTile(tile);
    }
    atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
    for (std::uint32_t patch = 0; patch < atlas_.patches_.size(); ++patch) AddLinks(patch);
    PairLinks();
  }

 private:
  using WordNumber = WordTrie::WordNumber;

  /// How low rays come down among the columns of a tile and at its sides.
  void FindLowestRays() {
    lowest_ray_.assign(static_cast<std::size_t>(atlas_.tile_columns_), ground_.rows());
    for (int column = 0; column < ground_.columns(); ++column) {
      for (const CellGround::Ray& ray : ground_.RaysBefore(column)) {
        int& lowest = lowest_ray_[static_cast<std::size_t>(column / kTileSide)];
        lowest = std::min(lowest, ray.above_row);
        if (column % kTileSide != 0 || column == 0) continue;
        int& before = lowest_ray_[static_cast<std::size_t>(column / kTileSide) - 1];
        before = std::min(before, ray.above_row);
      }
    }
  }

  /// Whether a tile is whole, free and crossed by no ray, also not on the way out of it.
  bool IsPlain(int tile) const {
    const GridCell low = CellAt(tile, 0), high = CellAt(tile, kTileCells - 1);
    if (high.column >= ground_.columns() || high.row >= ground_.rows()) return false;
    if (lowest_ray_[static_cast<std::size_t>(tile % atlas_.tile_columns_)] <= high.row) return false;
    const OccupancyGrid& grid = ground_.grid();
    for (int row = low.row; row <= high.row; ++row) {
      const auto first = grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.index(low.column, row));
      if (std::any_of(first, first + kTileSide, [](CellState cell) { return cell != CellState::kFree; })) return false;
    }
    return true;
  }

  /// Whether all tiles around a tile are plain, and itself.
  bool IsAmongPlain(int tile) const {
    const int column = tile % atlas_.tile_columns_, row = tile / atlas_.tile_columns_;
    if (column == 0 || row == 0 || column + 1 == atlas_.tile_columns_ || row + 1 == atlas_.tile_rows_) return false;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const int beside = tile + y * atlas_.tile_columns_ + x;
        if (!plain_[static_cast<std::size_t>(beside)]) return false;
      }
    }
    return true;
  }

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
    if (plain_[static_cast<std::size_t>(tile)] && open_shape_) {
      const GridCell low = CellAt(tile, 0);
      for (int row = 0; row < kTileSide; ++row) {
        const auto first =
            patch_of_cell_.begin() + static_cast<std::ptrdiff_t>(ground_.grid().index(low.column, low.row + row));
        std::fill(first, first + kTileSide, static_cast<std::uint32_t>(atlas_.patches_.size()));
      }
      atlas_.patches_.push_back({static_cast<std::uint32_t>(tile), *open_shape_, 0, 0});
      return;
    }
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
      const GridCell in_ground = CellAt(tile, cell);
      const std::size_t index = ground_.grid().index(in_ground.column, in_ground.row);
      patch_of_cell_[index] = patch;
      word_of_cell_[index] = words_of_[at];
      if (words_of_[at] != WordTrie::kEmpty) atlas_.cell_words_.push_back({patch, cell, words_of_[at]});
    }
    shape.open = shape.count == kTileCells && shape.moves == OpenMoves(step() == 1);
    const auto [found, added] = shape_numbers_.try_emplace(KeyOf(shape.moves) + KeyOf(shape.cells),
                                                           static_cast<std::uint32_t>(atlas_.shapes_.size()));
    if (added) atlas_.shapes_.push_back(shape);
    if (shape.open) open_shape_ = found->second;
    atlas_.patches_.push_back({static_cast<std::uint32_t>(tile), found->second, 0, 0});
  }

  /// What is appended to the word of the patch by a step.
  WordNumber Change(GridCell from, std::size_t d, GridCell to) {
    WordNumber word = AfterStep(word_of_cell_[ground_.grid().index(from.column, from.row)], from, d);
    WordNumber after = word_of_cell_[ground_.grid().index(to.column, to.row)];
    if (word == after) return WordTrie::kEmpty;
    for (; after != WordTrie::kEmpty; after = atlas_.words_.parent(after)) {
      word = atlas_.words_.Append(word, atlas_.words_.last(after) ^ 1);
    }
    return word;
  }

  /// The links of patches among plain tiles are all alike: they are found once and copied.
  void AddLinks(std::uint32_t patch) {
    const auto tile = static_cast<int>(atlas_.patches_[patch].tile);
    if (!IsAmongPlain(tile)) return FindLinks(patch);
    if (plain_links_.empty()) {
      FindLinks(patch);
      for (const PatchAtlas::Link& link : atlas_.links(patch)) {
        plain_links_.emplace_back(static_cast<int>(atlas_.patches_[link.to].tile) - tile, link);
      }
      return;
    }
    atlas_.patches_[patch].first_link = static_cast<std::uint32_t>(atlas_.links_.size());
    atlas_.patches_[patch].links = static_cast<std::uint32_t>(plain_links_.size());
    for (auto [offset, link] : plain_links_) {
      const int beside = tile + offset;
      link.to = atlas_.first_patch_[static_cast<std::size_t>(beside)];
      atlas_.links_.push_back(link);
    }
  }

  void FindLinks(std::uint32_t patch) {
    const PatchAtlas::Shape& shape = atlas_.shape(patch);
    const auto tile = static_cast<int>(atlas_.patches_[patch].tile);
    exits_.clear();
    for (std::size_t d = 0; d < kDirections; d += step()) {
      for (TileMask cells = shape.cells & ~shape.moves[d]; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctzll(cells);
        const GridCell at = CellAt(tile, cell), to{at.column + kStepColumns[d], at.row + kStepRows[d]};
        if (!ground_.CanStep(at, static_cast<int>(d))) continue;
        const int beside = to.row % kTileSide * kTileSide + to.column % kTileSide;
        exits_.push_back({patch_of_cell_[ground_.grid().index(to.column, to.row)], Change(at, d, to),
                          static_cast<std::int8_t>(d), static_cast<std::int8_t>(cell),
                          static_cast<std::int8_t>(beside - cell)});
      }
    }
    std::sort(exits_.begin(), exits_.end());
    atlas_.patches_[patch].first_link = static_cast<std::uint32_t>(atlas_.links_.size());
    for (std::size_t i = 0; i < exits_.size();) i = AddLink(i);
    atlas_.patches_[patch].links = static_cast<std::uint32_t>(atlas_.links_.size()) - atlas_.patches_[patch].first_link;
  }

  /// The link of an exit and of those after it that lead to the same page; the first exit of the next link.
  std::size_t AddLink(std::size_t first) {
    std::vector<PatchAtlas::Crossing> crossings;
    std::size_t i = first;
    for (; i < exits_.size() && exits_[i].to == exits_[first].to && exits_[i].word == exits_[first].word; ++i) {
      if (crossings.empty() || crossings.back().direction != exits_[i].direction) {
        crossings.push_back({0, exits_[i].direction, exits_[i].offset});
      }
      crossings.back().from |= TileMask{1} << exits_[i].cell;
    }
    atlas_.links_.push_back(
        {exits_[first].to, exits_[first].word, Intern(crossings), static_cast<std::uint32_t>(crossings.size()), 0});
    return i;
  }

  /// Finds for each link the one that leads back.
  void PairLinks() {
    for (std::uint32_t patch = 0; patch < atlas_.patches_.size(); ++patch) {
      for (std::uint32_t i = 0; i < atlas_.patches_[patch].links; ++i) {
        PatchAtlas::Link& link = atlas_.links_[atlas_.patches_[patch].first_link + i];
        const WordNumber back = Inverse(link.word);
        const auto others = atlas_.links(link.to);
        const auto found = std::find_if(others.begin(), others.end(), [&](const PatchAtlas::Link& other) {
          return other.to == patch && other.word == back;
        });
        TAUTLINE_CHECK(found != others.end());
        link.back = static_cast<std::uint32_t>(found - others.begin());
      }
    }
  }

  WordNumber Inverse(WordNumber word) {
    WordNumber inverse = WordTrie::kEmpty;
    for (; word != WordTrie::kEmpty; word = atlas_.words_.parent(word)) {
      inverse = atlas_.words_.Append(inverse, atlas_.words_.last(word) ^ 1);
    }
    return inverse;
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

  /// A step out of a patch.
  struct Exit {
    std::uint32_t to = 0;
    WordNumber word = 0;
    std::int8_t direction = 0, cell = 0, offset = 0;

    friend bool operator<(const Exit& a, const Exit& b) {
      return std::tie(a.to, a.word, a.direction, a.cell) < std::tie(b.to, b.word, b.direction, b.cell);
    }
  };

  const CellGround& ground_;
  PatchAtlas& atlas_;
  std::vector<std::uint32_t> patch_of_cell_;  ///< By cell of the ground.
  std::vector<WordNumber> word_of_cell_;      ///< Within the patch.
  std::vector<Exit> exits_;
  std::vector<int> lowest_ray_;  ///< By column of tiles; the number of rows where there is none.
  std::vector<bool> plain_;      ///< By tile.
  std::optional<std::uint32_t> open_shape_;
  std::vector<std::pair<int, PatchAtlas::Link>> plain_links_;  ///< With how much later their tiles come.
  std::array<WordNumber, kTileCells> words_of_{};
  std::unordered_map<std::string, std::uint32_t> shape_numbers_, crossing_numbers_;
};

PatchAtlas::PatchAtlas(const CellGround& ground, Connectivity connectivity) : connectivity_(connectivity) {
  PatchCutter(ground, *this).Cut();
}

PatchAtlas::Place PatchAtlas::PlaceOf(GridCell cell) const {
  const int number = cell.row / kTileSide * tile_columns_ + cell.column / kTileSide;
  const auto tile = static_cast<std::size_t>(number);
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
