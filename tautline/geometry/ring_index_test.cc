#include "tautline/geometry/ring_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

/// Any closed curve: a star, or points on a lattice in any order, which run along themselves and wind several times.
Ring RandomRing(Rng& rng, const Box& box) {
  if (rng.UniformInt(0, 1) == 0) return RandomStar(rng, box.centre(), box.size().x);
  Ring ring;
  const int count = rng.UniformInt(1, 20);
  for (int i = 0; i < count; ++i) {
    ring.push_back({static_cast<double>(rng.UniformInt(0, 6)), static_cast<double>(rng.UniformInt(0, 6))});
  }
  return ring;
}

/// Anywhere, on the lattice, or a vertex.
Point RandomPlace(Rng& rng, const Box& box, const Ring& ring) {
  const int kind = rng.UniformInt(0, 3);
  if (kind == 0) return RandomPoint(rng, box);
  if (kind == 1) return ring[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1))];
  return {static_cast<double>(rng.UniformInt(-1, 7)), static_cast<double>(rng.UniformInt(-1, 7))};
}

bool IsCrossed(const Ring& ring, Point a, Point b) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (CrossProperly(ring[i], ring[(i + 1) % ring.size()], a, b)) return true;
  }
  return false;
}

TEST(RingIndex, AnswersAsALookAtEveryEdge) {
  const Box box{{-1, -1}, {7, 7}};
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Ring ring = RandomRing(rng, box);
    const RingIndex index(ring);
    for (int i = 0; i < 20; ++i) {
      const Point p = RandomPlace(rng, box, ring), q = RandomPlace(rng, box, ring);
      const Winding found = index.WindingAt(p), expected = WindingNumber(ring, p);
      ASSERT_EQ(found.on_boundary, expected.on_boundary);
      if (!expected.on_boundary) {
        ASSERT_EQ(found.number, expected.number);
      }
      ASSERT_EQ(index.IsCrossedBy(p, q), IsCrossed(ring, p, q));
    }
  }
}

}  // namespace
}  // namespace tautline
