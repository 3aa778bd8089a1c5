#include "tautline/homotopy/string_line.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// Whether r is nearer to c than q is, for points on one ray from c. Exact.
bool IsNearer(Point c, Point q, Point r) {
  if (q.x != c.x) return q.x > c.x ? r.x < q.x : r.x > q.x;
  return q.y > c.y ? r.y < q.y : r.y > q.y;
}

/// What a change of the angle swept by `turn` (its sign) does to the whole turns, where the principal angle was
/// `before` and is now `after`. The change is less than half a turn.
int Carry(int turn, int before, int after) {
  if (turn > 0 && before > 0 && after < 0) return 1;
  return turn < 0 && before < 0 && after > 0 ? -1 : 0;
}

/// Pulls one string.
class Puller {
 public:
  Puller(StringLine& line, const PinsNear& pins_near) : line_(line), pins_near_(pins_near) {}

  void Pull() {
    for (std::size_t i = 1; i + 1 < line_.size();) {
      if (IsHeld(i)) {
        ++i;
        continue;
      }
      Remove(i);
      i = std::max<std::size_t>(i, 2) - 1;
    }
  }

 private:
  using Offset = StringLine::difference_type;

  bool IsHeld(std::size_t i) const {
    const StringVertex& v = line_[i];
    return v.pin.valid() && HeldSide(v, line_[i - 1].at, line_[i + 1].at) != Side::kNone;
  }

  void Erase(std::size_t first, std::size_t count) {
    const auto at = line_.begin() + static_cast<Offset>(first);
    line_.erase(at, at + static_cast<Offset>(count));
  }

  void Remove(std::size_t i) {
    StringVertex &u = line_[i - 1], &w = line_[i + 1];
    if (u.pin.valid() && u.pin == w.pin) return Merge(i);
    const Point v = line_[i].at;
    const int turn = Orientation(u.at, v, w.at);
    if (turn == 0) {
      // Pins lie on no edge, so that only the end of a string can stand on the one that leads away from it.
      TAUTLINE_CHECK(Dot(v - u.at, w.at - v) > 0 || i == 1 || i + 2 == line_.size());
      return Erase(i, 1);
    }
    std::vector<StringVertex> inside;
    pins_near_(u.at, v, w.at, [&](PinId pin, Point p) {
      if (turn * Orientation(u.at, v, p) > 0 && turn * Orientation(v, w.at, p) > 0 &&
          turn * Orientation(w.at, u.at, p) >= 0) {
        inside.push_back({pin, p});
      }
    });
    StringLine chain = ChainAround(u.at, w.at, turn, std::move(inside));
    if (i > 1) ExchangeNext(u, line_[i - 2].at, v, chain.empty() ? w.at : chain.front().at);
    if (i + 2 < line_.size()) ExchangePrevious(w, line_[i + 2].at, v, chain.empty() ? u.at : chain.back().at);
    Erase(i, 1);
    line_.insert(line_.begin() + static_cast<Offset>(i), chain.begin(), chain.end());
  }

  /// The string leads from a pin to vertex i and back: what it sweeps there adds up. About its own end it may turn as
  /// it likes.
  void Merge(std::size_t i) {
    if (i == 1) return Erase(i, 2);
    if (i + 2 == line_.size()) return Erase(i - 1, 2);
    const Point p = line_[i - 1].at, before = line_[i - 2].at, via = line_[i].at, after = line_[i + 2].at;
    const int first = AngleAt(p, before, via), second = AngleAt(p, via, after), both = AngleAt(p, before, after);
    int turns = line_[i - 1].turns + line_[i + 1].turns;
    if (first > 0 && second > 0 && both <= 0) ++turns;
    if (first < 0 && second < 0 && both > 0) --turns;
    line_[i - 1].turns = turns;
    Erase(i, 2);
  }

  StringLine& line_;
  const PinsNear& pins_near_;
};

}  // namespace

int AngleAt(Point p, Point from, Point to) {
  const int turn = Orientation(p, from, to);
  if (turn != 0) return turn;
  // Of collinear vectors both products have one sign.
  return Dot(from - p, to - p) > 0 ? 0 : 2;
}

int TurnsOf(Point before, Point at, Point after, Side side) {
  if (side == Side::kRight) return -1;
  return AngleAt(at, before, after) == 2 ? 0 : 1;
}

void ExchangeNext(StringVertex& vertex, Point before, Point old_next, Point next) {
  vertex.turns += Carry(Orientation(vertex.at, old_next, next), AngleAt(vertex.at, before, old_next),
                        AngleAt(vertex.at, before, next));
}

void ExchangePrevious(StringVertex& vertex, Point after, Point old_previous, Point previous) {
  vertex.turns += Carry(-Orientation(vertex.at, old_previous, previous), AngleAt(vertex.at, old_previous, after),
                        AngleAt(vertex.at, previous, after));
}

StringLine ChainAround(Point u, Point w, int turn, std::vector<StringVertex> pins) {
  StringLine chain;
  std::vector<Point> corners{u};
  while (!pins.empty()) {
    const Point c = corners.back();
    Point next = w;
    std::size_t found = pins.size();
    for (std::size_t k = 0; k < pins.size(); ++k) {
      const int side = turn * Orientation(c, next, pins[k].at);
      if (side > 0 || (side == 0 && !IsNearer(c, next, pins[k].at))) continue;
      next = pins[k].at;
      found = k;
    }
    if (found == pins.size()) break;
    chain.push_back(pins[found]);
    corners.push_back(next);
    pins[found] = pins.back();
    pins.pop_back();
  }
  corners.push_back(w);
  const Side side = turn > 0 ? Side::kLeft : Side::kRight;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    chain[k].turns = TurnsOf(corners[k], corners[k + 1], corners[k + 2], side);
  }
  return chain;
}

void PullTaut(StringLine& line, const PinsNear& pins_near) { Puller(line, pins_near).Pull(); }

Side HeldSide(const StringVertex& vertex, Point before, Point after) {
  if (vertex.turns < 0) return Side::kRight;
  if (vertex.turns > 0) return Side::kLeft;
  return AngleAt(vertex.at, before, after) == 2 ? Side::kLeft : Side::kNone;
}

}  // namespace tautline
