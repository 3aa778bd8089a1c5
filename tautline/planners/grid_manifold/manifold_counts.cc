#include <algorithm>

#include "tautline/planners/grid_manifold/grid_manifold.h"
#include "tautline/planners/grid_manifold/page_values.h"

namespace tautline {
namespace {

std::int64_t CountOf(TileMask cells) {
  std::int64_t count = 0;
  for (; cells != 0; cells &= cells - 1) ++count;
  return count;
}

/// The steps from the vertices of a page, each counted from both of its ends.
std::int64_t StepsFrom(const GridManifold& manifold, std::uint32_t page) {
  const PatchAtlas& atlas = manifold.atlas();
  const TileMask vertices = manifold.vertices(page);
  const PatchAtlas::Shape& shape = atlas.shape(manifold.patch(page));
  std::int64_t steps = 0;
  for (const TileMask from : MovesWithin(shape.moves, vertices)) steps += CountOf(from);
  const auto links = atlas.links(manifold.patch(page));
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::uint32_t to = manifold.linked(page, i);
    if (to == GridManifold::kNoPage) continue;
    for (const PatchAtlas::Crossing& crossing : atlas.crossings(links[i])) {
      steps += CountOf(Across(crossing, vertices) & manifold.vertices(to));
    }
  }
  return steps;
}

}  // namespace

std::vector<std::uint32_t> GridManifold::Multiplicity() const {
  std::vector<std::uint32_t> counts(ground_.grid().cells.size());
  for (std::uint32_t page = 0; page < page_count_; ++page) {
    const GridCell corner = atlas_.CellOf({patch(page), 0});
    for (TileMask cells = vertices(page); cells != 0; cells &= cells - 1) {
      const int cell = __builtin_ctzll(cells);
      ++counts[ground_.grid().index(corner.column + cell % kTileSide, corner.row + cell / kTileSide)];
    }
  }
  return counts;
}

ManifoldCounts GridManifold::Count() const {
  ManifoldCounts counts;
  for (std::uint32_t page = 0; page < page_count_; ++page) {
    counts.edges += StepsFrom(*this, page);
    counts.vertices += CountOf(vertices(page));
    const LatticeDistance* values = &values_[first_value(page)];
    for (int i = 0; i < atlas_.shape(patch(page)).count; ++i) {
      if (values[i] != kUnreached) counts.farthest = std::max(counts.farthest, values[i]);
    }
  }
  counts.edges /= 2;
  for (const std::uint32_t count : Multiplicity()) {
    if (count == 0) continue;
    if (counts.multiplicity.size() < count) counts.multiplicity.resize(count);
    ++counts.multiplicity[count - 1];
  }
  return counts;
}

}  // namespace tautline
