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
    if (ring.area > 0) ++outers[static_cast<std::size_t>(ring.free)];
    const Point size = BoundingBox(points).size();
    ASSERT_NEAR(ring.area, SignedArea(points), 1e-12 * size.x * size.y);
  }
  ASSERT_TRUE(std::all_of(outers.begin(), outers.end(), [](int count) { return count == 1; }));
}

double FreeArea(const Overlay& overlay) {
  double area = 0;
  for (const OverlayRing& ring : overlay.rings) area += ring.area;
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

/// Lattice scenes by brute force: every cell of a lattice is cut by its diagonals into four triangles (south, east,
/// north, west), none of which a lattice polygon cuts.
class QuarterCells {
 public:
  static constexpr int kCells = 8;  ///< Along each side.

  explicit QuarterCells(const Input& input) : free_sets_(kCount), blocked_sets_(kNodes) {
    for (int quarter = 0; quarter < kCount; ++quarter) free_.push_back(FreeByInput(input, Inside(quarter)));
    for (int quarter = 0; quarter < kCount; ++quarter) {
      if (IsFree(quarter)) {
        JoinFree(quarter);
      } else {
        const auto nodes = NodesOf(quarter);
        blocked_sets_.Unite(nodes[0], nodes[1]);
        blocked_sets_.Unite(nodes[0], nodes[2]);
      }
    }
  }

  int FreeComponents() {
    std::set<std::size_t> roots;
    for (int quarter = 0; quarter < kCount; ++quarter) {
      if (IsFree(quarter)) roots.insert(free_sets_.Find(static_cast<std::size_t>(quarter)));
    }
    return static_cast<int>(roots.size());
  }

  int BlockedComponents() {
    std::set<std::size_t> roots;
    for (int quarter = 0; quarter < kCount; ++quarter) {
      if (!IsFree(quarter)) roots.insert(blocked_sets_.Find(NodesOf(quarter)[0]));
    }
    return static_cast<int>(roots.size());
  }

  /// Names the blocked component around a lattice corner.
  std::size_t BlockedAt(Point corner) {
    return blocked_sets_.Find(CornerNode(static_cast<int>(corner.x), static_cast<int>(corner.y)));
  }

  double FreeArea() const { return 0.25 * static_cast<double>(std::count(free_.begin(), free_.end(), true)); }

 private:
  static constexpr int kCount = 4 * kCells * kCells;
  static constexpr int kNodes = (kCells + 1) * (kCells + 1) + kCells * kCells;

  static Point Inside(int quarter) {
    constexpr std::array<Point, 4> kOffsets{{{0.5, 0.25}, {0.75, 0.5}, {0.5, 0.75}, {0.25, 0.5}}};
    const int cell = quarter / 4;
    return Point{1.0 * (cell % kCells), 1.0 * (cell / kCells)} + kOffsets[static_cast<std::size_t>(quarter % 4)];
  }
  static std::size_t CornerNode(int x, int y) { return static_cast<std::size_t>(y * (kCells + 1) + x); }

  static std::array<std::size_t, 3> NodesOf(int quarter) {
    const int cell = quarter / 4, x = cell % kCells, y = cell / kCells;
    const std::array<std::size_t, 4> corners{CornerNode(x, y), CornerNode(x + 1, y), CornerNode(x + 1, y + 1),
                                             CornerNode(x, y + 1)};
    const auto side = static_cast<std::size_t>(quarter % 4);
    return {corners[side], corners[(side + 1) % 4], CornerNode(0, kCells + 1) + static_cast<std::size_t>(cell)};
  }

  bool IsFree(int quarter) const { return free_[static_cast<std::size_t>(quarter)]; }

  void JoinFree(int quarter) {
    const int side = quarter % 4, cell = quarter / 4;
    const auto join = [&](int other) {
      if (IsFree(other)) free_sets_.Unite(static_cast<std::size_t>(quarter), static_cast<std::size_t>(other));
    };
    join(4 * cell + (side + 1) % 4);
    join(4 * cell + (side + 3) % 4);
    if (side == 1 && cell % kCells + 1 < kCells) join(4 * (cell + 1) + 3);
    if (side == 2 && cell / kCells + 1 < kCells) join(4 * (cell + kCells) + 0);
  }

  std::vector<bool> free_;
  DisjointSets free_sets_, blocked_sets_;
};

/// A rectangle (perhaps hollow), a diamond or a right triangle with corners on the lattice, off its border.
PolygonWithHoles RandomLatticePolygon(Rng& rng) {
  const int x = rng.UniformInt(1, 6), y = rng.UniformInt(1, 6);
  const int width = rng.UniformInt(1, 7 - x), height = rng.UniformInt(1, 7 - y);
  const Point low{1.0 * x, 1.0 * y}, high = low + Point{1.0 * width, 1.0 * height};
  const int kind = rng.UniformInt(0, 3);
  if (kind == 0 && std::min(width, height) >= 2) {
    const double r = std::min(width, height) / 2;
    const Point c = low + Point{r, r};
    return {{c - Point{0, r}, c + Point{r, 0}, c + Point{0, r}, c - Point{r, 0}}, {}};
  }
  if (kind == 1) {
    const double leg = std::min(width, height);
    Ring corners = Rectangle(low, low + Point{leg, leg});
    corners.erase(corners.begin() + rng.UniformInt(0, 3));
    return {corners, {}};
  }
  PolygonWithHoles polygon{Rectangle(low, high), {}};
  if (kind == 2 && std::min(width, height) >= 3)
    polygon.holes.push_back(Rectangle(low + Point{1, 1}, high - Point{1, 1}));
  return polygon;
}

TEST(Overlay, CountsComponentsOfLatticeScenes) {
  const std::int64_t count = ScaledTestCount(20000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<PolygonWithHoles> polygons;
    for (int i = rng.UniformInt(1, 9); i > 0; --i) polygons.push_back(RandomLatticePolygon(rng));
    // The border of the lattice is wall.
    const Input input = ToInput(Rectangle({1, 1}, {7, 7}), polygons);
    const Overlay overlay = ComputeOverlay(input);
    QuarterCells cells(input);
    ASSERT_EQ(overlay.free_count, cells.FreeComponents());
    ASSERT_EQ(overlay.blocked_count, cells.BlockedComponents());
    ASSERT_EQ(FreeArea(overlay), cells.FreeArea());
    ExpectCleanRings(overlay);
    ExpectNoProperCrossings(overlay);
    std::map<std::size_t, std::int32_t> numbers{{cells.BlockedAt({0, 0}), overlay.wall}};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const std::int32_t number = overlay.blocked_of_source[i];
      ASSERT_EQ(numbers.try_emplace(cells.BlockedAt(polygons[i].outer[0]), number).first->second, number);
    }
    for (const OverlayRing& ring : overlay.rings) {
      ASSERT_EQ(numbers.at(cells.BlockedAt(ring.points[0])), ring.blocked);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Overlay, WithinBlockedGroundNothingMatters) {
  // Needles thinner than the grid may come out turned around; they must not cut through what covers them.
  const std::int64_t count = ScaledTestCount(3000);
  const Box inner{{150, 150}, {850, 850}};
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    std::vector<PolygonWithHoles> polygons{{Rectangle({100, 100}, {900, 900}), {}}};
    for (int i = rng.UniformInt(1, 6); i > 0; --i) {
      const Point a = RandomPoint(rng, inner), b = RandomPoint(rng, inner);
      const Point width = std::pow(10, rng.Uniform(-16, -9)) * Point{a.y - b.y, b.x - a.x};
      polygons.push_back({{a, Lerp(a, b, rng.Uniform()) + width, b}, {}});
    }
    const Overlay overlay = ComputeOverlay(ToInput(Rectangle({0, 0}, {1000, 1000}), polygons));
    ASSERT_EQ(overlay.rings.size(), 2u);
    ASSERT_EQ(overlay.free_count, 1);
    ASSERT_EQ(FreeArea(overlay), 1e6 - 64e4);
  }
}

/// The rings as sets of points, in an order of their own.
std::multiset<std::set<Point>> PointSets(const Overlay& overlay) {
  std::multiset<std::set<Point>> sets;
  for (const OverlayRing& ring : overlay.rings) sets.emplace(ring.points.begin(), ring.points.end());
  return sets;
}

TEST(Overlay, ALoopThatWindsBackwardsErasesNothingElse) {
  // A bow tie, of which one half winds clockwise, over a square.
  const std::vector<CoverRing> cover{{Rectangle({2, 2}, {6, 6}), 0}, {{{3, 3}, {5, 5}, {5, 3}, {3, 5}}, 1}};
  const Overlay overlay = ComputeOverlay(Rectangle({0, 0}, {8, 8}), cover, 2);
  EXPECT_EQ(overlay.free_count, 1);
  EXPECT_EQ(FreeArea(overlay), 64 - 16);
}

TEST(Overlay, TouchingObstaclesAreOneBlockedComponent) {
  // Two squares share the corner (4, 4).
  const std::vector<CoverRing> cover{{Rectangle({2, 2}, {4, 4}), 0}, {Rectangle({4, 4}, {6, 6}), 1}};
  const Overlay overlay = ComputeOverlay(Rectangle({0, 0}, {8, 8}), cover, 2);
  EXPECT_EQ(overlay.free_count, 1);
  EXPECT_EQ(overlay.blocked_count, 2);
  EXPECT_EQ(overlay.blocked_of_source[0], overlay.blocked_of_source[1]);
  EXPECT_NE(overlay.blocked_of_source[0], overlay.wall);
  ASSERT_EQ(overlay.rings.size(), 2u);
  const std::size_t around = overlay.rings[0].area < 0 ? 0 : 1;
  EXPECT_EQ(overlay.rings[around].points.size(), 8u) << "one ring goes through the corner twice";
}

TEST(Overlay, FreeGroundThatMeetsInAPointIsTwoComponents) {
  // Two blocked squares in opposite corners of a box leave two free squares that share the middle.
  const std::vector<CoverRing> cover{{Rectangle({0, 0}, {4, 4}), 0}, {Rectangle({4, 4}, {8, 8}), 1}};
  const Overlay overlay = ComputeOverlay(Rectangle({0, 0}, {8, 8}), cover, 2);
  EXPECT_EQ(overlay.free_count, 2);
  EXPECT_EQ(overlay.blocked_count, 1);
  const std::multiset<std::set<Point>> expected{{{0, 4}, {0, 8}, {4, 4}, {4, 8}}, {{4, 0}, {4, 4}, {8, 0}, {8, 4}}};
  EXPECT_EQ(PointSets(overlay), expected);
}

TEST(Overlay, ACourtyardIsAComponentOfItsOwn) {
  const std::vector<PolygonWithHoles> polygons{{Rectangle({1, 1}, {7, 7}), {Rectangle({2, 2}, {6, 6})}},
                                               {Rectangle({3, 3}, {4, 4}), {}}};
  const Overlay overlay = ComputeOverlay(ToInput(Rectangle({0, 0}, {8, 8}), polygons));
  EXPECT_EQ(overlay.free_count, 2);
  EXPECT_EQ(overlay.blocked_count, 3);
  EXPECT_NE(overlay.blocked_of_source[0], overlay.blocked_of_source[1]);
  EXPECT_EQ(FreeArea(overlay), 64 - 36 + 16 - 1);
}

TEST(Overlay, NothingLeftFree) {
  const std::vector<CoverRing> cover{{Rectangle({-1, -1}, {9, 9}), 0}};
  const Overlay overlay = ComputeOverlay(Rectangle({0, 0}, {8, 8}), cover, 1);
  EXPECT_EQ(overlay.free_count, 0);
  EXPECT_TRUE(overlay.rings.empty());
  EXPECT_EQ(overlay.blocked_of_source[0], overlay.wall);
}

TEST(Overlay, ARingThatVanishesOnTheGridHasNoComponent) {
  const std::vector<CoverRing> cover{{Rectangle({1, 1}, {1 + 1e-14, 1 + 1e-14}), 0}};
  const Overlay overlay = ComputeOverlay(Rectangle({0, 0}, {8, 8}), cover, 1);
  EXPECT_EQ(overlay.blocked_of_source[0], -1);
  EXPECT_EQ(overlay.blocked_count, 1);
}

}  // namespace
}  // namespace tautline
