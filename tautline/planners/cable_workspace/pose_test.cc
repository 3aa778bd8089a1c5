#include "tautline/planners/cable_workspace/pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/cable_workspace/random_cables.h"

namespace tautline {
namespace {

class PoseRandom : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Families, PoseRandom, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Lattice" : "Separated"; });

std::vector<Point> CornersTowards(const Pose& pose) {
  std::vector<Point> towards;
  for (const PoseCable& cable : pose.cables) {
    if (cable.direction) towards.push_back(cable.path.points[cable.path.points.size() - 2]);
  }
  return towards;
}

/// Whether no closed half plane holds all directions: each may be the first of them, counter-clockwise.
bool SpanByHalfPlanes(Point robot, std::span<const Point> towards) {
  return !towards.empty() && std::none_of(towards.begin(), towards.end(), [&](Point first) {
    return std::all_of(towards.begin(), towards.end(),
                       [&](Point other) { return Orientation(robot, first, other) >= 0; });
  });
}

/// The margin by trying directions.
double MarginByDirections(const Pose& pose) {
  double margin = 1;
  for (int k = 0; k < 3600; ++k) {
    const double angle = k * std::numbers::pi / 1800;
    double best = -1;
    for (const PoseCable& cable : pose.cables) {
      if (cable.direction) best = std::max(best, Dot(*cable.direction, {std::cos(angle), std::sin(angle)}));
    }
    margin = std::min(margin, best);
  }
  return margin;
}

TEST_P(PoseRandom, SpansInsideAndByHalfPlanesAnywhere) {
  std::int64_t inside = 0, on_sides = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto [cables, boundary] = MakeRandomCableWorkspace(rng, GetParam());
    const WorkspaceRegion region(cables.ground, cables.anchors, boundary);
    for (int k = 0; k < 20; ++k) {
      const std::size_t corner = rng.Next() % boundary.ring.size();
      const Point a = boundary.ring[corner], b = boundary.ring[(corner + 1) % boundary.ring.size()];
      const bool on_side = k >= 15;
      const Point at = on_side ? Lerp(a, b, rng.Uniform(0.1, 0.9)) : RandomPoint(rng, BoundingBox(boundary.ring));
      const Pose pose = LookAtPose(region, at);
      EXPECT_EQ(pose.position, region.Classify(at));
      if (pose.position == Containment::kOutside) continue;
      ASSERT_EQ(pose.cables.size(), cables.anchors.size());
      const Point robot = pose.cables[0].path.points.back();
      EXPECT_EQ(pose.spans, SpanByHalfPlanes(robot, CornersTowards(pose))) << testing::PrintToString(at);
      EXPECT_NEAR(pose.margin, MarginByDirections(pose), 1e-3);
      if (pose.position == Containment::kInside) {
        ++inside;
        EXPECT_TRUE(pose.spans) << testing::PrintToString(at);
        EXPECT_LT(pose.largest_gap, std::numbers::pi + 1e-9);
      } else if (on_side) {
        ++on_sides;
        EXPECT_GE(pose.largest_gap, std::numbers::pi - 1e-6) << testing::PrintToString(at);
      }
    }
  }
  EXPECT_GT(inside, ScaledTestCount(300));
  EXPECT_GT(on_sides, ScaledTestCount(300));
}

/// A room of 4 m x 4 m with anchors in the corners.
struct Room {
  explicit Room(std::vector<Point> points)
      : ground(CableGround::Prepare(
                   World{.outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, .obstacles = {}, .map = {}, .cells = {}})
                   .value()),
        anchors(PlaceAnchors(ground, points).value()),
        boundary(BoundaryOfWords(ground, anchors, std::vector<Word>(points.size())).value()),
        region(ground, anchors, boundary) {}

  CableGround ground;
  Anchors anchors;
  WorkspaceBoundary boundary;
  WorkspaceRegion region;
};

TEST(Pose, IsExactOnTheLineBetweenTwoAnchors) {
  const Room room({{0, 0}, {4, 1}, {0, 4}});
  const Pose on_line = LookAtPose(room.region, {1, 0.25});
  EXPECT_EQ(on_line.position, Containment::kBoundary);
  EXPECT_FALSE(on_line.spans);
  EXPECT_NEAR(on_line.largest_gap, std::numbers::pi, 1e-12);
  EXPECT_NEAR(on_line.margin, 0, 1e-12);
  EXPECT_FALSE(on_line.touches_obstacle);
  const Pose above = LookAtPose(room.region, {1, 0.25 + 2e-6});
  EXPECT_EQ(above.position, Containment::kInside);
  EXPECT_TRUE(above.spans);
  EXPECT_LT(above.margin, 1e-5);
  EXPECT_EQ(LookAtPose(room.region, {1, 0.25 - 2e-6}).position, Containment::kOutside);
}

TEST(Pose, OfARobotInTheMiddle) {
  const Room room({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Pose pose = LookAtPose(room.region, {2, 2});
  EXPECT_TRUE(pose.spans);
  EXPECT_NEAR(pose.largest_gap, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(pose.margin, std::sqrt(0.5), 1e-12);
  EXPECT_FALSE(pose.touches_obstacle);
  for (const PoseCable& cable : pose.cables) EXPECT_NEAR(cable.length, std::sqrt(8), 1e-12);
}

TEST(Pose, OfARobotAtAnAnchorHasOneCableThatDoesNotPull) {
  const Room room({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  const Pose pose = LookAtPose(room.region, {4, 4});
  EXPECT_EQ(pose.position, Containment::kBoundary);
  EXPECT_TRUE(pose.touches_obstacle);
  EXPECT_FALSE(pose.spans);
  ASSERT_EQ(pose.cables.size(), 4U);
  EXPECT_EQ(pose.cables[2].length, 0);
  EXPECT_FALSE(pose.cables[2].direction);
  EXPECT_TRUE(pose.cables[0].direction);
  EXPECT_NEAR(pose.largest_gap, 1.5 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace tautline
