// Random places in a free space.
#ifndef TAUTLINE_BENCH_FREE_POINTS_H_
#define TAUTLINE_BENCH_FREE_POINTS_H_

#include <vector>

#include "tautline/base/rng.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// `count` random points of the largest connected part of the free ground, evenly spread over it.
std::vector<Point> RandomFreePoints(Rng& rng, const TautSpace& space, std::size_t count);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_FREE_POINTS_H_
