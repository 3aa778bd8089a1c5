// The names of obstacles on the map: inside where they fit, else beside.
#ifndef TAUTLINE_DRAW_OBSTACLE_NAMES_H_
#define TAUTLINE_DRAW_OBSTACLE_NAMES_H_

#include <set>
#include <vector>

#include "tautline/draw/label_placer.h"
#include "tautline/draw/svg_writer.h"
#include "tautline/draw/view.h"
#include "tautline/homotopy/word.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Finds a place for the names of `needed` islands, largest first, and then of others: of all when
/// the map has up to kMostNamedIslands, of the kLargestNamed largest otherwise. Others are left out
/// where there is no room. The places are taken in `placer`.
std::vector<SvgText> PlaceObstacleNames(const FreeSpace& space, const View& view, const std::set<ObstacleId>& needed,
                                        LabelPlacer& placer);

/// The islands whose letters stand in a word.
std::set<ObstacleId> IslandsOf(const Word& word);

inline constexpr std::size_t kMostNamedIslands = 60;  ///< With more, only the largest are named.
inline constexpr std::size_t kLargestNamed = 8;       ///< How many are named then.

}  // namespace tautline

#endif  // TAUTLINE_DRAW_OBSTACLE_NAMES_H_
