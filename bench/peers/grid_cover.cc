#include "bench/peers/grid_cover.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr std::array<std::pair<int, int>, 8> kDirections{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

using Queue =
    std::priority_queue<std::pair<double, std::int32_t>, std::vector<std::pair<double, std::int32_t>>, std::greater<>>;

}  // namespace

GridCover::GridCover(const TautSpace& space, double cell) : cell_(cell) {
  const Box& box = space.free_space().box;
  low_ = box.low;
  columns_ = static_cast<int>(std::ceil(box.size().x / cell));
  rows_ = static_cast<int>(std::ceil(box.size().y / cell));
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  free_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point centre = CentreOf(static_cast<std::int32_t>(i));
    const auto place = space.Locate(centre);
    free_[i] = place && place->point == centre;
  }
  const auto block = [this](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) BlockBoundary(ring[i], ring[(i + 1) % ring.size()]);
  };
  for (const FreeComponent& component : space.free_space().components) {
    block(component.outer.points);
    for (const BoundaryRing& hole : component.holes) block(hole.points);
  }
  AddSteps(space);
}

/// Blocks the cells that the segment passes through: those under each row's share of it, a little widened, so that
/// rounding never leaves one free.
void GridCover::BlockBoundary(Point a, Point b) {
  constexpr double kWider = 1e-9;  // Of a cell.
  if (b.y < a.y) std::swap(a, b);
  const auto row_of = [this](double y) { return (y - low_.y) / cell_; };
  const int first = std::max(0, static_cast<int>(std::floor(row_of(a.y) - kWider)));
  const int last = std::min(rows_ - 1, static_cast<int>(std::floor(row_of(b.y) + kWider)));
  for (int row = first; row <= last; ++row) {
    const auto x_at = [&](double y) {
      return a.y == b.y ? a.x : a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
    };
    double x0 = x_at(low_.y + row * cell_), x1 = a.y == b.y ? b.x : x_at(low_.y + (row + 1) * cell_);
    if (x1 < x0) std::swap(x0, x1);
    const int from = std::max(0, static_cast<int>(std::floor((x0 - low_.x) / cell_ - kWider)));
    const int to = std::min(columns_ - 1, static_cast<int>(std::floor((x1 - low_.x) / cell_ + kWider)));
    for (int column = from; column <= to; ++column) free_[Index(column, row)] = false;
  }
}

void GridCover::AddSteps(const TautSpace& space) {
  steps_.resize(free_.size());
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (!IsFree(column, row)) continue;
      const std::size_t cell = Index(column, row);
      for (std::size_t k = 0; k < kSteps; ++k) {
        const auto [dx, dy] = kDirections[k];
        if (!IsFree(column + dx, row + dy) || !IsFree(column + dx, row) || !IsFree(column, row + dy)) continue;
        const Point to = CentreOf(static_cast<std::int32_t>(Index(column + dx, row + dy)));
        const Word word = space.rays().WordOf(Polyline{CentreOf(static_cast<std::int32_t>(cell)), to});
        steps_[cell][k] = 1;
        if (word.empty()) continue;
        steps_[cell][k] = static_cast<std::int32_t>(2 + letters_.size());
        auto& letters = letters_.emplace_back();
        for (const Letter letter : word.letters()) letters.push_back(LetterNumber(letter));
      }
    }
  }
}

std::int32_t GridCover::CellAt(Point p) const {
  const int column = static_cast<int>(std::floor((p.x - low_.x) / cell_));
  const int row = static_cast<int>(std::floor((p.y - low_.y) / cell_));
  return IsFree(column, row) ? static_cast<std::int32_t>(Index(column, row)) : -1;
}

Point GridCover::CentreOf(std::int32_t cell) const {
  return low_ + cell_ * Point{cell % columns_ + 0.5, cell / columns_ + 0.5};
}

std::optional<Point> GridCover::CentreAt(Point p) const {
  const std::int32_t cell = CellAt(p);
  if (cell < 0) return std::nullopt;
  return CentreOf(cell);
}

double GridCover::Octile(std::int32_t a, std::int32_t b) const {
  const int dx = std::abs(a % columns_ - b % columns_), dy = std::abs(a / columns_ - b / columns_);
  return cell_ * (std::max(dx, dy) + (std::numbers::sqrt2 - 1) * std::min(dx, dy));
}

template <class Offer>
void GridCover::ForEachStep(WordTrie& words, const PeerState& state, Offer offer) const {
  const auto& steps = steps_[static_cast<std::size_t>(state.node)];
  for (std::size_t k = 0; k < kSteps; ++k) {
    if (steps[k] == 0) continue;
    const auto [dx, dy] = kDirections[k];
    std::int32_t word = state.word;
    if (steps[k] > 1) {
      for (const std::int32_t letter : letters_[static_cast<std::size_t>(steps[k] - 2)]) {
        word = words.Append(word, letter);
      }
    }
    offer(state.node + dy * columns_ + dx, word, cell_ * (k % 2 == 0 ? 1 : std::numbers::sqrt2));
  }
}

GridCover::Tethers GridCover::MakeTethers(Point base, const Options& options) const {
  Tethers tethers;
  Queue queue;
  const auto offer = [&](std::int32_t cell, std::int32_t word, double length) {
    if (length > options.max_length) return;
    const std::int32_t id = tethers.states.Obtain(cell, word);
    if (tethers.states[id].length <= length) return;
    tethers.states[id].length = length;
    queue.emplace(length, id);
  };
  offer(CellAt(base), 0, 0);
  while (!queue.empty()) {
    const std::int32_t id = queue.top().second;
    queue.pop();
    if (std::exchange(tethers.states[id].settled, true)) continue;
    tethers.gave_up = tethers.states.size() > options.max_states;
    if (tethers.gave_up) break;
    const PeerState state = tethers.states[id];
    ForEachStep(tethers.words, state,
                [&](std::int32_t cell, std::int32_t word, double step) { offer(cell, word, state.length + step); });
  }
  return tethers;
}

GridCover::Motion GridCover::Plan(Tethers& tethers, const Question& question, const Options& options) const {
  const std::int32_t robot = CellAt(question.robot), goal = CellAt(question.goal);
  TAUTLINE_CHECK(robot >= 0 && goal >= 0);
  StateTable states;
  Queue queue;
  const auto offer = [&](std::int32_t cell, std::int32_t word, double length) {
    if (tethers.states.Find(cell, word) < 0) return;
    const std::int32_t id = states.Obtain(cell, word);
    if (states[id].length <= length) return;
    states[id].length = length;
    queue.emplace(length + Octile(cell, goal), id);
  };
  Motion motion;
  offer(robot, tethers.words.Append(0, question.laid), 0);
  while (!queue.empty()) {
    const std::int32_t id = queue.top().second;
    queue.pop();
    if (std::exchange(states[id].settled, true)) continue;
    motion.gave_up = states.size() > options.max_states;
    if (motion.gave_up) break;
    const PeerState state = states[id];
    if (state.node == goal) {
      motion.length = state.length;
      break;
    }
    ForEachStep(tethers.words, state,
                [&](std::int32_t cell, std::int32_t word, double step) { offer(cell, word, state.length + step); });
  }
  motion.states = states.size();
  return motion;
}

}  // namespace tautline
