#include "tautline/planners/grid_manifold/manifold_goal_field.h"

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/page_values.h"

namespace tautline {

ManifoldGoalField::ManifoldGoalField(const GridManifold& manifold, GridCell goal)
    : manifold_(manifold), goal_(goal), values_(manifold.value_count(), kUnreached) {
  keys_.assign(manifold.pages(), kUnreached);
  changed_.assign(manifold.pages(), 0);
  const std::vector<ManifoldVertex> goals = manifold.VerticesAt(goal);
  goals_ = goals.size();
  for (const ManifoldVertex v : goals) Offer(v.page, v.cell, 0);
  Search();
  std::vector<LatticeDistance>().swap(keys_);
  std::vector<TileMask>().swap(changed_);
  std::vector<std::vector<std::uint32_t>>().swap(buckets_);
}

/// Lowers a distance, and lets its page wait for its turn.
void ManifoldGoalField::Offer(std::uint32_t page, int cell, LatticeDistance distance) {
  const PatchAtlas::Shape& shape = manifold_.atlas().shape(manifold_.patch(page));
  LatticeDistance& value = values_[manifold_.first_value(page) + shape.position[static_cast<std::size_t>(cell)]];
  if (distance >= value) return;
  value = distance;
  changed_[page] |= TileMask{1} << cell;
  if (distance >= keys_[page]) return;
  const auto bucket = static_cast<std::size_t>(distance / kStraightStep);
  const bool waits = keys_[page] != kUnreached && static_cast<std::size_t>(keys_[page] / kStraightStep) == bucket;
  keys_[page] = distance;
  if (waits) return;
  if (buckets_.size() <= bucket) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(page);
}

/// Pages in the order of distance, as the manifold was built, but on pages that are there.
void ManifoldGoalField::Search() {
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    for (std::size_t i = 0; i < buckets_[bucket].size(); ++i) {
      const std::uint32_t page = buckets_[bucket][i];
      if (static_cast<std::size_t>(keys_[page] / kStraightStep) == bucket) Sweep(page);
    }
    std::vector<std::uint32_t>().swap(buckets_[bucket]);
  }
}

void ManifoldGoalField::Sweep(std::uint32_t page) {
  const PatchAtlas& atlas = manifold_.atlas();
  const PatchAtlas::Shape& shape = atlas.shape(manifold_.patch(page));
  const TileMask vertices = manifold_.vertices(page);
  const bool open = shape.open && vertices == shape.cells;
  LatticeDistance* values = &values_[manifold_.first_value(page)];
  TileDistances tile;
  LoadTile(shape, values, tile);
  const TileMoves moves = open ? shape.moves : MovesWithin(shape.moves, vertices);
  const TileMask lowered = RelaxTile(moves, open, atlas.connectivity() == Connectivity::kEight, tile);
  const TileMask changed = changed_[page] | lowered;
  StoreTile(shape, tile, values);
  keys_[page] = kUnreached;
  changed_[page] = 0;
  const auto links = atlas.links(manifold_.patch(page));
  for (std::size_t i = 0; i < links.size(); ++i) {
    const std::uint32_t to = manifold_.linked(page, i);
    if (to == GridManifold::kNoPage) continue;
    for (const PatchAtlas::Crossing& crossing : atlas.crossings(links[i])) {
      for (TileMask cells = changed & crossing.from; cells != 0; cells &= cells - 1) {
        const int cell = __builtin_ctzll(cells), beside = cell + crossing.offset;
        if (!manifold_.Has({to, beside})) continue;
        Offer(to, beside, tile.at[static_cast<std::size_t>(cell)] + StepLength(crossing.direction));
      }
    }
  }
}

LatticeDistance ManifoldGoalField::distance(ManifoldVertex v) const {
  const PatchAtlas::Shape& shape = manifold_.atlas().shape(manifold_.patch(v.page));
  return values_[manifold_.first_value(v.page) + shape.position[static_cast<std::size_t>(v.cell)]];
}

std::optional<int> ManifoldGoalField::Direction(ManifoldVertex v) const {
  const LatticeDistance here = distance(v);
  if (here == 0 || here == kUnreached) return std::nullopt;
  const int step = manifold_.atlas().connectivity() == Connectivity::kEight ? 1 : 2;
  for (int d = 0; d < kDirections; d += step) {
    const auto to = manifold_.Step(v, d);
    if (to && distance(*to) == here - StepLength(d)) return d;
  }
  TAUTLINE_CHECK(false);
}

std::vector<ManifoldVertex> ManifoldGoalField::WayFrom(ManifoldVertex v) const {
  if (distance(v) == kUnreached) return {};
  std::vector<ManifoldVertex> way{v};
  for (auto d = Direction(v); d; d = Direction(way.back())) way.push_back(*manifold_.Step(way.back(), *d));
  return way;
}

}  // namespace tautline
