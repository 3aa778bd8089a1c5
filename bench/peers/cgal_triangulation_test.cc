#include "bench/peers/cgal_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/synthetic_map.h"
#include "bench/triangulation_input.h"
#include "tautline/base/rng.h"

namespace tautline {
namespace {

TEST(CgalTriangulation, LocatesTheTriangleThatTheLibraryLocates) {
  const World world = SyntheticMap({.vertices = 2000, .obstacles = 100});
  TriangulationInput input = InputOf(world);
  const Triangulation mesh = Triangulation::Build(input.points, input.edges);
  // The library's frame belongs to its triangulation.
  for (const Point p : mesh.points().last(4)) input.points.push_back(p);
  CgalTriangulation cgal(CgalInput(input.points, input.edges));
  Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    const Point p{rng.Uniform(0, world.outline[2].x), rng.Uniform(0, world.outline[2].y)};
    const TriangleId triangle = mesh.Locate(p);
    std::array<Point, 3> mine{mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)};
    std::array<Point, 3> theirs = cgal.Locate(p);
    std::sort(mine.begin(), mine.end());
    std::sort(theirs.begin(), theirs.end());
    ASSERT_EQ(mine, theirs);
  }
}

}  // namespace
}  // namespace tautline
