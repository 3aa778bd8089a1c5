// A base that stands closer to a wall than the clearance.
#ifndef TAUTLINE_HOMOTOPY_SOCKET_H_
#define TAUTLINE_HOMOTOPY_SOCKET_H_

#include <optional>

#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// Where the tether enters the grown free space.
struct Socket {
  Point base;              ///< Where the tether is tied, metres.
  Place exit;              ///< In the grown free space; the base itself when that is free.
  double stub_length = 0;  ///< From the base to the exit, metres; counts towards the tether.
};

/// The shortest straight way from the base to the grown free space of `space` that stays in `ungrown`, the free mesh of
/// the same world without clearance. Among equally short ones that whose exit comes first
/// by x, then y. Nothing when the base stands inside an obstacle, or when no exit is in sight. Looks at the triangles
/// in sight that are not much farther away than the exit, and at the boundary edges near each; O(n log n) for short
/// ways.
std::optional<Socket> FindSocket(const TautSpace& space, const FreeMesh& ungrown, Point base);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_SOCKET_H_
