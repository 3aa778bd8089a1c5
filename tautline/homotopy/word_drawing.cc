#include "tautline/homotopy/word_drawing.h"

#include <algorithm>
#include <utility>

namespace tautline {

bool WordDrawing::CrossedBefore(ObstacleId a, ObstacleId b) const {
  return std::pair(x_of_island_[a.index()], a) < std::pair(x_of_island_[b.index()], b);
}

void WordDrawing::AddColumns(const FreeSpace& space) {
  // Rays that are closer than this leave too few numbers for lines between them.
  constexpr double kSpacings = 1024;
  std::vector<ObstacleId> order;
  for (std::size_t i = 0; i < space.islands.size(); ++i) {
    x_of_island_.push_back(space.islands[i].representative.x);
    order.emplace_back(i);
  }
  std::sort(order.begin(), order.end(), [this](ObstacleId a, ObstacleId b) { return CrossedBefore(a, b); });
  column_of_island_.resize(order.size());
  for (const ObstacleId id : order) {
    const double x = x_of_island_[id.index()];
    const bool is_new = columns_.empty() || x - columns_.back().high_x > kSpacings * space.grid;
    if (is_new) columns_.push_back({x, x, x, x, {}, {}});
    columns_.back().high_x = x;
    columns_.back().islands.push_back(id);
    column_of_island_[id.index()] = columns_.size() - 1;
  }
}

WordDrawing::WordDrawing(const FreeSpace& space, Rng& rng) {
  const double extent = std::max(space.box.size().x, space.box.size().y);
  ground_ = space.box.low.y - extent * rng.Uniform(0.1, 0.2);
  AddColumns(space);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    const double before = i == 0 ? column.low_x - 0.1 * extent : columns_[i - 1].high_x;
    const double after = i + 1 == columns_.size() ? column.high_x + 0.1 * extent : columns_[i + 1].low_x;
    column.left = column.low_x - (column.low_x - before) * rng.Uniform(0.1, 0.4);
    column.right = column.high_x + (after - column.high_x) * rng.Uniform(0.1, 0.4);
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
/// order in which they are crossed.
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
  std::sort(lower.begin(), lower.end(), [this](ObstacleId a, ObstacleId b) { return CrossedBefore(a, b); });
  for (const ObstacleId id : lower) (CrossedBefore(id, letter.obstacle) ? before : after).Append({id, false});
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
