// Ray words: the h-signature and the H-signature of a path [Wang2018, Sec. II], read off upward rays.
#ifndef TAUTLINE_HOMOTOPY_RAYS_H_
#define TAUTLINE_HOMOTOPY_RAYS_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/homotopy/word.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// One upward vertical ray per island of a free space. Conventions: left to right writes the letter, right to left
/// its inverse; a point whose x equals the ray's x counts as being to the right of the ray; rays that share a column
/// are ordered by ObstacleId, the lower one first for a traveller to the right.
class Rays {
 public:
  /// One ray from the representative of each island. O(n log n) for n islands.
  explicit Rays(const FreeSpace& space);

  /// One ray from each of some points, by ObstacleId, with the names of their letters. O(n log n) for n points.
  Rays(std::span<const Point> origins, std::vector<std::string> names);

  /// The reduced word of a polyline that does not pass through a representative point. Homotopic paths have equal
  /// words. O(log n) per segment and per crossing of a ray's column.
  Word WordOf(std::span<const Point> polyline) const;

  /// Per island: left-to-right minus right-to-left crossings (the H-signature; it forgets the order).
  std::vector<int> HomologyOf(std::span<const Point> polyline) const;

  /// The names of the islands, by ObstacleId.
  std::span<const std::string> names() const { return names_; }

 private:
  struct Ray {
    Point origin;
    ObstacleId obstacle;
  };

  template <class Visit>
  void ForEachCrossing(std::span<const Point> polyline, Visit visit) const;

  std::vector<Ray> by_x_;
  std::vector<std::string> names_;
};

/// The sum of a word's exponents per island: the H-signature that goes with an h-signature.
std::vector<int> Abelianize(const Word& word, std::size_t islands);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_RAYS_H_
