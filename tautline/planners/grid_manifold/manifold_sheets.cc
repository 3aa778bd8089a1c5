#include "tautline/planners/grid_manifold/manifold_sheets.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tautline/geometry/trace_cells.h"

namespace tautline {
namespace {

/// The pieces of a sheet: for each page, its cells with the word.
using Pieces = std::vector<std::pair<std::uint32_t, TileMask>>;

struct Collected {
  ManifoldSheet sheet;
  Pieces pieces;
};

/// The cells of a page by their words within the patch.
std::map<WordTrie::WordNumber, TileMask> ByCellWord(const GridManifold& manifold, std::uint32_t page) {
  std::map<WordTrie::WordNumber, TileMask> parts;
  for (TileMask cells = manifold.vertices(page); cells != 0; cells &= cells - 1) {
    const int cell = __builtin_ctzll(cells);
    parts[manifold.atlas().WordOf({manifold.patch(page), cell})] |= TileMask{1} << cell;
  }
  return parts;
}

void AddPiece(const GridManifold& manifold, std::uint32_t page, TileMask cells, Collected& collected) {
  ManifoldSheet& sheet = collected.sheet;
  if (sheet.vertices == 0) sheet.nearest = kUnreached;
  collected.pieces.emplace_back(page, cells);
  for (; cells != 0; cells &= cells - 1) {
    const LatticeDistance distance = manifold.distance({page, __builtin_ctzll(cells)});
    sheet.nearest = std::min(sheet.nearest, distance);
    sheet.farthest = std::max(sheet.farthest, distance);
    ++sheet.vertices;
  }
}

/// The boundary of cells, by a grid just around them in which they are the blocked ones.
std::vector<PolygonWithHoles> BoundaryOf(const GridManifold& manifold, const Pieces& pieces) {
  const PatchAtlas& atlas = manifold.atlas();
  GridCell low{manifold.ground().columns(), manifold.ground().rows()}, high{0, 0};
  for (const auto& [page, cells] : pieces) {
    const GridCell corner = atlas.CellOf({manifold.patch(page), 0});
    low = {std::min(low.column, corner.column), std::min(low.row, corner.row)};
    high = {std::max(high.column, corner.column + kTileSide), std::max(high.row, corner.row + kTileSide)};
  }
  OccupancyGrid grid = MakeGrid(high.column - low.column, high.row - low.row, CellState::kFree);
  const OccupancyGrid& whole = manifold.ground().grid();
  grid.cell_m = whole.cell_m;
  grid.yaw_rad = whole.yaw_rad;
  grid.origin = LatticePoint(whole, low.column, low.row);
  for (const auto& [page, mask] : pieces) {
    for (TileMask cells = mask; cells != 0; cells &= cells - 1) {
      const GridCell cell = atlas.CellOf({manifold.patch(page), __builtin_ctzll(cells)});
      grid.cells[grid.index(cell.column - low.column, cell.row - low.row)] = CellState::kBlocked;
    }
  }
  return TraceBlockedCells(grid);
}

}  // namespace

std::vector<ManifoldSheet> SheetsOf(const GridManifold& manifold, std::size_t outlined) {
  std::map<Word, Collected> by_word;
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (const auto& [number, cells] : ByCellWord(manifold, page)) {
      AddPiece(manifold, page, cells, by_word[manifold.WordOf({page, __builtin_ctzll(cells)})]);
    }
  }
  std::vector<Collected*> sorted;
  for (auto& [word, collected] : by_word) {
    collected.sheet.word = word;
    sorted.push_back(&collected);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Collected* a, const Collected* b) { return a->sheet.vertices > b->sheet.vertices; });
  std::vector<ManifoldSheet> sheets;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i < outlined) sorted[i]->sheet.boundary = BoundaryOf(manifold, sorted[i]->pieces);
    sheets.push_back(std::move(sorted[i]->sheet));
  }
  return sheets;
}

}  // namespace tautline
