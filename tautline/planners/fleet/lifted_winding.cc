#include "tautline/planners/fleet/lifted_winding.h"

#include <algorithm>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Whether p comes before q in a counter-clockwise turn about `centre` that starts just after the upward ray, which
/// itself is infinitesimally to the left of straight up. Requires directions that differ, or are the same.
bool ComesBefore(Point centre, Point p, Point q) {
  const bool p_left = p.x < centre.x, q_left = q.x < centre.x;
  if (p_left != q_left) return p_left;
  const int turn = Orientation(centre, p, q);
  // Straight down comes before straight up.
  return turn != 0 ? turn > 0 : p.x == centre.x && p.y < centre.y && q.y > centre.y;
}

}  // namespace

void LiftedWinding::Count(int turn) {
  if (turn == 0) return;
  const auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == prefix_; });
  if (found == sums_.end()) {
    sums_.emplace_back(prefix_, turn);
  } else {
    found->second += turn;
  }
}

/// +1 where an arc around the point crosses its upward ray counter-clockwise, -1 clockwise.
int LiftedWinding::TurnAround(Point before, Point after, Side side) const {
  if (side == Side::kLeft) return ComesBefore(point_, after, before) ? 1 : 0;
  return ComesBefore(point_, before, after) ? -1 : 0;
}

/// Goes straight; `turn` is what the segment counts where it crosses the column of the point.
void LiftedWinding::Straight(Point from, Point to, int turn) {
  if (space_ == nullptr) {
    Count(turn);
    return;
  }
  const Word word = space_->rays().WordOf(std::vector<Point>{from, to});
  const auto& islands = space_->free_space().islands;
  bool counted = turn == 0;
  for (const Letter letter : word.letters()) {
    const double x = islands[letter.obstacle.index()].representative.x;
    // In one column, the ray of the point counts as the rightmost.
    const bool is_behind = from.x < to.x ? x > point_.x : x <= point_.x;
    if (!counted && is_behind) {
      Count(turn);
      counted = true;
    }
    prefix_.Append(letter);
  }
  if (!counted) Count(turn);
}

void LiftedWinding::Walk(std::span<const Point> polyline, std::span<const Side> sides, Side on_segment) {
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Point from = polyline[i - 1], to = polyline[i];
    if (to == point_) {
      Straight(from, to, 0);
      if (i + 1 < polyline.size()) Count(TurnAround(from, polyline[i + 1], sides[i]));
      continue;
    }
    int turn = 0;
    if (from != point_ && (from.x < point_.x) != (to.x < point_.x)) {
      const bool to_the_right = from.x < to.x;
      const int side = Orientation(from, to, point_);
      // Its ray is crossed where the point lies below the segment, that is, to the right of a traveller to the right.
      if (to_the_right ? side < 0 : side > 0) turn = to_the_right ? -1 : 1;
      if (side == 0) turn = TurnAround(from, to, on_segment);
    } else if (from != point_ && from.x == to.x && OnSegment(from, to, point_)) {
      turn = TurnAround(from, to, on_segment);
    }
    Straight(from, to, turn);
  }
}

int LiftedWinding::About(const Word& lift) const {
  const auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == lift; });
  return found == sums_.end() ? 0 : found->second;
}

std::vector<std::pair<Word, int>> LiftedWinding::NonZero() const {
  std::vector<std::pair<Word, int>> sums = sums_;
  sums.erase(std::remove_if(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; }), sums.end());
  return sums;
}

}  // namespace tautline
