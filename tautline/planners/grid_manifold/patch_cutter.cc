#include "tautline/planners/grid_manifold/patch_cutter.h"

#include <algorithm>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr int kTileCells = kTileSide * kTileSide;
constexpr TileMask kAll = ~TileMask{0};
constexpr TileMask kWestColumn = 0x0101010101010101ULL, kSouthRow = 0xff;
constexpr std::uint32_t kNone = 0xffffffffU;
constexpr std::uint16_t kNoLink = 0xffff;

constexpr TileMask ColumnCells(int column) { return kWestColumn << column; }
constexpr TileMask RowCells(int row) { return kSouthRow << (kTileSide * row); }

/// The cells of all rows from this one on; it may lie outside of the tile.
constexpr TileMask RowsFrom(int row) {
  return row <= 0 ? kAll : row >= kTileSide ? TileMask{0} : kAll << (kTileSide * row);
}

/// The cells from which a step leads so many tiles east, -1, 0 or 1.
constexpr TileMask Eastward(std::size_t d, int tiles) {
  const int dx = kStepColumns[d];
  if (tiles == 0) return dx == 0 ? kAll : ~ColumnCells(dx > 0 ? kTileSide - 1 : 0);
  return dx == tiles ? ColumnCells(dx > 0 ? kTileSide - 1 : 0) : TileMask{0};
}

/// The same northwards.
constexpr TileMask Northward(std::size_t d, int tiles) {
  const int dy = kStepRows[d];
  if (tiles == 0) return dy == 0 ? kAll : ~RowCells(dy > 0 ? kTileSide - 1 : 0);
  return dy == tiles ? RowCells(dy > 0 ? kTileSide - 1 : 0) : TileMask{0};
}

/// The steps that stay in the tile.
TileMoves Inside(const TileMoves& steps) {
  TileMoves inside{};
  for (std::size_t d = 0; d < kDirections; ++d) inside[d] = steps[d] & Eastward(d, 0) & Northward(d, 0);
  return inside;
}

/// All that moves lead to from some cells.
TileMask Flood(TileMask cells, const TileMoves& moves) {
  for (TileMask before = 0; before != cells;) {
    before = cells;
    for (std::size_t d = 0; d < kDirections; ++d) cells |= Moved(cells & moves[d], OffsetOf(d));
  }
  return cells;
}

/// Whether all cells between the outermost are in the set.
bool IsRectangle(TileMask cells) {
  const TileMask lowest = cells >> (__builtin_ctzll(cells) / kTileSide * kTileSide) & kSouthRow;
  for (; cells != 0; cells &= ~RowCells(__builtin_ctzll(cells) / kTileSide)) {
    if ((cells >> (__builtin_ctzll(cells) / kTileSide * kTileSide) & kSouthRow) != lowest) return false;
  }
  const TileMask from_first = lowest >> __builtin_ctzll(lowest);
  return (from_first & (from_first + 1)) == 0;
}

void Mix(std::uint64_t value, std::uint64_t& hash) {
  hash = (hash ^ value) * 0x9e3779b97f4a7c15ULL;
  hash ^= hash >> 29;
}

}  // namespace

PatchCutter::PatchCutter(const CellGround& ground, const TileReach& reach, PatchAtlas& atlas)
    : ground_(ground), atlas_(atlas), steps_(ground, atlas.connectivity_, reach) {}

void PatchCutter::Cut() {
  atlas_.tile_columns_ = steps_.columns();
  const int tiles = steps_.columns() * steps_.rows();
  FindLowestRays();
  openness_.resize(static_cast<std::size_t>(tiles));
  atlas_.first_patch_.reserve(static_cast<std::size_t>(tiles) + 1);
  for (int tile = 0; tile < tiles; ++tile) {
    if (steps_.free(tile) == kAll && !HasRay(tile)) openness_[static_cast<std::size_t>(tile)] = Openness::kPlain;
    atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
    if (steps_.free(tile) != 0) CutTile(tile);
  }
  atlas_.first_patch_.push_back(static_cast<std::uint32_t>(atlas_.patches_.size()));
  FindOpenness();
  for (int tile = 0; tile < tiles; ++tile) LinkTile(tile);
  PairLinks();
}

/// How low rays come down before each column, and among the columns of a tile and at its sides.
void PatchCutter::FindLowestRays() {
  lowest_at_.assign(static_cast<std::size_t>(steps_.columns()) * kTileSide + 1, ground_.rows());
  lowest_ray_.assign(static_cast<std::size_t>(steps_.columns()), ground_.rows());
  for (int column = 0; column < ground_.columns(); ++column) {
    int& lowest = lowest_at_[static_cast<std::size_t>(column)];
    for (const CellGround::Ray& ray : ground_.RaysBefore(column)) lowest = std::min(lowest, ray.above_row);
    int& of_tile = lowest_ray_[static_cast<std::size_t>(column / kTileSide)];
    of_tile = std::min(of_tile, lowest);
    if (column % kTileSide != 0 || column == 0) continue;
    int& before = lowest_ray_[static_cast<std::size_t>(column / kTileSide) - 1];
    before = std::min(before, lowest);
  }
}

/// Whether a step within a tile or out of it may cross a ray.
bool PatchCutter::HasRay(int tile) const {
  return lowest_ray_[static_cast<std::size_t>(steps_.ColumnOf(tile))] <= CellAt(tile, kTileCells - 1).row;
}

void PatchCutter::FindOpenness() {
  for (const Openness least : {Openness::kPlain, Openness::kAmong}) {
    const auto more = static_cast<Openness>(static_cast<std::uint8_t>(least) + 1);
    for (int tile = 0; tile < steps_.columns() * steps_.rows(); ++tile) {
      Openness& here = openness_[static_cast<std::size_t>(tile)];
      if (here == least && AllBeside(tile, least)) here = more;
    }
  }
}

/// Whether all tiles around a tile are there and so open at least.
bool PatchCutter::AllBeside(int tile, Openness least) const {
  const int column = steps_.ColumnOf(tile), row = steps_.RowOf(tile);
  if (column == 0 || row == 0 || column + 1 == steps_.columns() || row + 1 == steps_.rows()) return false;
  for (int y = -1; y <= 1; ++y) {
    const Openness* beside = &openness_[static_cast<std::size_t>(tile + y * steps_.columns() - 1)];
    if (beside[0] < least || beside[1] < least || beside[2] < least) return false;
  }
  return true;
}

GridCell PatchCutter::CellAt(int tile, int cell) const {
  return {steps_.ColumnOf(tile) * kTileSide + cell % kTileSide, steps_.RowOf(tile) * kTileSide + cell / kTileSide};
}

/// By direction, the cells of a tile from which a step may cross a ray. A diagonal step may cross in the row of either
/// end.
TileMoves PatchCutter::RayCrossings(int tile) const {
  TileMoves crossings{};
  const GridCell low = CellAt(tile, 0);
  for (int side = 0; side <= kTileSide; ++side) {
    const int column_after = low.column + side;
    const int above = lowest_at_[static_cast<std::size_t>(column_after)] - low.row;
    if (above >= kTileSide) continue;
    for (std::size_t d = 0; d < kDirections; ++d) {
      const int column = kStepColumns[d] > 0 ? side - 1 : side;
      if (kStepColumns[d] == 0 || column < 0 || column >= kTileSide) continue;
      crossings[d] |= ColumnCells(column) & RowsFrom(above + (kStepRows[d] > 0 ? 0 : 1));
    }
  }
  return crossings;
}

/// The word after a step. A diagonal one is taken by way of a free cell beside it: where both are free, no island is
/// between.
PatchCutter::WordNumber PatchCutter::AfterStep(WordNumber word, GridCell from, std::size_t d) {
  const int dx = kStepColumns[d];
  if (dx == 0) return word;
  const bool level_first = ground_.IsFree({from.column + dx, from.row});
  const int row = level_first ? from.row : from.row + kStepRows[d];
  const auto rays = ground_.RaysBefore(std::max(from.column, from.column + dx));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const CellGround::Ray& ray = rays[dx > 0 ? i : rays.size() - 1 - i];
    if (ray.above_row < row) word = atlas_.words_.Append(word, 2 * ray.obstacle.value() + (dx < 0 ? 1 : 0));
  }
  return word;
}

/// word * divisor^-1.
PatchCutter::WordNumber PatchCutter::Quotient(WordNumber word, WordNumber divisor) {
  if (word == divisor) return WordTrie::kEmpty;
  for (; divisor != WordTrie::kEmpty; divisor = atlas_.words_.parent(divisor)) {
    word = atlas_.words_.Append(word, atlas_.words_.last(divisor) ^ 1);
  }
  return word;
}

void PatchCutter::CutTile(int tile) {
  if (openness_[static_cast<std::size_t>(tile)] == Openness::kPlain && open_shape_) {
    atlas_.patches_.push_back({static_cast<std::uint32_t>(tile), *open_shape_, 0, 0});
    first_part_.push_back(kNone);
    return;
  }
  const TileMoves inside = Inside(steps_.From(tile));
  const bool has_ray = HasRay(tile);
  for (TileMask left = steps_.free(tile); left != 0;) {
    const TileMask cells = Flood(left & -left, inside);
    left &= ~cells;
    if (has_ray) {
      CutAcrossRays(tile, cells, inside);
    } else {
      AddPatch(tile, cells, inside);
    }
  }
}

/// A patch that rays may run through: cells that are joined without crossing any have one word, and each such part gets
/// its word by the crossing on which it is first reached.
void PatchCutter::CutAcrossRays(int tile, TileMask cells, const TileMoves& inside) {
  const TileMoves crossings = RayCrossings(tile);
  TileMoves moves{};
  for (std::size_t d = 0; d < kDirections; ++d) moves[d] = inside[d] & ~crossings[d];
  const TileMoves level = moves;
  const auto patch = static_cast<PatchNumber>(atlas_.patches_.size());
  const std::size_t first = atlas_.parts_.size();
  std::array<WordNumber, kTileCells> words{};
  TileMask reached = 0;
  const auto add = [&](int start, WordNumber word) {
    const TileMask part = Flood(TileMask{1} << start, level);
    reached |= part;
    for (TileMask left = part; left != 0; left &= left - 1) {
      words[static_cast<std::size_t>(__builtin_ctzll(left))] = word;
    }
    atlas_.parts_.push_back({patch, word, part});
  };
  add(__builtin_ctzll(cells), WordTrie::kEmpty);
  for (std::size_t i = first; i < atlas_.parts_.size(); ++i) {
    const Part part = atlas_.parts_[i];
    for (std::size_t d = 0; d < kDirections; ++d) {
      for (TileMask from = part.cells & inside[d] & crossings[d]; from != 0; from &= from - 1) {
        const int cell = __builtin_ctzll(from), beside = cell + OffsetOf(d);
        const WordNumber word = AfterStep(part.word, CellAt(tile, cell), d);
        if ((reached >> beside & 1) == 0) add(beside, word);
        // Also backwards, when the turn of the other part comes.
        if (words[static_cast<std::size_t>(beside)] == word) moves[d] |= TileMask{1} << cell;
      }
    }
  }
  const bool one = atlas_.parts_.size() == first + 1;
  if (one) atlas_.parts_.pop_back();
  AddPatch(tile, cells, moves);
  if (!one) first_part_.back() = static_cast<std::uint32_t>(first);
}

void PatchCutter::AddPatch(int tile, TileMask cells, const TileMoves& moves) {
  TileMoves within{};
  for (std::size_t d = 0; d < kDirections; ++d) within[d] = moves[d] & cells;
  const std::uint32_t shape = ShapeNumber(cells, within);
  if (cells == kAll && atlas_.shapes_[shape].open) open_shape_ = shape;
  atlas_.patches_.push_back({static_cast<std::uint32_t>(tile), shape, 0, 0});
  first_part_.push_back(kNone);
}

std::uint32_t PatchCutter::ShapeNumber(TileMask cells, const TileMoves& moves) {
  std::uint64_t key = cells;
  for (const TileMask from : moves) Mix(from, key);
  for (;; ++key) {
    const auto number = static_cast<std::uint32_t>(atlas_.shapes_.size());
    const auto [found, added] = shape_numbers_.try_emplace(key, number);
    if (added) break;
    const PatchAtlas::Shape& shape = atlas_.shapes_[found->second];
    if (shape.cells == cells && shape.moves == moves) return found->second;
  }
  PatchAtlas::Shape shape{.cells = cells, .moves = moves};
  for (int cell = 0; cell < kTileCells; ++cell) {
    if ((cells >> cell & 1) != 0) shape.position[static_cast<std::size_t>(cell)] = shape.count++;
  }
  shape.open =
      IsRectangle(cells) && moves == MovesWithin(OpenMoves(atlas_.connectivity_ == Connectivity::kEight), cells);
  atlas_.shapes_.push_back(shape);
  return static_cast<std::uint32_t>(atlas_.shapes_.size() - 1);
}

/// The parts of a patch; `whole` is where the only one is put.
std::span<const PatchAtlas::Part> PatchCutter::PartsOf(PatchNumber patch, Part& whole) const {
  const std::uint32_t first = first_part_[patch];
  if (first == kNone) {
    whole = {patch, WordTrie::kEmpty, atlas_.shape(patch).cells};
    return {&whole, 1};
  }
  std::size_t last = first;
  while (last < atlas_.parts_.size() && atlas_.parts_[last].patch == patch) ++last;
  return std::span<const Part>(atlas_.parts_).subspan(first, last - first);
}

void PatchCutter::LinkTile(int tile) {
  const PatchNumber first = atlas_.first_patch_[static_cast<std::size_t>(tile)],
                    last = atlas_.first_patch_[static_cast<std::size_t>(tile) + 1];
  if (first == last) return;
  const Openness openness = openness_[static_cast<std::size_t>(tile)];
  const bool plain = openness >= Openness::kAmong;
  if (plain && !plain_links_.empty()) {
    return openness == Openness::kDeep ? SharePlainLinks(first) : CopyPlainLinks(first);
  }
  const TileMoves steps = steps_.From(tile);
  const TileMoves crossings = HasRay(tile) ? RayCrossings(tile) : TileMoves{};
  for (PatchNumber patch = first; patch < last; ++patch) FindLinks(patch, steps, crossings);
  if (plain) KeepPlainLinks(first);
}

/// The links of patches among plain tiles are all alike.
void PatchCutter::KeepPlainLinks(PatchNumber patch) {
  const auto tile = static_cast<int>(atlas_.patches_[patch].tile);
  for (const PatchAtlas::Link& link : atlas_.links(patch)) {
    plain_links_.emplace_back(static_cast<int>(atlas_.patches_[PatchAtlas::LinkedTo(patch, link)].tile) - tile, link);
  }
  for (auto& [offset, link] : plain_links_) {
    for (std::size_t i = 0; i < plain_links_.size(); ++i) {
      if (plain_links_[i].first == -offset) link.back = static_cast<std::uint16_t>(i);
    }
  }
}

void PatchCutter::CopyPlainLinks(PatchNumber patch) {
  PatchAtlas::Patch& here = atlas_.patches_[patch];
  here.first_link = static_cast<std::uint32_t>(atlas_.links_.size());
  here.links = static_cast<std::uint32_t>(plain_links_.size());
  for (auto [offset, link] : plain_links_) {
    const std::uint32_t beside = here.tile + static_cast<std::uint32_t>(offset);
    link.ahead = atlas_.first_patch_[beside] - patch;
    if (openness_[beside] < Openness::kAmong) link.back = kNoLink;
    atlas_.links_.push_back(link);
  }
}

/// Patches from which those to the north and south are as far ahead as from the patch before have its links.
void PatchCutter::SharePlainLinks(PatchNumber patch) {
  PatchAtlas::Patch& here = atlas_.patches_[patch];
  const std::size_t row = static_cast<std::size_t>(steps_.columns());
  const std::uint32_t north = atlas_.first_patch_[here.tile + row] - patch,
                      south = atlas_.first_patch_[here.tile - row] - patch;
  if (shared_links_ == kNone || north != shared_north_ || south != shared_south_) {
    CopyPlainLinks(patch);
    shared_links_ = here.first_link;
    shared_north_ = north;
    shared_south_ = south;
  }
  here.first_link = shared_links_;
  here.links = static_cast<std::uint32_t>(plain_links_.size());
}

void PatchCutter::FindLinks(PatchNumber patch, const TileMoves& steps, const TileMoves& crossings) {
  const PatchAtlas::Shape& shape = atlas_.shape(patch);
  growing_.clear();
  for (std::size_t d = 0; d < kDirections; ++d) {
    const TileMask from = shape.cells & steps[d] & ~shape.moves[d];
    if (from != 0) AddExits(patch, d, from, crossings);
  }
  StoreLinks(patch);
}

/// The exits in a direction, by the tiles that they lead to; the tile itself is one of them.
void PatchCutter::AddExits(PatchNumber patch, std::size_t d, TileMask from, const TileMoves& crossings) {
  const auto tile = static_cast<int>(atlas_.patches_[patch].tile);
  const int dx = kStepColumns[d], dy = kStepRows[d];
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(dx, 0), std::pair(0, dy), std::pair(dx, dy)}) {
    const TileMask cells = from & Eastward(d, x) & Northward(d, y);
    if (cells == 0) continue;
    from &= ~cells;
    AddExitsTo(patch, d, cells, OffsetOf(d) - kTileSide * x - kTileCells * y, steps_.Beside(tile, x, y), crossings[d]);
  }
}

/// `across`: the cells whose steps may cross rays.
void PatchCutter::AddExitsTo(PatchNumber patch, std::size_t d, TileMask from, int offset, int to_tile,
                             TileMask across) {
  const auto tile = static_cast<int>(atlas_.patches_[patch].tile);
  Part whole, other_whole;
  const auto parts = PartsOf(patch, whole);
  const auto at = static_cast<std::size_t>(to_tile);
  for (PatchNumber to = atlas_.first_patch_[at]; to < atlas_.first_patch_[at + 1]; ++to) {
    if ((from & Moved(atlas_.shape(to).cells, -offset)) == 0) continue;
    for (const Part& other : PartsOf(to, other_whole)) {
      const TileMask to_other = from & Moved(other.cells, -offset);
      if (to_other == 0) continue;
      for (const Part& part : parts) {
        const TileMask cells = to_other & part.cells;
        if ((cells & ~across) != 0) AddSteps(to, Quotient(part.word, other.word), d, offset, cells & ~across);
        for (TileMask left = cells & across; left != 0; left &= left - 1) {
          const WordNumber word = AfterStep(part.word, CellAt(tile, __builtin_ctzll(left)), d);
          AddSteps(to, Quotient(word, other.word), d, offset, left & -left);
        }
      }
    }
  }
}

void PatchCutter::AddSteps(PatchNumber to, WordNumber word, std::size_t d, int offset, TileMask from) {
  auto link = std::find_if(growing_.begin(), growing_.end(),
                           [&](const GrowingLink& other) { return other.to == to && other.word == word; });
  if (link == growing_.end()) link = growing_.insert(link, {.to = to, .word = word});
  const auto direction = static_cast<std::int8_t>(d);
  if (link->count == 0 || link->crossings[link->count - 1].direction != direction) {
    link->crossings[link->count++] = {0, direction, static_cast<std::int8_t>(offset)};
  }
  link->crossings[link->count - 1].from |= from;
}

void PatchCutter::StoreLinks(PatchNumber patch) {
  atlas_.patches_[patch].first_link = static_cast<std::uint32_t>(atlas_.links_.size());
  atlas_.patches_[patch].links = static_cast<std::uint32_t>(growing_.size());
  for (const GrowingLink& link : growing_) {
    atlas_.links_.push_back(
        {link.to - patch, link.word, CrossingNumber(link), kNoLink, link.count, OpenSide(patch, link)});
  }
}

std::uint8_t PatchCutter::OpenSide(PatchNumber patch, const GrowingLink& link) const {
  if (atlas_.shape(patch).cells != kAll || atlas_.shape(link.to).cells != kAll) return PatchAtlas::kNotOpen;
  for (std::size_t side = 0; side < kDirections; side += 2) {
    const int dx = kStepColumns[side], dy = kStepRows[side];
    std::size_t open = 0;
    for (std::size_t i = 0; i < link.count; ++i) {
      const auto d = static_cast<std::uint8_t>(link.crossings[i].direction);
      if (link.crossings[i].from == (Eastward(d, dx) & Northward(d, dy))) ++open;
    }
    const std::size_t all = atlas_.connectivity_ == Connectivity::kEight ? 3 : 1;
    if (open == all && link.count == all) return static_cast<std::uint8_t>(side);
  }
  return PatchAtlas::kNotOpen;
}

/// Where these crossings stand; most patches have the same ones.
std::uint32_t PatchCutter::CrossingNumber(const GrowingLink& link) {
  const auto crossings = std::span(link.crossings.data(), link.count);
  std::uint64_t key = link.count;
  for (const PatchAtlas::Crossing& crossing : crossings) {
    Mix(crossing.from, key);
    Mix(static_cast<std::uint64_t>(crossing.direction) * 256 + static_cast<std::uint64_t>(crossing.offset + 128), key);
  }
  for (;; ++key) {
    const auto number = static_cast<std::uint32_t>(atlas_.crossings_.size());
    const auto [found, added] = crossing_numbers_.try_emplace(key, number);
    if (added) {
      atlas_.crossings_.insert(atlas_.crossings_.end(), crossings.begin(), crossings.end());
      return number;
    }
    const auto others = std::span<const PatchAtlas::Crossing>(atlas_.crossings_).subspan(found->second);
    if (others.size() >= crossings.size() && std::equal(crossings.begin(), crossings.end(), others.begin())) {
      return found->second;
    }
  }
}

/// Finds for each link the one that leads back, where that is not known yet.
void PatchCutter::PairLinks() {
  for (PatchNumber patch = 0; patch < atlas_.patches_.size(); ++patch) {
    if (openness_[atlas_.patches_[patch].tile] == Openness::kDeep) continue;
    for (std::uint32_t i = 0; i < atlas_.patches_[patch].links; ++i) {
      PatchAtlas::Link& link = atlas_.links_[atlas_.patches_[patch].first_link + i];
      if (link.back != kNoLink) continue;
      const PatchNumber to = PatchAtlas::LinkedTo(patch, link);
      const WordNumber back = Quotient(WordTrie::kEmpty, link.word);
      const auto others = atlas_.links(to);
      const auto found = std::find_if(others.begin(), others.end(), [&](const PatchAtlas::Link& other) {
        return PatchAtlas::LinkedTo(to, other) == patch && other.word == back;
      });
      TAUTLINE_CHECK(found != others.end());
      link.back = static_cast<std::uint16_t>(found - others.begin());
    }
  }
}

}  // namespace tautline
