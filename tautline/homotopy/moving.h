// Words when the points that write their letters move [Wang2018, Sec. IV-C.2].
#ifndef TAUTLINE_HOMOTOPY_MOVING_H_
#define TAUTLINE_HOMOTOPY_MOVING_H_

#include <cstddef>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/word.h"

namespace tautline {

/// A carried word is given up when it has more letters than this and four for each of its own and for each time that
/// two punctures changed places: every turn of three points around each other can multiply the length of a word, so
/// that a short list of motions can ask for more letters than there is memory.
inline constexpr std::size_t kMostCarriedLetters = 2000;

/// What a moving point was led exactly through, so that nobody can say on which side it passed.
struct PunctureCollision {
  std::optional<ObstacleId> puncture;  ///< A puncture.
  std::optional<std::size_t> end;      ///< Or an end of paths.
};

/// Points of the plane that move, one after the other, while paths between fixed ends give way to them: what becomes of
/// the words of the paths. Every puncture has an upward ray with the conventions of Rays: left to right writes the
/// letter, an end in the column of a ray is to its right, and rays of one column are ordered by id; that is, the k-th
/// puncture acts as if it stood k infinitesimal steps farther to the right, and ends as if they stood farther still.
///
/// Words change only when a moving puncture a changes places with a puncture b in that order. When a passes above b,
/// from left to right, a curve over both of them, a b before, is b a after, and a curve between them, b, remains: so
/// every a becomes b a b^-1; from right to left, b^-1 a b. When a passes below b, it is b that passes above a, the
/// other way. When the ray of a passes from the left of an end to its right, a path that ends there loses its last
/// crossing, a^-1, and one that starts there gains it, a.
class MovingPunctures {
 public:
  /// Where the punctures are, by the ids of their letters, and where the ends of paths are. O(n log n).
  MovingPunctures(std::vector<Point> punctures, std::vector<Point> ends);

  /// Moves a puncture straight to a place. Two that move at once are moved in turns. Exact. Fails, and moves nothing,
  /// when the way leads exactly through another puncture or an end, or starts or ends at one; staying is no way.
  /// O(log n + k log k + punctures moved past) for k punctures in the columns passed.
  tl::expected<void, PunctureCollision> Move(ObstacleId puncture, Point to);

  /// The reduced word, after all moves, of a path whose word was `word` before all of them. `start` and `end` are the
  /// ends that it leads from and to. Nothing when it grows too long, see kMostCarriedLetters. O(moves past each other *
  /// letters).
  std::optional<Word> Carry(const Word& word, std::size_t start, std::size_t end) const;

  /// Where the punctures are now, by id.
  std::span<const Point> punctures() const { return punctures_; }

 private:
  /// Something that a ray passed. With no `end`, every `letter` becomes by * letter * by^-1; otherwise paths to the end
  /// are continued by `by`.
  struct Passage {
    std::optional<std::size_t> end;
    ObstacleId letter;
    Letter by;
  };
  /// A passage, and when it comes on the way.
  struct Meeting {
    double x;
    std::size_t rank;
    Passage passage;
  };

  bool IsBefore(ObstacleId a, ObstacleId b) const;
  std::optional<PunctureCollision> FindCollision(ObstacleId puncture, Point to) const;
  std::vector<Meeting> Meetings(ObstacleId puncture, Point to) const;
  std::span<const ObstacleId> InColumns(double low, double high) const;

  std::vector<Point> punctures_;
  std::vector<Point> ends_;
  std::vector<ObstacleId> by_column_;  ///< In the order of the rays.
  std::vector<Passage> passages_;      ///< Of all moves, in their order.
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_MOVING_H_
