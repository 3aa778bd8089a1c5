#include "tautline/geometry/snap_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/geometry/random_rings.h"

namespace tautline {
namespace {

using Node = SnapGrid::Node;
using Chain = std::vector<Node>;
__extension__ using Wide = __int128;

int Turn(Node a, Node b, Node c) {
  const Wide cross = static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
  return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}

bool CrossProperly(const GridSegment& s, const GridSegment& t) {
  return Turn(s.from, s.to, t.from) * Turn(s.from, s.to, t.to) < 0 &&
         Turn(t.from, t.to, s.from) * Turn(t.from, t.to, s.to) < 0;
}

std::vector<GridSegment> EdgesOf(const std::vector<Chain>& chains) {
  std::vector<GridSegment> edges;
  for (const Chain& chain : chains) {
    for (std::size_t i = 1; i < chain.size(); ++i) edges.push_back({chain[i - 1], chain[i]});
  }
  return edges;
}

std::vector<Node> NodesOf(const std::vector<Chain>& chains) {
  std::vector<Node> nodes;
  for (const Chain& chain : chains) nodes.insert(nodes.end(), chain.begin(), chain.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Node RandomNode(Rng& rng, std::int64_t half) {
  const auto side = static_cast<std::uint64_t>(2 * half + 1);
  return {static_cast<std::int64_t>(rng.Next() % side) - half, static_cast<std::int64_t>(rng.Next() % side) - half};
}

Node operator+(Node a, Node b) { return {a.x + b.x, a.y + b.y}; }

/// Segments that cross in many ways: on 9 x 9 nodes, on the largest grid, in thin bundles, with common ends, along one
/// line.
std::vector<GridSegment> RandomSegments(Rng& rng) {
  constexpr std::int64_t kLarge = std::int64_t{1} << 39;
  const std::int64_t half = rng.UniformInt(0, 1) == 0 ? 4 : rng.UniformInt(0, 1) == 0 ? 1000 : kLarge;
  const int count = rng.UniformInt(2, 14);
  std::vector<GridSegment> segments;
  while (segments.size() < static_cast<std::size_t>(count)) {
    const GridSegment fresh{RandomNode(rng, half), RandomNode(rng, half)};
    const int kind = segments.empty() ? 0 : rng.UniformInt(0, 5);
    const GridSegment old = segments.empty() ? fresh : segments[rng.Next() % segments.size()];
    if (kind <= 2) {
      segments.push_back(fresh);
    } else if (kind == 3) {
      segments.push_back({old.to, fresh.to});
    } else if (kind == 4) {
      segments.push_back({old.from + RandomNode(rng, 2), old.to + RandomNode(rng, 2)});
    } else {
      // Along one line: from the middle of the old one (when it is a node) as far again beyond its end.
      const Node step{(old.to.x - old.from.x) / 4, (old.to.y - old.from.y) / 4};
      segments.push_back({old.from + step, old.from + step + step + step});
    }
  }
  return segments;
}

/// Whether the segment passes well inside the pixel of the node (+1), well outside of it (-1), or neither (0).
int PassesPixel(const GridSegment& s, Node node) {
  for (const auto& [half, answer] : {std::pair(0.5L - 1e-5L, 1), std::pair(0.5L + 1e-5L, 0)}) {
    long double low = 0, high = 1;
    const auto clip = [&low, &high, half = half](long double from, long double step) {
      if (step == 0) {
        if (std::fabs(from) > half) high = -1;
        return;
      }
      const long double t0 = (-half - from) / step, t1 = (half - from) / step;
      low = std::max(low, std::min(t0, t1));
      high = std::min(high, std::max(t0, t1));
    };
    clip(static_cast<long double>(s.from.x - node.x), static_cast<long double>(s.to.x - s.from.x));
    clip(static_cast<long double>(s.from.y - node.y), static_cast<long double>(s.to.y - s.from.y));
    if (low <= high) return answer;
  }
  return -1;
}

void ExpectNoProperCrossings(const std::vector<Chain>& chains) {
  const std::vector<GridSegment> edges = EdgesOf(chains);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(CrossProperly(edges[i], edges[j]));
  }
}

/// Every chain joins the ends of its segment through exactly those nodes whose pixels it passes.
void ExpectChainsFollow(const std::vector<GridSegment>& segments, const std::vector<Chain>& chains) {
  ASSERT_EQ(chains.size(), segments.size());
  const std::vector<Node> nodes = NodesOf(chains);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Chain& chain = chains[s];
    ASSERT_EQ(chain.front(), segments[s].from);
    ASSERT_EQ(chain.back(), segments[s].to);
    ASSERT_EQ(std::adjacent_find(chain.begin(), chain.end()), chain.end());
    for (const Node node : nodes) {
      const int passes = PassesPixel(segments[s], node);
      if (passes == 0) continue;
      ASSERT_EQ(std::find(chain.begin(), chain.end(), node) != chain.end(), passes > 0);
    }
  }
}

TEST(SnapRound, RandomSegmentsMeetOnlyInNodes) {
  const std::int64_t count = ScaledTestCount(20000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const std::vector<GridSegment> segments = RandomSegments(rng);
    const std::vector<Chain> chains = SnapRound(segments);
    ExpectNoProperCrossings(chains);
    ExpectChainsFollow(segments, chains);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(SnapRound, ASecondRoundAddsNoNode) {
  // It may still bend an edge through a node whose pixel it has come to pass: snap rounding is not idempotent.
  const std::int64_t count = ScaledTestCount(5000);
  for (std::int64_t seed = 1; seed <= count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const std::vector<Chain> once = SnapRound(RandomSegments(rng));
    const std::vector<Chain> twice = SnapRound(EdgesOf(once));
    ExpectNoProperCrossings(twice);
    const std::vector<Node> nodes = NodesOf(once), nodes_twice = NodesOf(twice);
    ASSERT_TRUE(std::includes(nodes.begin(), nodes.end(), nodes_twice.begin(), nodes_twice.end()));
  }
}

TEST(SnapRound, ManyRandomSegmentsOnOnePlane) {
  Rng rng(1);
  std::vector<GridSegment> segments;
  for (int i = 0; i < 200; ++i) segments.push_back({RandomNode(rng, 3000), RandomNode(rng, 3000)});
  ExpectNoProperCrossings(SnapRound(segments));
}

TEST(SnapRound, BendsThroughTheNodeOfACrossing) {
  const std::vector<GridSegment> segments{{{0, 0}, {3, 1}}, {{0, 1}, {3, 0}}};
  const std::vector<Chain> chains = SnapRound(segments);
  // They cross in (1.5, 0.5), which belongs to the pixel of (2, 1).
  EXPECT_EQ(chains[0], (Chain{{0, 0}, {2, 1}, {3, 1}}));
  EXPECT_EQ(chains[1], (Chain{{0, 1}, {2, 1}, {3, 0}}));
}

TEST(SnapRound, SplitsOverlapsAtTheirEnds) {
  const std::vector<GridSegment> segments{{{0, 0}, {6, 3}}, {{8, 4}, {2, 1}}, {{4, 2}, {4, 2}}};
  const std::vector<Chain> chains = SnapRound(segments);
  EXPECT_EQ(chains[0], (Chain{{0, 0}, {2, 1}, {4, 2}, {6, 3}}));
  EXPECT_EQ(chains[1], (Chain{{8, 4}, {6, 3}, {4, 2}, {2, 1}}));
  EXPECT_EQ(chains[2], (Chain{{4, 2}}));
}

TEST(SnapGrid, RoundsToTheNearestNodeAndBack) {
  for (std::int64_t seed = 1; seed <= 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const Box box = RandomBox(rng);
    const SnapGrid grid(box);
    int exponent = 0;
    ASSERT_EQ(std::frexp(grid.spacing(), &exponent), 0.5);
    const double extent = std::max(box.size().x, box.size().y);
    const double greatest =
        std::max({std::fabs(box.low.x), std::fabs(box.low.y), std::fabs(box.high.x), std::fabs(box.high.y)});
    ASSERT_LE(grid.spacing(), std::max(std::ldexp(extent, -39), std::ldexp(greatest, -50)));
    const Point p = RandomPoint(rng, box);
    const Point rounded = grid.ToPoint(grid.Round(p));
    ASSERT_LE(std::fabs(rounded.x - p.x), grid.spacing() / 2);
    ASSERT_LE(std::fabs(rounded.y - p.y), grid.spacing() / 2);
    ASSERT_EQ(grid.Round(rounded), grid.Round(p));
  }
}

TEST(SnapGrid, OfAPoint) {
  Box box;
  box.Add({3, 4});
  const SnapGrid grid(box);
  EXPECT_EQ(grid.ToPoint(grid.Round({3, 4})), (Point{3, 4}));
}

}  // namespace
}  // namespace tautline
