#include "tautline/homotopy/string_loop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace tautline {
namespace {

Point Unit(Point p) { return (1 / Norm(p)) * p; }

Point LeftOf(Point p) { return {-p.y, p.x}; }

/// Counter-clockwise around a point, from the direction of another one back to it.
void AddCircle(Point centre, Point from, double gap, Polyline& curve) {
  const Point x = gap * Unit(from - centre), y = LeftOf(x);
  for (const Point step : std::array{x, y, -1 * x, -1 * y, x}) curve.push_back(centre + step);
}

}  // namespace

Polyline LedAside(std::span<const Point> line, std::span<const Side> sides, double gap) {
  Polyline aside{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (sides[i] == Side::kNone) {
      aside.push_back(line[i]);
      continue;
    }
    const double away = sides[i] == Side::kLeft ? -gap : gap;
    const Point in = Unit(line[i] - line[i - 1]), out = Unit(line[i + 1] - line[i]);
    const Point normal = away * (LeftOf(in) + LeftOf(out)), ahead = gap * (in - out);
    aside.push_back(line[i] + away * LeftOf(in));
    // Around the tip of a turn; halfway between the two where it goes straight on.
    const Point tip = normal + ahead;
    if (Norm(tip) > 0) aside.push_back(line[i] + gap * Unit(tip));
    aside.push_back(line[i] + away * LeftOf(out));
  }
  if (line.size() > 1) aside.push_back(line.back());
  return aside;
}

Polyline LoopAround(std::span<const Point> line, std::span<const Side> sides, double gap) {
  Polyline way = LedAside(line, sides, gap);
  Polyline loop;
  AddCircle(way.front(), way[1], gap, loop);
  loop.insert(loop.end(), way.begin() + 1, way.end() - 1);
  AddCircle(way.back(), way[way.size() - 2], gap, loop);
  for (std::size_t i = way.size() - 1; i-- > 1;) loop.push_back(way[i]);
  loop.push_back(loop.front());
  return loop;
}

Word RingWord(const Word& word) {
  const auto letters = word.letters();
  std::size_t first = 0, last = letters.size();
  const auto cancel = [](Letter a, Letter b) { return a.obstacle == b.obstacle && a.inverse != b.inverse; };
  while (last - first > 1 && cancel(letters[first], letters[last - 1])) {
    ++first;
    --last;
  }
  std::vector<Letter> ring(letters.begin() + static_cast<std::ptrdiff_t>(first),
                           letters.begin() + static_cast<std::ptrdiff_t>(last));
  std::vector<Letter> least = ring;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    least = std::min(least, ring);
  }
  Word turned;
  for (const Letter letter : least) turned.Append(letter);
  return turned;
}

}  // namespace tautline
