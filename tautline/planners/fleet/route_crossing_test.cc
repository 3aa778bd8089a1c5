#include "tautline/planners/fleet/route_crossing.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/predicates.h"
#include "tautline/planners/fleet/random_fleet.h"

namespace tautline {
namespace {

bool Meet(Point a, Point b, Point c, Point d) {
  return CrossProperly(a, b, c, d) || OnSegment(a, b, c) || OnSegment(a, b, d) || OnSegment(c, d, a) ||
         OnSegment(c, d, b);
}

bool Meet(const Polyline& a, const Polyline& b) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.size(); ++j) {
      if (Meet(a[i], a[i + 1], b[j], b[j + 1])) return true;
    }
  }
  return false;
}

/// Whether two lines cross however their bends are moved off their nodes, each outwards by one of two small distances,
/// and to either side where a line passes a node straight. It knows nothing of sectors or shared parts.
class OffsetOracle {
 public:
  OffsetOracle(Polyline a, Polyline b, double offset) : lines_{std::move(a), std::move(b)}, offset_(offset) {}

  bool Cross() {
    moved_ = lines_;
    for (std::size_t line : {0, 1}) {
      for (std::size_t k = 1; k + 1 < lines_[line].size(); ++k) bends_.push_back({line, k});
    }
    return !AnyApart(0);
  }

 private:
  struct Bend {
    std::size_t line, step;
  };

  bool Passes(std::size_t line, Point p) const {
    return std::find(lines_[line].begin(), lines_[line].end(), p) != lines_[line].end();
  }

  static Point Unit(Point v) { return (1 / Norm(v)) * v; }

  bool AnyApart(std::size_t next) {
    if (next == bends_.size()) return !Meet(moved_[0], moved_[1]);
    const auto [line, step] = bends_[next];
    const Polyline& points = lines_[line];
    const Point at = points[step], back = Unit(points[step - 1] - at), forth = Unit(points[step + 1] - at);
    const bool straight = Orientation(points[step - 1], at, points[step + 1]) == 0;
    const Point outwards = straight ? Point{-forth.y, forth.x} : Unit(Point{} - back - forth);
    for (const double rank : {1.0, 2.0, -1.0, -2.0}) {
      if (rank < 0 && !straight) continue;
      // Where the other line does not come, nothing depends on it.
      if (rank != 1 && !Passes(1 - line, at)) continue;
      moved_[line][step] = at + rank * offset_ * outwards;
      if (AnyApart(next + 1)) return true;
    }
    return false;
  }

  std::array<Polyline, 2> lines_, moved_;
  std::vector<Bend> bends_;
  double offset_;
};

FleetGround Prepared(const Scene& scene) {
  auto ground = FleetGround::Prepare(scene);
  EXPECT_TRUE(ground) << ground.error().message;
  return *std::move(ground);
}

/// Whether all angles and distances are large enough for the offset of the oracle.
bool IsWide(const Scene& scene, double least) {
  Polyline points;
  for (const FleetRobot& robot : scene.fleet->robots) points.insert(points.end(), {robot.start, robot.target});
  for (const Point a : points) {
    for (const Point b : points) {
      if (a == b) continue;
      for (const Point p : points) {
        if (p != a && p != b && std::fabs(Cross(b - a, p - a)) < least * Distance(a, b)) return false;
      }
    }
  }
  return true;
}

struct Tally {
  std::int64_t pairs = 0, apart = 0;
  std::map<CrossingKind, std::int64_t> kinds;
};

/// Compares one random pair; returns false when its routes could not be.
bool ComparePair(const Scene& scene, const FleetGround& ground, Rng& rng, double offset, Tally& tally) {
  const auto a = RandomRoute(rng, ground, RobotId(std::size_t{0}), 3);
  const auto b = RandomRoute(rng, ground, RobotId(std::size_t{1}), 3);
  if (!a || !b) return false;
  const Polyline line_a = PointsOf(ground, *a), line_b = PointsOf(ground, *b);
  const auto found = RouteCrossings(ground, *a, *b);
  const bool cross = OffsetOracle(line_a, line_b, offset).Cross();
  EXPECT_EQ(!found.empty(), cross) << testing::PrintToString(line_a.size());
  if (found.empty() == cross) {
    for (const FleetRobot& robot : scene.fleet->robots) {
      ADD_FAILURE() << robot.name << " " << robot.start.x << "," << robot.start.y << " " << robot.target.x << ","
                    << robot.target.y;
    }
    for (const Point p : line_a) ADD_FAILURE() << "a " << p.x << "," << p.y;
    for (const Point p : line_b) ADD_FAILURE() << "b " << p.x << "," << p.y;
    for (const auto& crossing : found) ADD_FAILURE() << ToString(crossing.kind);
  }
  EXPECT_EQ(found.size(), RouteCrossings(ground, *b, *a).size());
  EXPECT_EQ(RoutesCross(ground, *a, *b), !found.empty());
  ++tally.pairs;
  if (found.empty()) ++tally.apart;
  for (const RouteCrossing& crossing : found) ++tally.kinds[crossing.kind];
  return true;
}

TEST(RouteCrossings, AgreeWithOffsetLinesOnALattice) {
  constexpr std::uint64_t kSeed = 1;
  Rng rng(kSeed);
  SCOPED_TRACE(kSeed);
  const std::int64_t count = ScaledTestCount(100'000);
  Tally tally;
  while (tally.pairs < count && !HasFailure()) {
    const Scene scene = RandomFleet(rng, 4, 3, true);
    const FleetGround ground = Prepared(scene);
    for (int k = 0; k < 8; ++k) ComparePair(scene, ground, rng, 1e-3, tally);
  }
  EXPECT_GT(tally.apart, count / 20);
  for (const CrossingKind kind :
       {CrossingKind::kInterior, CrossingKind::kEndOutsideBend, CrossingKind::kEndOfShared, CrossingKind::kThroughNode,
        CrossingKind::kBendAgainstBend, CrossingKind::kSharedPart}) {
    EXPECT_GT(tally.kinds[kind], count / 1000) << ToString(kind);
    RecordProperty(ToString(kind), std::to_string(tally.kinds[kind]));
  }
}

TEST(RouteCrossings, AgreeWithOffsetLinesAnywhere) {
  constexpr std::uint64_t kSeed = 2;
  Rng rng(kSeed);
  SCOPED_TRACE(kSeed);
  const std::int64_t count = ScaledTestCount(50'000);
  Tally tally;
  while (tally.pairs < count && !HasFailure()) {
    const Scene scene = RandomFleet(rng, 4, 10, false);
    if (!IsWide(scene, 0.02)) continue;
    const FleetGround ground = Prepared(scene);
    for (int k = 0; k < 8; ++k) ComparePair(scene, ground, rng, 1e-5, tally);
  }
  EXPECT_GT(tally.apart, count / 20);
  EXPECT_GT(tally.kinds[CrossingKind::kEndOfShared], count / 1000);
  EXPECT_GT(tally.kinds[CrossingKind::kSharedPart], count / 1000);
  EXPECT_GT(tally.kinds[CrossingKind::kBendAgainstBend], count / 1000);
}

}  // namespace
}  // namespace tautline
