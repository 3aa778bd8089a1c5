#include "tautline/planners/grid_manifold/grid_manifold.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/manifold_builder.h"
#include "tautline/planners/grid_manifold/page_values.h"

namespace tautline {

GridManifold::GridManifold(CellGround ground, const ManifoldOptions& options)
    : ground_(std::move(ground)),
      base_(options.base),
      length_m_(options.length_m),
      limit_(LimitOf(length_m_ / ground_.cell_m())),
      atlas_(ground_, options.connectivity, {base_, limit_}) {}

GridManifold GridManifold::Build(CellGround ground, const ManifoldOptions& options) {
  TAUTLINE_CHECK(ground.IsFree(options.base) && options.length_m >= 0);
  GridManifold manifold(std::move(ground), options);
  ManifoldBuilder(manifold, options).Build();
  manifold.IndexPages();
  return manifold;
}

/// Lists the pages by patch.
void GridManifold::IndexPages() {
  first_of_patch_.assign(atlas_.size() + 1, 0);
  pages_of_patch_.resize(page_count_);
  for (std::uint32_t page = 0; page < page_count_; ++page) ++first_of_patch_[pages_[page].patch + 1];
  for (std::size_t i = 1; i < first_of_patch_.size(); ++i) first_of_patch_[i] += first_of_patch_[i - 1];
  std::vector<std::uint32_t> next(first_of_patch_.begin(), first_of_patch_.end() - 1);
  for (std::uint32_t page = 0; page < page_count_; ++page) pages_of_patch_[next[pages_[page].patch]++] = page;
}

Word GridManifold::WordOf(ManifoldVertex v) const {
  return words_.ToWord(pages_[v.page].word) * atlas_.words().ToWord(atlas_.WordOf({patch(v.page), v.cell}));
}

std::vector<ManifoldVertex> GridManifold::VerticesAt(GridCell cell) const {
  if (!ground_.IsFree(cell)) return {};
  const auto place = atlas_.FindPlace(cell);
  if (!place) return {};
  std::vector<ManifoldVertex> vertices;
  for (std::uint32_t i = first_of_patch_[place->patch]; i < first_of_patch_[place->patch + 1]; ++i) {
    const ManifoldVertex v{pages_of_patch_[i], place->cell};
    if (Has(v)) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end(), [this](ManifoldVertex a, ManifoldVertex b) {
    return std::pair(distance(a), a.page) < std::pair(distance(b), b.page);
  });
  return vertices;
}

std::optional<ManifoldVertex> GridManifold::Find(GridCell cell, const Word& word) const {
  for (const ManifoldVertex v : VerticesAt(cell)) {
    if (WordOf(v) == word) return v;
  }
  return std::nullopt;
}

/// A step that a link stands for, if any does.
std::optional<ManifoldVertex> GridManifold::StepOut(ManifoldVertex v, int direction) const {
  const TileMask cell = TileMask{1} << v.cell;
  const auto links = atlas_.links(patch(v.page));
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const PatchAtlas::Crossing& crossing : atlas_.crossings(links[i])) {
      if (crossing.direction != direction || (crossing.from & cell) == 0) continue;
      const ManifoldVertex to{linked(v.page, i), v.cell + crossing.offset};
      return to.page != kNoPage && Has(to) ? std::optional(to) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::size_t GridManifold::bytes() const {
  return ground_.grid().cells.capacity() + atlas_.bytes() + words_.bytes() + pages_.bytes() + values_.bytes() +
         links_.bytes() +
         (page_table_.capacity() + first_of_patch_.capacity() + pages_of_patch_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace tautline
