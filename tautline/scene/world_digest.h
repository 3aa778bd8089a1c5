// A number that tells worlds apart.
#ifndef TAUTLINE_SCENE_WORLD_DIGEST_H_
#define TAUTLINE_SCENE_WORLD_DIGEST_H_

#include <cstdint>

#include "tautline/scene/scene.h"

namespace tautline {

/// Of everything in a world that its free space and its words depend on, to the bit: outline, obstacles with their
/// names and representatives, clearance and snap. Equal worlds have equal digests; different ones have different
/// digests but by a chance of 2^-64. No protection against intent. O(n).
std::uint64_t WorldDigest(const World& world);

/// Of everything that the best places of winches depend on: the world, the tasks and the futures. O(n).
std::uint64_t WorkspaceDigest(const Scene& scene);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_WORLD_DIGEST_H_
