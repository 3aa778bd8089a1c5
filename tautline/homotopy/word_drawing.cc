#include "tautline/homotopy/word_drawing.h"

#include <algorithm>

namespace tautline {

WordDrawing::WordDrawing(const FreeSpace& space, Rng& rng) {
  const double extent = std::max(space.box.size().x, space.box.size().y);
  ground_ = space.box.low.y - extent * rng.Uniform(0.1, 0.2);
  for (std::size_t i = 0; i < space.islands.size(); ++i) {
    column_of_island_.push_back(space.islands[i].representative.x);
    columns_[column_of_island_.back()].islands.emplace_back(i);
  }
  for (auto it = columns_.begin(); it != columns_.end(); ++it) {
    Column& column = it->second;
    const double before = it == columns_.begin() ? it->first - 0.1 * extent : std::prev(it)->first;
    const double after = std::next(it) == columns_.end() ? it->first + 0.1 * extent : std::next(it)->first;
    column.left = it->first - (it->first - before) * rng.Uniform(0.1, 0.4);
    column.right = it->first + (after - it->first) * rng.Uniform(0.1, 0.4);
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
/// order of their ids.
void WordDrawing::AddCrossing(const Column& column, std::size_t k, bool inverse, Polyline& drawing) const {
  const double start = inverse ? column.right : column.left, end = inverse ? column.left : column.right;
  const double height = column.above[k];
  drawing.insert(drawing.end(), {{start, ground_}, {start, height}, {end, height}, {end, ground_}});
}

/// P_k is A letter B, where A and B are lower letters. Where one of them is empty the other is P_(k-1), and the letter
/// is one crossing and another undone; else it is A^-1 P_k B^-1.
void WordDrawing::AddLetter(Letter letter, Polyline& drawing) const {
  const Column& column = columns_.at(column_of_island_[letter.obstacle.index()]);
  const auto found = std::find(column.islands.begin(), column.islands.end(), letter.obstacle);
  const auto k = static_cast<std::size_t>(found - column.islands.begin());
  Word before, after;
  std::vector<ObstacleId> lower(column.islands.begin(), found);
  std::sort(lower.begin(), lower.end());
  for (const ObstacleId id : lower) (id < letter.obstacle ? before : after).Append({id, false});
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
