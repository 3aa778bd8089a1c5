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

/// Crossing the column above the k-th ray writes all letters up to the k-th, in the order of their ids: A letter B.
/// The letter alone is A^-1 (A letter B) B^-1, and A and B start lower.
void WordDrawing::AddLetter(Letter letter, Polyline& drawing) const {
  const Column& column = columns_.at(column_of_island_[letter.obstacle.index()]);
  const auto found = std::find(column.islands.begin(), column.islands.end(), letter.obstacle);
  Word before, after;
  std::vector<ObstacleId> lower(column.islands.begin(), found);
  std::sort(lower.begin(), lower.end());
  for (const ObstacleId id : lower) (id < letter.obstacle ? before : after).Append({id, false});
  const double height = column.above[static_cast<std::size_t>(found - column.islands.begin())];
  const double start = letter.inverse ? column.right : column.left, end = letter.inverse ? column.left : column.right;
  const Word first = letter.inverse ? after : before.Inverse(), last = letter.inverse ? before : after.Inverse();
  for (const Letter side : first.letters()) AddLetter(side, drawing);
  drawing.insert(drawing.end(), {{start, ground_}, {start, height}, {end, height}, {end, ground_}});
  for (const Letter side : last.letters()) AddLetter(side, drawing);
}

Polyline WordDrawing::Draw(Point from, const Word& word, Point to) const {
  Polyline drawing{from, {from.x, ground_}};
  for (const Letter letter : word.letters()) AddLetter(letter, drawing);
  drawing.insert(drawing.end(), {{to.x, ground_}, to});
  return drawing;
}

}  // namespace tautline
