#include "tautline/geometry/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/grid_sketch.h"
#include "tautline/geometry/self_crossing.h"
#include "tautline/geometry/trace_cells.h"

namespace tautline {
namespace {

/// Round blobs on a free ground, so that boundaries are long stairs.
OccupancyGrid RandomBlobs(Rng& rng) {
  OccupancyGrid grid = MakeGrid(40, 30, CellState::kFree);
  const int blobs = rng.UniformInt(1, 8);
  for (int i = 0; i < blobs; ++i) {
    const Point centre{rng.Uniform(0, 40), rng.Uniform(0, 30)};
    const double radius = rng.Uniform(1, 9), inner = rng.UniformInt(0, 2) == 0 ? 0.6 * radius : 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const double distance = Distance(centre, {column + 0.5, row + 0.5});
        if (distance < radius && distance >= inner) grid.cells[grid.index(column, row)] = CellState::kBlocked;
      }
    }
  }
  return grid;
}

double DistanceToRing(const Ring& ring, Point p) {
  double least = 1e300;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    least = std::min(least, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  }
  return least;
}

/// The largest distance from a point of `from`, sampled, to `to`.
double Deviation(const Ring& from, const Ring& to) {
  double largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (const double t : {0.0, 0.25, 0.5, 0.75}) {
      largest = std::max(largest, DistanceToRing(to, Lerp(from[i], from[(i + 1) % from.size()], t)));
    }
  }
  return largest;
}

bool InClosed(const PolygonWithHoles& polygon, Point p) {
  if (!ContainsPoint(polygon.outer, p)) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(), [p](const Ring& hole) {
    const Winding winding = WindingNumber(hole, p);
    return !winding.on_boundary && winding.number != 0;
  });
}

void ExpectSimplified(const Ring& before, const Ring& after, double tolerance_m) {
  EXPECT_GE(after.size(), 3u);
  EXPECT_LE(after.size(), before.size());
  EXPECT_LE(Deviation(before, after), tolerance_m * (1 + 1e-12));
  EXPECT_LE(Deviation(after, before), tolerance_m * (1 + 1e-12));
  EXPECT_EQ(FindSelfCrossing(after), std::nullopt);
  EXPECT_GE(SignedArea(after), SignedArea(before) - 1e-9);
}

TEST(SimplifyOutwards, ASlopeOfStairsBecomesOneEdge) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"#....",  //
                                                          "##...",  //
                                                          "###..",  //
                                                          "####.",  //
                                                          "#####"}));
  const auto simple = SimplifyOutwards(polygons, 1.0);
  // The corners of the stairs lie on one line; the region keeps its bottom, its left side and the first and last step.
  EXPECT_LE(simple[0].outer.size(), 5u);
  EXPECT_DOUBLE_EQ(SignedArea(simple[0].outer), 15 + 4 * 0.5);
}

TEST(SimplifyOutwards, ATinyToleranceChangesNothing) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"##.",  //
                                                          "###"}));
  EXPECT_EQ(SimplifyOutwards(polygons, 1e-3), polygons);
}

TEST(SimplifyOutwards, KeepsAPassageOpen) {
  // Either side of the passage may be filled, but not across it.
  const auto polygons = TraceBlockedCells(GridFromSketch({"####.####",  //
                                                          "###...###",  //
                                                          "####.####"}));
  const auto simple = SimplifyOutwards(polygons, 3.0);
  ASSERT_EQ(simple.size(), 2u);
  EXPECT_LE(BoundingBox(simple[0].outer).high.x, 4);
  EXPECT_GE(BoundingBox(simple[1].outer).low.x, 5);
}

TEST(SimplifyOutwards, DoesNotSwallowAnIsland) {
  const auto polygons = TraceBlockedCells(GridFromSketch({"#...#",  //
                                                          "#.#.#",  //
                                                          "#...#",  //
                                                          "#####"}));
  const auto simple = SimplifyOutwards(polygons, 10.0);
  ASSERT_EQ(simple.size(), 2u);
  EXPECT_FALSE(ContainsPoint(simple[0].outer, {2.5, 2.5}));
}

TEST(SimplifyOutwards, GrowsWithinTheToleranceOnRandomBlobs) {
  Rng rng(11);
  for (int i = 0; i < ScaledTestCount(150); ++i) {
    const OccupancyGrid grid = RandomBlobs(rng);
    const double tolerance_m = rng.Uniform(0.2, 3);
    const auto before = TraceBlockedCells(grid);
    const auto after = SimplifyOutwards(before, tolerance_m);
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
      ExpectSimplified(before[k].outer, after[k].outer, tolerance_m);
      ASSERT_EQ(after[k].holes.size(), before[k].holes.size());
      for (std::size_t h = 0; h < before[k].holes.size(); ++h) {
        ExpectSimplified(before[k].holes[h], after[k].holes[h], tolerance_m);
      }
      for (int sample = 0; sample < 200; ++sample) {
        const Point p{rng.Uniform(0, 40), rng.Uniform(0, 30)};
        EXPECT_TRUE(!InClosed(before[k], p) || InClosed(after[k], p));
      }
    }
  }
}

TEST(SimplifyOutwards, RemovesMostCornersOfADisc) {
  OccupancyGrid grid = MakeGrid(200, 200, CellState::kFree);
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 200; ++column) {
      if (Distance({column + 0.5, row + 0.5}, {100, 100}) < 90) {
        grid.cells[grid.index(column, row)] = CellState::kBlocked;
      }
    }
  }
  const auto before = TraceBlockedCells(grid);
  const auto after = SimplifyOutwards(before, 1.5);
  EXPECT_LT(after[0].outer.size() * 4, before[0].outer.size());
}

}  // namespace
}  // namespace tautline
