#include "tautline/geometry/box_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

double DistanceBetween(BoxIndex::Segment s, BoxIndex::Segment t) {
  if (CrossProperly(s.first, s.second, t.first, t.second)) return 0;
  return std::min({DistanceToSegment(s.first, t.first, t.second), DistanceToSegment(s.second, t.first, t.second),
                   DistanceToSegment(t.first, s.first, s.second), DistanceToSegment(t.second, s.first, s.second)});
}

/// Whether the segment meets the box, which is taken as four sides and an inside.
bool MeetsBox(BoxIndex::Segment s, const Box& box) {
  const Ring sides = Rectangle(box.low, box.high);
  if (ContainsPoint(sides, s.first)) return true;
  for (std::size_t i = 0; i < 4; ++i) {
    if (DistanceBetween(s, {sides[i], sides[(i + 1) % 4]}) == 0) return true;
  }
  return false;
}

/// Long ones, short ones, points, and upright and level ones.
BoxIndex::Segment RandomSegment(Rng& rng, const Box& box) {
  const Point a = RandomPoint(rng, box), b = RandomPoint(rng, box);
  switch (rng.UniformInt(0, 4)) {
    case 0:
      return {a, a};
    case 1:
      return {a, {a.x, b.y}};
    case 2:
      return {a, {b.x, a.y}};
    case 3:
      return {a, Lerp(a, b, std::pow(10, rng.Uniform(-12, 0)))};
    default:
      return {a, b};
  }
}

TEST(BoxIndex, FindsWhatBruteForceFinds) {
  const std::int64_t count = ScaledTestCount(2000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    Box box = RandomBox(rng);
    if (rng.UniformInt(0, 3) == 0) box.high.y = box.low.y + rng.Uniform(0, 1e-9) * box.size().x;
    std::vector<BoxIndex::Segment> segments;
    for (int i = rng.UniformInt(0, 40); i > 0; --i) segments.push_back(RandomSegment(rng, box));
    const BoxIndex index(segments);
    const BoxIndex::Segment query = RandomSegment(rng, box);
    const double margin = rng.UniformInt(0, 1) == 0 ? 0 : rng.Uniform(0, 0.1) * box.size().x;
    std::vector<bool> along(segments.size(), false), near(segments.size(), false);
    index.ForEachAlong(query.first, query.second, margin, [&](std::size_t i) { along[i] = true; });
    Box query_box;
    query_box.Add(query.first);
    query_box.Add(query.second);
    index.ForEachNear(query_box, [&](std::size_t i) { near[i] = true; });
    for (std::size_t i = 0; i < segments.size(); ++i) {
      ASSERT_TRUE(along[i] || DistanceBetween(query, segments[i]) > margin) << i;
      ASSERT_TRUE(near[i] || !MeetsBox(segments[i], query_box)) << i;
    }
  }
}

TEST(BoxIndex, VisitsFewOfMany) {
  Rng rng(1);
  const Box box{{0, 0}, {1000, 1000}};
  std::vector<BoxIndex::Segment> segments;
  for (int i = 0; i < 10000; ++i) {
    const Point a = RandomPoint(rng, box);
    segments.emplace_back(a, a + Point{rng.Uniform(-5, 5), rng.Uniform(-5, 5)});
  }
  const BoxIndex index(segments);
  std::size_t visits = 0;
  for (const auto& [a, b] : segments) index.ForEachAlong(a, b, 0, [&visits](std::size_t) { ++visits; });
  EXPECT_LT(visits, 20 * segments.size());
}

TEST(BoxIndex, OfNothing) {
  const BoxIndex index({});
  index.ForEachNear({{-1, -1}, {1, 1}}, [](std::size_t) { FAIL(); });
  index.ForEachAlong({-1, -1}, {1, 1}, 1, [](std::size_t) { FAIL(); });
}

}  // namespace
}  // namespace tautline
