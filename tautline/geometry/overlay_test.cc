#include "tautline/geometry/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/disjoint_sets.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

struct Input {
  Ring domain;
  std::vector<CoverRing> cover;
  std::int32_t sources = 0;
};

Input ToInput(Ring domain, const std::vector<PolygonWithHoles>& polygons) {
  Input input{std::move(domain), {}, static_cast<std::int32_t>(polygons.size())};
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const auto source = static_cast<std::int32_t>(i);
    const auto add = [&](Ring ring, bool counter_clockwise) {
      if ((SignedArea(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
      input.cover.push_back({std::move(ring), source});
    };
    add(polygons[i].outer, true);
    for (const Ring& hole : polygons[i].holes) add(hole, false);
  }
  return input;
}

Overlay ComputeOverlay(const Input& input) { return ComputeOverlay(input.domain, input.cover, input.sources); }

std::vector<Ring> RingsOf(const Input& input) {
  std::vector<Ring> rings{input.domain};
  for (const CoverRing& ring : input.cover) rings.push_back(ring.points);
  return rings;
}

template <class Visit>
void ForEachEdge(const Ring& ring, Visit visit) {
  for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
}

double DistanceToRings(const std::vector<Ring>& rings, Point p) {
  double least = 1e300;
  for (const Ring& ring : rings) {
    ForEachEdge(ring, [&](Point a, Point b) { least = std::min(least, DistanceToSegment(p, a, b)); });
  }
  return least;
}

bool FreeByInput(const Input& input, Point p) {
  if (WindingNumber(input.domain, p).number == 0) return false;
  std::vector<int> winding(static_cast<std::size_t>(input.sources), 0);
  for (const CoverRing& ring : input.cover) {
    winding[static_cast<std::size_t>(ring.source)] += WindingNumber(ring.points, p).number;
  }
  return std::all_of(winding.begin(), winding.end(), [](int number) { return number <= 0; });
}

/// How many free components hold p, by the winding numbers of their rings.
int FreeByOverlay(const Overlay& overlay, Point p) {
  std::vector<int> winding(static_cast<std::size_t>(overlay.free_count), 0);
  for (const OverlayRing& ring : overlay.rings) {
    winding[static_cast<std::size_t>(ring.free)] += WindingNumber(ring.points, p).number;
  }
  EXPECT_TRUE(std::all_of(winding.begin(), winding.end(), [](int number) { return number == 0 || number == 1; }));
  return std::accumulate(winding.begin(), winding.end(), 0);
}

/// Somewhere in the box, or so close to an edge or a vertex that its side is just decided.
Point SamplePoint(Rng& rng, const Box& box, const std::vector<Ring>& rings) {
  const int kind = rng.UniformInt(0, 3);
  if (kind == 0) return RandomPoint(rng, box);
  const Ring& ring = rings[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(rings.size()) - 1))];
  const auto i = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(ring.size()) - 1));
  const Point on = Lerp(ring[i], ring[(i + 1) % ring.size()], kind == 1 ? 0 : rng.Uniform());
  const double angle = rng.Uniform(0, 7);
  return on + std::pow(10, rng.Uniform(-11, 0)) * box.size().x * Point{std::cos(angle), std::sin(angle)};
}

void ExpectSameGround(Rng& rng, const Input& input, const Overlay& overlay, int samples) {
  const std::vector<Ring> rings = RingsOf(input);
  Box box;
  for (const Ring& ring : rings) {
    for (const Point p : ring) box.Add(p);
  }
  for (int k = 0; k < samples; ++k) {
    const Point p = SamplePoint(rng, box, rings);
    if (DistanceToRings(rings, p) <= 3 * overlay.grid) continue;
    ASSERT_EQ(FreeByOverlay(overlay, p), FreeByInput(input, p) ? 1 : 0) << p.x << " " << p.y;
  }
}

void ExpectNoProperCrossings(const Overlay& overlay) {
  std::vector<std::pair<Point, Point>> edges;
  for (const OverlayRing& ring : overlay.rings) {
    ForEachEdge(ring.points, [&](Point a, Point b) { edges.emplace_back(a, b); });
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_FALSE(CrossProperly(edges[i].first, edges[i].second, edges[j].first, edges[j].second));
    }
  }
}

void ExpectCleanRings(const Overlay& overlay) {
  std::vector<int> outers(static_cast<std::size_t>(overlay.free_count), 0);
  for (const OverlayRing& ring : overlay.rings) {
    const Ring& points = ring.points;
    ASSERT_GE(points.size(), 3u);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t j = (i + 1) % points.size();
      ASSERT_NE(Orientation(points[i], points[j], points[(j + 1) % points.size()]), 0);
      for (const double coordinate : {points[i].x, points[i].y}) {
        ASSERT_EQ(std::remainder(coordinate, overlay.grid), 0);
      }
    }
    ASSERT_GE(ring.free, 0);
    ASSERT_LT(ring.free, overlay.free_count);
    ASSERT_GE(ring.blocked, 0);
    ASSERT_LT(ring.blocked, overlay.blocked_count);
    if (SignedArea(points) > 0) ++outers[static_cast<std::size_t>(ring.free)];
  }
  ASSERT_TRUE(std::all_of(outers.begin(), outers.end(), [](int count) { return count == 1; }));
}

double FreeArea(const Overlay& overlay) {
  double area = 0;
  for (const OverlayRing& ring : overlay.rings) area += SignedArea(ring.points);
  return area;
}

/// The free area by vertical slabs between all vertices and crossings: slow and obvious.
double FreeAreaBySlabs(const Input& input) {
  std::vector<std::pair<Point, Point>> edges;
  std::vector<double> xs;
  for (const Ring& ring : RingsOf(input)) {
    ForEachEdge(ring, [&](Point a, Point b) {
      edges.emplace_back(std::min(a, b), std::max(a, b));
      xs.push_back(a.x);
    });
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto [a, b] = edges[i];
      const auto [c, d] = edges[j];
      if (!CrossProperly(a, b, c, d)) continue;
      const double t = Cross(c - a, d - c) / Cross(b - a, d - c);
      xs.push_back(Lerp(a, b, t).x);
    }
  }
  std::sort(xs.begin(), xs.end());
  double area = 0;
  for (std::size_t k = 1; k < xs.size(); ++k) {
    const double middle = 0.5 * (xs[k - 1] + xs[k]);
    std::vector<double> ys;
    for (const auto& [a, b] : edges) {
      if (a.x < middle && middle < b.x) ys.push_back(a.y + (b.y - a.y) * ((middle - a.x) / (b.x - a.x)));
    }
    std::sort(ys.begin(), ys.end());
    for (std::size_t i = 1; i < ys.size(); ++i) {
      if (FreeByInput(input, {middle, 0.5 * (ys[i - 1] + ys[i])})) {
        area += (xs[k] - xs[k - 1]) * (ys[i] - ys[i - 1]);
      }
    }
  }
  return area;
}

TEST(Overlay, AgreesWithWindingNumbersOnRandomPolygons) {
  const std::int64_t count = ScaledTestCount(45000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box = RandomBox(rng);
    const Input input = ToInput(RandomOutline(rng, box), RandomPolygons(rng, box));
    const Overlay overlay = ComputeOverlay(input);
    ExpectCleanRings(overlay);
    ExpectNoProperCrossings(overlay);
    ExpectSameGround(rng, input, overlay, 24);
    if (seed % 16 == 0) {
      const double whole = std::fabs(SignedArea(input.domain));
      EXPECT_NEAR(FreeArea(overlay), FreeAreaBySlabs(input), 1e-7 * whole);
    }
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace tautline
