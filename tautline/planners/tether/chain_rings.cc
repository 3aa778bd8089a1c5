#include "tautline/planners/tether/chain_rings.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/disjoint_sets.h"

namespace tautline {
namespace {

/// A gap this many tolerances wide cannot be rounding.
constexpr double kWidestGap = 1e4;

/// The direction of travel at the start or the end of a piece.
Point DirectionAt(const RegionPiece& piece, Point at) {
  if (!piece.is_arc()) return piece.to - piece.from;
  const Point out = at - piece.centre;
  return {-out.y, out.x};
}

/// How far to turn clockwise from `from` to `to`, in (0, 2 pi].
double ClockwiseAngle(Point from, Point to) {
  const double angle = std::atan2(Cross(to, from), Dot(to, from));
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

class Chainer {
 public:
  Chainer(std::vector<RegionPiece> pieces, double tolerance) : pieces_(std::move(pieces)), tolerance_(tolerance) {
    Cluster();
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const bool speck = start_[i] == end_[i] && Length(pieces_[i]) <= 4 * tolerance_;
      used_.push_back(speck);
      if (!speck) starts_.emplace_back(start_[i], i);
    }
    std::sort(starts_.begin(), starts_.end());
  }

  std::vector<RegionRing> Run() {
    std::vector<RegionRing> rings;
    for (const auto& [cluster, first] : starts_) {
      if (used_[first]) continue;
      RegionRing ring;
      std::optional<std::size_t> at = first;
      do {
        used_[*at] = true;
        ring.pieces.push_back(pieces_[*at]);
        at = After(*at, first);
      } while (at);
      Finish(ring);
      if (!ring.pieces.empty()) rings.push_back(std::move(ring));
    }
    std::stable_sort(rings.begin(), rings.end(),
                     [](const RegionRing& a, const RegionRing& b) { return a.area > b.area; });
    return rings;
  }

 private:
  /// Numbers the ends of all pieces such that ends that are close together share a number.
  void Cluster() {
    const std::size_t n = pieces_.size();
    const auto end = [this, n](std::size_t k) { return k < n ? pieces_[k].from : pieces_[k - n].to; };
    std::vector<std::size_t> by_x(2 * n);
    std::iota(by_x.begin(), by_x.end(), std::size_t{0});
    std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return end(a) < end(b); });
    DisjointSets sets(2 * n);
    for (std::size_t i = 0; i < by_x.size(); ++i) {
      for (std::size_t j = i + 1; j < by_x.size() && end(by_x[j]).x - end(by_x[i]).x <= tolerance_; ++j) {
        if (Distance(end(by_x[i]), end(by_x[j])) <= tolerance_) sets.Unite(by_x[i], by_x[j]);
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      start_.push_back(sets.Find(i));
      end_.push_back(sets.Find(n + i));
    }
  }

  /// The piece that follows; nothing when the ring closes.
  std::optional<std::size_t> After(std::size_t piece, std::size_t first) {
    const Point back = -1.0 * DirectionAt(pieces_[piece], pieces_[piece].to);
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    auto at = std::lower_bound(starts_.begin(), starts_.end(), std::pair(end_[piece], std::size_t{0}));
    for (; at != starts_.end() && at->first == end_[piece]; ++at) {
      if (used_[at->second] && at->second != first) continue;
      const RegionPiece& next = pieces_[at->second];
      const double angle = ClockwiseAngle(back, DirectionAt(next, next.from));
      if (angle >= least) continue;
      least = angle;
      best = at->second;
    }
    if (!best) best = Nearest(piece, first);
    return *best == first ? std::nullopt : best;
  }

  /// The piece that starts nearest to where one ends: rounding parted them by more than usual.
  std::size_t Nearest(std::size_t piece, std::size_t first) const {
    std::size_t best = first;
    for (const auto& [cluster, candidate] : starts_) {
      if (used_[candidate]) continue;
      if (Distance(pieces_[piece].to, pieces_[candidate].from) < Distance(pieces_[piece].to, pieces_[best].from)) {
        best = candidate;
      }
    }
    TAUTLINE_CHECK(Distance(pieces_[piece].to, pieces_[best].from) <= kWidestGap * tolerance_);
    return best;
  }

  static bool Continues(const RegionPiece& a, const RegionPiece& b) {
    if (a.kind != b.kind) return false;
    if (a.is_arc()) return a.centre == b.centre && a.radius == b.radius;
    return a.source == b.source && Dot(a.to - a.from, b.to - b.from) > 0;
  }

  static void Extend(RegionPiece& piece, const RegionPiece& by) {
    piece.to = by.to;
    piece.sweep = std::min(piece.sweep + by.sweep, 2 * std::numbers::pi);
  }

  /// Joins what belongs together and makes the ends meet exactly.
  static void Finish(RegionRing& ring) {
    std::vector<RegionPiece> joined;
    for (const RegionPiece& piece : ring.pieces) {
      if (!joined.empty() && Continues(joined.back(), piece)) {
        Extend(joined.back(), piece);
      } else {
        joined.push_back(piece);
      }
    }
    if (joined.size() > 1 && Continues(joined.back(), joined.front())) {
      Extend(joined.back(), joined.front());
      joined.front() = joined.back();
      joined.pop_back();
    }
    for (std::size_t i = 0; i < joined.size(); ++i) joined[i].to = joined[(i + 1) % joined.size()].from;
    ring.pieces = std::move(joined);
    for (const RegionPiece& piece : ring.pieces) ring.area += GreenArea(piece, ring.pieces[0].from);
  }

  std::vector<RegionPiece> pieces_;
  double tolerance_;
  std::vector<std::size_t> start_;  ///< The cluster of each piece's first end.
  std::vector<std::size_t> end_;
  std::vector<std::pair<std::size_t, std::size_t>> starts_;  ///< (cluster, piece), sorted.
  std::vector<bool> used_;
};

}  // namespace

std::vector<RegionRing> ChainRings(std::vector<RegionPiece> pieces, double tolerance) {
  return Chainer(std::move(pieces), tolerance).Run();
}

}  // namespace tautline
