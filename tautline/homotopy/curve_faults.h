// A check of taut curves by other means than those that found them.
#ifndef TAUTLINE_HOMOTOPY_CURVE_FAULTS_H_
#define TAUTLINE_HOMOTOPY_CURVE_FAULTS_H_

#include <string>
#include <vector>

#include "tautline/homotopy/taut_path.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Every fault of a taut curve in a free space, by its boundary rings alone: it lies in the free space, bends only at
/// boundary vertices and around the obstacle there, and has the length and the word that it claims. With a
/// `stub_space`, the first segment is a socket's and must lie in that, the free space without clearance.
/// O(corners * n) for n boundary vertices.
std::vector<std::string> CurveFaults(const FreeSpace& space, const TautPath& path,
                                     const FreeSpace* stub_space = nullptr);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_CURVE_FAULTS_H_
