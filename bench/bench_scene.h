// The scenes that benchmarks share.
#ifndef TAUTLINE_BENCH_BENCH_SCENE_H_
#define TAUTLINE_BENCH_BENCH_SCENE_H_

#include <string>
#include <vector>

#include "tautline/scene/scene.h"

namespace tautline {

/// A world to measure in. `tether` and `goals` only where the map has given ones.
struct BenchScene {
  World world;
  Tether tether;
  std::vector<Point> goals;
};

/// A map of scenes/maps/cdt2025: "maze" or "mess", with its tether and its goals. Throws std::runtime_error when it
/// cannot be read. Relative to the root of the repository.
BenchScene ReadCdt2025(const std::string& name);

/// A map of scenes/maps as a world with this clearance, metres. Throws std::runtime_error when it cannot be read.
BenchScene ReadMap(const std::string& path, double clearance);

}  // namespace tautline

#endif  // TAUTLINE_BENCH_BENCH_SCENE_H_
