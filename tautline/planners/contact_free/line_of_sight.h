// Shortening a path by straight lines, within its class.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_LINE_OF_SIGHT_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_LINE_OF_SIGHT_H_

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// The path with detours cut off: from its first point on, always straight to the last of its points that can be
/// reached so [Shimada2024, Alg. 1]. A line counts only where it is of the class of the piece that it replaces, which
/// the free space and the word decide; the paper does not say so, but its dictionary is by class. Requires a path of a
/// point or more in the closed free space. The ends stay, and the length does not grow. O(points²) lines of sight at
/// worst.
Polyline ShortenByLineOfSight(const TautSpace& space, const Polyline& path);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_LINE_OF_SIGHT_H_
