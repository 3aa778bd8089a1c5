// A word drawn as a polyline among the representative points of the obstacles.
#ifndef TAUTLINE_HOMOTOPY_WORD_DRAWING_H_
#define TAUTLINE_HOMOTOPY_WORD_DRAWING_H_

#include <cstddef>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/homotopy/word.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Draws words in the plane without the representative points: below all of them nothing is crossed, and a letter is
/// a trip from there up beside its ray, across it just above its start, and down again.
class WordDrawing {
 public:
  /// Lines are drawn at random places between the columns of the rays, so that they meet no vertex by chance.
  WordDrawing(const FreeSpace& space, Rng& rng);

  /// A polyline from `from` to `to`, neither in the column of a ray, whose word is `word`.
  Polyline Draw(Point from, const Word& word, Point to) const;

 private:
  /// The rays that share an x, or nearly, from the lowest start up, and lines beside and above them.
  struct Column {
    double left;   ///< The least x of the rays; once they are gathered, that of a line to the left of them.
    double right;  ///< The same on the right.
    std::vector<ObstacleId> islands;
    std::vector<double> above;  ///< A height between the start of each ray and the next higher one's.
  };

  void GatherColumns(const FreeSpace& space, double extent);
  void AddCrossing(const Column& column, std::size_t k, bool inverse, Polyline& drawing) const;
  void AddLetter(Letter letter, Polyline& drawing) const;

  std::vector<Column> columns_;  ///< From left to right.
  std::vector<std::size_t> column_of_island_;
  std::vector<std::size_t> rank_of_island_;  ///< In the order in which a traveller to the right meets the rays.
  double ground_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_WORD_DRAWING_H_
