// Worlds of any size for benchmarks.
#ifndef TAUTLINE_BENCH_SYNTHETIC_MAP_H_
#define TAUTLINE_BENCH_SYNTHETIC_MAP_H_

#include <cstddef>
#include <cstdint>

#include "tautline/scene/scene.h"

namespace tautline {

struct SyntheticMapOptions {
  std::size_t vertices = 1000;  ///< Of all obstacles together, about; at least three for each.
  std::size_t obstacles = 50;
  std::uint64_t seed = 1;
};

/// A square with obstacles that do not touch: jagged stars of different sizes, each somewhere in its cell of a square
/// grid, so that the ground between them is a net of crooked ways. The side of a cell is 10 m. The same options give
/// the same world.
World SyntheticMap(const SyntheticMapOptions& options);

/// A crooked corridor with so many vertices, from left to right, 1 m wide: any sleeve from end to end passes all of its
/// triangles. The way in the middle of it is `way`.
struct SyntheticCorridor {
  World world;
  Polyline way;
};
SyntheticCorridor MakeSyntheticCorridor(std::size_t vertices, std::uint64_t seed);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_SYNTHETIC_MAP_H_
