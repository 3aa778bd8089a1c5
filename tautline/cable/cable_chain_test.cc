#include "tautline/cable/cable_chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

/// Eqs. 6 and 7 as printed, with a link length, for a chain whose reel is empty.
void PullLiterally(std::vector<Point>& x, Point to, double link, double first, int rounds) {
  const auto unit = [](Point v) { return (1 / Norm(v)) * v; };
  const std::size_t n = x.size();
  const Point base = x[0];
  const auto length = [&](std::size_t i) { return i == 0 ? first : link; };
  for (int round = 0; round < rounds; ++round) {
    x[n - 1] = to;
    for (std::size_t i = n - 1; i-- > 0;) x[i] = x[i + 1] + length(i) * unit(x[i] - x[i + 1]);
    x[0] = base;
    for (std::size_t i = 1; i < n; ++i) x[i] = x[i - 1] + length(i - 1) * unit(x[i] - x[i - 1]);
  }
  x[n - 1] = to;
}

TEST(CableChain, ComesOffTheReelInAStraightLine) {
  CableChain chain(std::vector<Point>{{0, 0}}, {.length_m = 5});
  for (int i = 1; i <= 45; ++i) ASSERT_TRUE(chain.Pull({0.1 * i, 0}));
  EXPECT_NEAR(chain.paid_out_m(), 4.5, 1e-12);
  ASSERT_EQ(chain.nodes().size(), 6);
  EXPECT_NEAR(chain.nodes()[1].x, 0.5, 1e-12);
  EXPECT_NEAR(chain.nodes()[4].x, 3.5, 1e-12);
}

TEST(CableChain, RefusesWhatItCannotReach) {
  CableChain chain(std::vector<Point>{{0, 0}}, {.length_m = 2});
  ASSERT_TRUE(chain.Pull({1.5, 0}));
  const std::vector<Point> before(chain.nodes().begin(), chain.nodes().end());
  EXPECT_FALSE(chain.Pull({0, 2.01}));
  EXPECT_EQ(before, std::vector<Point>(chain.nodes().begin(), chain.nodes().end()));
  EXPECT_TRUE(chain.Pull({1.99, 0}));
}

TEST(CableChain, LaidAlongACornerHasNodesOneLinkApart) {
  const std::vector<Point> laid{{0, 0}, {2.5, 0}, {2.5, 2}};
  const CableChain chain(laid, {.length_m = 9});
  const auto nodes = chain.nodes();
  EXPECT_EQ(nodes.front(), laid.front());
  EXPECT_EQ(nodes.back(), laid.back());
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) EXPECT_NEAR(Distance(nodes[i], nodes[i + 1]), 1, 1e-12);
  EXPECT_LE(Distance(nodes[0], nodes[1]), 1 + 1e-12);
}

TEST(CableChain, LaidInOnePlaceAndOnItself) {
  const CableChain there(std::vector<Point>{{1, 1}, {1, 1}}, {.length_m = 1});
  EXPECT_EQ(there.paid_out_m(), 0);
  CableChain back(std::vector<Point>{{0, 0}, {3, 0}, {0, 0}}, {.length_m = 6});
  EXPECT_TRUE(back.Pull({0, 1}));
  for (const Point node : back.nodes()) EXPECT_TRUE(IsFinite(node));
}

TEST(CableChainRandom, LinksKeepTheirLengthAndTheEquationsHold) {
  const auto walks = ScaledTestCount(300);
  int refused = 0, refused_early = 0, compared = 0;
  double off_links = 0;
  for (int seed = 1; seed <= walks; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const double length = rng.Uniform(3, 12), link = rng.Uniform(0.3, 1.2);
    CableChain chain(std::vector<Point>{{0, 0}}, {.length_m = length, .link_length_m = link});
    Point robot{0, 0};
    double heading = 0;
    for (int step = 0; step < 400; ++step) {
      heading += rng.Uniform(-0.5, 0.5);
      const Point to = robot + 0.1 * Point{std::cos(heading), std::sin(heading)};
      std::vector<Point> literal(chain.nodes().begin(), chain.nodes().end());
      const double paid = chain.paid_out_m();
      const double first = paid - link * static_cast<double>(literal.size() - 2);
      const bool moved = chain.Pull(to);
      if (!moved) {
        refused += 1;
        refused_early += Norm(to) < 0.95 * length ? 1 : 0;
        heading += 2;
        continue;
      }
      robot = to;
      const auto nodes = chain.nodes();
      ASSERT_EQ(nodes.front(), (Point{0, 0}));
      ASSERT_EQ(nodes.back(), to);
      ASSERT_GE(chain.paid_out_m(), paid);
      ASSERT_LE(chain.paid_out_m(), length * (1 + 1e-12));
      for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        ASSERT_NEAR(Distance(nodes[i], nodes[i + 1]), link, i + 2 < nodes.size() ? 1e-9 : link);
      ASSERT_LE(Distance(nodes[nodes.size() - 2], nodes.back()), 1.051 * link);
      ASSERT_LE(Distance(nodes[0], nodes[1]), link * 1.011);
      // With an empty reel and a taut first link the literal passes come to the same place.
      if (paid < length * (1 - 1e-12) || Distance(nodes[0], nodes[1]) < first * (1 - 1e-3)) continue;
      if (Norm(literal[1]) < first * (1 - 1e-6) || literal.size() < 3) continue;
      PullLiterally(literal, to, link, first, 200);
      for (std::size_t i = 0; i < nodes.size(); ++i, ++compared) off_links += Distance(nodes[i], literal[i]) / link;
    }
  }
  // Both meet the lengths of all links; longer pulls come to it in fewer rounds by a slightly other way.
  EXPECT_GT(compared, 100 * walks);
  EXPECT_LT(off_links / compared, 0.01);
  EXPECT_GT(refused, walks / 20);
  // Where the chain is not all but straight, folded rods are stuck: fewer than one in 400 steps.
  EXPECT_LE(refused_early, 1 + walks);
}

}  // namespace
}  // namespace tautline
