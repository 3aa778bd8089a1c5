#include "tautline/homotopy/funnel_tree.h"

#include <gtest/gtest.h>

#include <vector>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/homotopy/goal_field.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/homotopy/taut.h"

namespace tautline {
namespace {

class FunnelTreeRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, FunnelTreeRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

/// A class of the tree and the walk that it stands for.
struct Branch {
  FunnelTree::NodeId node;
  Walk walk;
};

/// Branches that hop from corner to corner in sight give what PullTaut gives for their walks.
TEST_P(FunnelTreeRandom, PullsAsPullTautDoes) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng, GetParam());
    const TautSpace space(scene.space);
    Walk start(space.Locate(RandomFreePoint(rng, scene)).value());
    FunnelTree tree(space.mesh(), start);
    std::vector<Branch> branches{{tree.trunk(), start}};
    for (int hop = 0; hop < 40; ++hop) {
      Branch branch = branches[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(branches.size()) - 1))];
      const auto legs = FirstLegsFrom(space, branch.walk);
      if (legs.empty()) continue;
      const auto pick = static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(legs.size()) - 1));
      const Point to = space.corners()[legs[pick].leg.corner].point;
      branch.node = tree.GoStraight(branch.node, branch.walk.at, branch.walk.is_free_to_turn(), to);
      ASSERT_FALSE(WalkStraight(space.mesh(), to, branch.walk));
      const TautCurve expected = PullTaut(space.mesh(), branch.walk);
      const FunnelTree::Tether found = tree.Pull(branch.node, to);
      ASSERT_NEAR(found.length, expected.length, 1e-12 * (1 + expected.length));
      const std::size_t n = expected.points.size();
      ASSERT_EQ(found.bend, expected.points[n >= 2 ? n - 2 : 0].point);
      branches.push_back(branch);
    }
  }
}

}  // namespace
}  // namespace tautline
