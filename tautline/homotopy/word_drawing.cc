#include "tautline/homotopy/word_drawing.h"

#include <algorithm>

namespace tautline {
namespace {

/// Between rays that are nearer to each other than this share of the extent no line has room beside rounding: they are
/// crossed like rays of one column.
constexpr double kNear = 0x1p-40;

}  // namespace

void WordDrawing::GatherColumns(const FreeSpace& space, double extent) {
  const std::size_t count = space.islands.size();
  const auto x = [&](ObstacleId id) { return space.islands[id.index()].representative.x; };
  std::vector<ObstacleId> by_x;
  for (std::size_t i = 0; i < count; ++i) by_x.emplace_back(i);
  std::stable_sort(by_x.begin(), by_x.end(), [&](ObstacleId a, ObstacleId b) { return x(a) < x(b); });
  column_of_island_.resize(count);
  rank_of_island_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const ObstacleId id = by_x[i];
    if (columns_.empty() || x(id) - columns_.back().right > kNear * extent) columns_.push_back({x(id), x(id), {}, {}});
    columns_.back().right = x(id);
    columns_.back().islands.push_back(id);
    column_of_island_[id.index()] = columns_.size() - 1;
    rank_of_island_[id.index()] = i;
  }
}

WordDrawing::WordDrawing(const FreeSpace& space, Rng& rng) {
  const double extent = std::max(space.box.size().x, space.box.size().y);
  ground_ = space.box.low.y - extent * rng.Uniform(0.1, 0.2);
  GatherColumns(space, extent);
  double before = 0;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const double first = column.left, last = column.right;
    if (i == 0) before = first - 0.1 * extent;
    const double after = i + 1 == columns_.size() ? last + 0.1 * extent : columns_[i + 1].left;
    column.left = first - (first - before) * rng.Uniform(0.1, 0.4);
    column.right = last + (after - last) * rng.Uniform(0.1, 0.4);
    before = last;
    const auto height = [&](ObstacleId id) { return space.islands[id.index()].representative.y; };
    std::sort(column.islands.begin(), column.islands.end(),
              [&](ObstacleId a, ObstacleId b) { return height(a) < height(b); });
    for (std::size_t k = 0; k < column.islands.size(); ++k) {
      const double low = height(column.islands[k]);
      const double high = k + 1 < column.islands.size() ? height(column.islands[k + 1]) : low + 0.1 * extent;
      column.above.push_back(low + (high - low) * rng.Uniform(0.3, 0.7));
    }
  }
}

/// Crosses a column just above its k-th ray and comes down again: P_k, the letters of the rays up to the k-th in the
/// order in which they stand.
void WordDrawing::AddCrossing(const Column& column, std::size_t k, bool inverse, Polyline& drawing) const {
  const double start = inverse ? column.right : column.left, end = inverse ? column.left : column.right;
  const double height = column.above[k];
  drawing.insert(drawing.end(), {{start, ground_}, {start, height}, {end, height}, {end, ground_}});
}

/// P_k is A letter B, where A and B are lower letters. Where one of them is empty the other is P_(k-1), and the letter
/// is one crossing and another undone; else it is A^-1 P_k B^-1.
void WordDrawing::AddLetter(Letter letter, Polyline& drawing) const {
  const Column& column = columns_[column_of_island_[letter.obstacle.index()]];
  const auto found = std::find(column.islands.begin(), column.islands.end(), letter.obstacle);
  const auto k = static_cast<std::size_t>(found - column.islands.begin());
  Word before, after;
  std::vector<ObstacleId> lower(column.islands.begin(), found);
  const auto rank = [this](ObstacleId id) { return rank_of_island_[id.index()]; };
  std::sort(lower.begin(), lower.end(), [&](ObstacleId a, ObstacleId b) { return rank(a) < rank(b); });
  for (const ObstacleId id : lower) (rank(id) < rank(letter.obstacle) ? before : after).Append({id, false});
  if (k > 0 && (before.empty() || after.empty())) {
    const bool undo_first = after.empty() != letter.inverse;
    if (undo_first) AddCrossing(column, k - 1, !letter.inverse, drawing);
    AddCrossing(column, k, letter.inverse, drawing);
    if (!undo_first) AddCrossing(column, k - 1, !letter.inverse, drawing);
    return;
  }
  const Word first = letter.inverse ? after : before.Inverse(), last = letter.inverse ? before : after.Inverse();
  for (const Letter side : first.letters()) AddLetter(side, drawing);
  AddCrossing(column, k, letter.inverse, drawing);
  for (const Letter side : last.letters()) AddLetter(side, drawing);
}

Polyline WordDrawing::Draw(Point from, const Word& word, Point to) const {
  Polyline drawing{from, {from.x, ground_}};
  for (const Letter letter : word.letters()) AddLetter(letter, drawing);
  drawing.insert(drawing.end(), {{to.x, ground_}, to});
  return drawing;
}

}  // namespace tautline
