// The cables of a film as lines that a viewer can move: every keyframe of a cable with the same number of points.
#ifndef TAUTLINE_DRAW_ALIGNED_KEYFRAMES_H_
#define TAUTLINE_DRAW_ALIGNED_KEYFRAMES_H_

#include <span>
#include <vector>

#include "tautline/geometry/polygon.h"

namespace tautline {

/// The same lines, with points repeated until all have as many as the longest: those that move least from each keyframe
/// to the next. Requires that no line is empty. O(keyframes * points²).
std::vector<Polyline> AlignedKeyframes(std::span<const Polyline> lines);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_ALIGNED_KEYFRAMES_H_
