#include "tautline/geometry/crossing_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/polygon.h"

namespace tautline {
namespace {

/// The oracle compares all pairs.
RingEdges AllPairs(const Ring& ring) {
  RingEdges edges(ring);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t j = i + 1; j < ring.size(); ++j) edges.Compare(i, j);
  }
  return edges;
}

/// Of a small lattice mostly, so that edges touch, run along each other and meet in vertices; else anywhere.
Ring RandomRing(Rng& rng) {
  const int size = rng.UniformInt(4, 14), lattice = rng.UniformInt(0, 6);
  Ring ring;
  while (static_cast<int>(ring.size()) < size) {
    const Point p = lattice == 0 ? Point{rng.Uniform(), rng.Uniform()}
                                 : Point{1.0 * rng.UniformInt(0, lattice), 1.0 * rng.UniformInt(0, lattice)};
    if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
  }
  return ring;
}

/// A ring that grows by detours which cross nothing, so that there are many that touch themselves only.
Ring RandomTouchingRing(Rng& rng) {
  const int side = rng.UniformInt(2, 5), attempts = rng.UniformInt(10, 60);
  const auto any = [&] { return Point{1.0 * rng.UniformInt(0, side), 1.0 * rng.UniformInt(0, side)}; };
  Ring ring{{0, 0}, {1.0 * side, 0}, {1.0 * side, 1.0 * side}, {0, 1.0 * side}};
  for (int i = 0; i < attempts; ++i) {
    Ring next = ring;
    const auto at = rng.UniformInt(0, static_cast<int>(ring.size()) - 1);
    next.insert(next.begin() + at, any());
    bool repeats = false;
    for (std::size_t k = 0; k < next.size(); ++k) repeats = repeats || next[k] == next[(k + 1) % next.size()];
    if (!repeats && !AllPairs(next).crossing()) ring = next;
  }
  return ring;
}

void ExpectThatOfAllPairs(const Ring& ring) {
  const RingEdges expected = AllPairs(ring);
  RingEdges edges(ring);
  SweepForCrossing(edges);
  ASSERT_EQ(edges.crossing().has_value(), expected.crossing().has_value());
  if (expected.crossing()) {
    RingEdges named(ring);
    named.Compare(edges.crossing()->first, edges.crossing()->second);
    ASSERT_EQ(named.crossing(), edges.crossing());
  } else {
    ASSERT_EQ(edges.run_along().has_value(), expected.run_along().has_value());
  }
}

TEST(SweepForCrossing, AgreesWithAllPairsOnRandomRings) {
  const std::int64_t count = ScaledTestCount(20000);
  int crossing = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Ring ring = RandomRing(rng);
    crossing += AllPairs(ring).crossing() ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(ExpectThatOfAllPairs(ring));
  }
  EXPECT_GT(crossing, count / 10);
  EXPECT_LT(crossing, count);
}

TEST(SweepForCrossing, AgreesWithAllPairsOnRingsThatTouchThemselves) {
  const std::int64_t count = ScaledTestCount(1000);
  int along = 0;
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    Ring ring = RandomTouchingRing(rng);
    along += AllPairs(ring).run_along() ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(ExpectThatOfAllPairs(ring));
    // With one vertex moved it crosses itself in one place, or not at all.
    ring[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1))] = {rng.Uniform(0, 5),
                                                                                            rng.Uniform(0, 5)};
    ASSERT_NO_FATAL_FAILURE(ExpectThatOfAllPairs(ring));
  }
  EXPECT_GT(along, count / 10);
}

}  // namespace
}  // namespace tautline
