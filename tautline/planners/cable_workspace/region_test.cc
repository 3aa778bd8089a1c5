#include "tautline/planners/cable_workspace/region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/sketched_scene.h"
#include "tautline/planners/cable_workspace/random_cables.h"

namespace tautline {
namespace {

/// How often the corners that cables pull towards wind around a robot. Each angle between neighbours is less than a
/// half turn in the cover, so that this is how often the boundary winds around the robot there, whatever the plane
/// says.
int WindingOfPulls(std::span<const TautPath> cables, Point robot) {
  Ring towards;
  for (const TautPath& cable : cables) {
    if (cable.points.size() < 2) return 0;
    towards.push_back(cable.points[cable.points.size() - 2]);
  }
  const Winding winding = WindingNumber(towards, robot);
  return winding.on_boundary ? 0 : winding.number;
}

class RegionRandom : public testing::TestWithParam<bool> {
 protected:
  /// Calls visit(rng, workspace, region).
  template <class Visit>
  void ForEachRegion(std::int64_t count, Visit visit) {
    for (std::int64_t seed = 0; seed < ScaledTestCount(count); ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Rng rng(static_cast<std::uint64_t>(seed));
      const RandomCableWorkspace workspace = MakeRandomCableWorkspace(rng, GetParam());
      const WorkspaceRegion region(workspace.cables.ground, workspace.cables.anchors, workspace.boundary);
      visit(rng, workspace, region);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Families, RegionRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

Point SomePoint(Rng& rng, const WorkspaceBoundary& boundary) {
  const auto corner = [&] {
    return boundary.ring[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(boundary.ring.size()) - 1))];
  };
  switch (rng.UniformInt(0, 3)) {
    case 0:
      return corner();
    case 1:  // Near a corner, where it is the nearest of the boundary.
      return corner() + Point{rng.Uniform(-0.1, 0.1), rng.Uniform(-0.1, 0.1)};
    default:
      return RandomPoint(rng, BoundingBox(boundary.ring));
  }
}

TEST_P(RegionRandom, ClassifiesByTheWindingNumber) {
  ForEachRegion(300, [](Rng& rng, const RandomCableWorkspace& workspace, const WorkspaceRegion& region) {
    const Ring& ring = workspace.boundary.ring;
    for (int k = 0; k < 50; ++k) {
      const Point p = SomePoint(rng, workspace.boundary);
      double away = 1e300;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        away = std::min(away, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
      }
      if (away > region.ground().space().tolerance()) {
        EXPECT_EQ(region.Classify(p),
                  WindingNumber(ring, p).number != 0 ? Containment::kInside : Containment::kOutside);
      } else if (away == 0) {
        EXPECT_EQ(region.Classify(p), Containment::kBoundary);
      }
    }
  });
}

std::vector<TautPath> CablesTo(const WorkspaceRegion& region, const Walk& way) {
  std::vector<TautPath> cables;
  for (std::size_t i = 0; i < region.anchors().size(); ++i) {
    cables.push_back(region.ground().space().Pull(region.CableTo(i, way)));
  }
  return cables;
}

// A cable in another class would have to leave the workspace, and its pulls would not go around the robot.
TEST_P(RegionRandom, KeepsCablesInTheWorkspace) {
  std::int64_t inside = 0;
  ForEachRegion(300, [&inside](Rng& rng, const RandomCableWorkspace& workspace, const WorkspaceRegion& region) {
    for (int k = 0; k < 30; ++k) {
      const Point p = SomePoint(rng, workspace.boundary);
      const auto ways = region.WaysTo(p);
      const Containment position = region.Classify(p);
      EXPECT_EQ(ways.empty(), position == Containment::kOutside) << testing::PrintToString(p);
      if (position == Containment::kInside) {
        EXPECT_EQ(ways.size(), 1U) << testing::PrintToString(p);
        ++inside;
      }
      for (const Walk& way : ways) {
        const auto cables = CablesTo(region, way);
        if (position == Containment::kInside) {
          EXPECT_EQ(std::abs(WindingOfPulls(cables, p)), 1) << testing::PrintToString(p);
        }
        for (const TautPath& cable : cables) {
          for (std::size_t i = 0; i + 1 < cable.points.size(); ++i) {
            for (const double share : {0.0, 0.3, 0.7, 1.0}) {
              const Point on_cable = Lerp(cable.points[i], cable.points[i + 1], share);
              EXPECT_NE(region.Classify(on_cable), Containment::kOutside)
                  << testing::PrintToString(p) << " " << testing::PrintToString(on_cable);
            }
          }
        }
      }
    }
  });
  EXPECT_GT(inside, ScaledTestCount(300) * 5);
}

// The robot as the cables are laid is in the workspace when their pulls go around it; then these are its cables.
TEST_P(RegionRandom, HasTheLaidCables) {
  std::int64_t inside = 0;
  ForEachRegion(2000, [&inside](Rng&, const RandomCableWorkspace& workspace, const WorkspaceRegion& region) {
    const RandomCables& cables = workspace.cables;
    std::vector<TautPath> laid;
    const auto walks = FollowCables(cables.ground, cables.anchors, cables.laid).value();
    for (const Walk& walk : walks) {
      laid.push_back(cables.ground.space().Pull(walk));
    }
    const auto place = cables.ground.space().Locate(cables.robot);
    if (region.Classify(cables.robot) == Containment::kBoundary) return;
    if (cables.ground.space().mesh().MoveOntoBoundary(cables.robot, 1e-9)) return;
    const bool goes_around = WindingOfPulls(laid, place->point) != 0;
    const auto ways = region.WaysTo(cables.robot);
    bool same = !ways.empty();
    if (same) {
      const auto found = CablesTo(region, ways[0]);
      for (std::size_t i = 0; i < laid.size(); ++i) same = same && found[i].points == laid[i].points;
    }
    EXPECT_EQ(same, goes_around);
    inside += same ? 1 : 0;
  });
  EXPECT_GT(inside, ScaledTestCount(2000) / 10);
}

TEST_P(RegionRandom, NeedsNoLongerCableThanBetweenAnchors) {
  ForEachRegion(200, [](Rng& rng, const RandomCableWorkspace& workspace, const WorkspaceRegion& region) {
    const auto& [cables, boundary] = workspace;
    const auto longest = LongestCables(cables.ground, cables.anchors, boundary);
    for (int k = 0; k < 50; ++k) {
      const Point p = k < 40 ? SomePoint(rng, boundary) : cables.anchors[rng.Next() % cables.anchors.size()].exit.point;
      for (const Walk& way : region.WaysTo(p)) {
        const auto taut = CablesTo(region, way);
        for (std::size_t i = 0; i < taut.size(); ++i) {
          EXPECT_LE(taut[i].length, longest[i].length + 1e-9) << testing::PrintToString(p);
        }
      }
    }
    for (std::size_t i = 0; i < longest.size(); ++i) {
      double attained = 0;
      for (const Walk& way : region.WaysTo(cables.anchors[longest[i].farthest].exit.point)) {
        attained = std::max(attained, CablesTo(region, way)[i].length);
      }
      EXPECT_NEAR(attained, longest[i].length, 1e-9) << "anchor " << i;
    }
  });
}

}  // namespace
}  // namespace tautline
