#include "tautline/scene/check_fleet.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace tautline {
namespace {

/// What is wrong with two robots after a change; "" where nothing is.
std::string FaultOf(const std::function<void(FleetRobot&, FleetRobot&)>& change) {
  Fleet fleet;
  fleet.robots = {{.name = "a", .start = {0, 0}, .target = {4, 0}, .cable = Polyline{{0, 0}, {4, 0}}, .speed = 1},
                  {.name = "b", .start = {0, 2}, .target = {4, 2}, .cable = std::nullopt, .speed = 1}};
  change(fleet.robots[0], fleet.robots[1]);
  const auto checked = CheckFleet(fleet);
  return checked ? "" : checked.error().message;
}

using Robot = FleetRobot&;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

TEST(CheckFleet, AcceptsWhatReadersAccept) {
  EXPECT_EQ(FaultOf([](Robot, Robot) {}), "");
  EXPECT_EQ(FaultOf([](Robot a, Robot b) { a.radius = 2, b.tether = 0; }), "");
}

TEST(CheckFleet, NamesWhatIsWrong) {
  const auto expect = [](const std::string& part, const std::function<void(Robot, Robot)>& change) {
    EXPECT_NE(FaultOf(change).find(part), std::string::npos) << part << " / " << FaultOf(change);
  };
  expect("fleet.robots[2] has no name", [](Robot, Robot b) { b.name = ""; });
  expect("two robots are named 'a'", [](Robot, Robot b) { b.name = "a"; });
  expect("fleet.robots[1].start", [](Robot a, Robot) { a.start.x = kNan; });
  expect("fleet.robots[2].target", [](Robot, Robot b) { b.target.y = kInfinite; });
  expect("fleet.robots[2].target", [](Robot, Robot b) { b.target.y = 1e9; });
  expect("fleet.robots[2].speed", [](Robot, Robot b) { b.speed = 0; });
  expect("fleet.robots[2].speed", [](Robot, Robot b) { b.speed = kNan; });
  expect("fleet.robots[1].radius", [](Robot a, Robot) { a.radius = -1; });
  expect("fleet.robots[1].tether", [](Robot a, Robot) { a.tether = kInfinite; });
  expect("fleet.robots[1].cable has 1 points", [](Robot a, Robot) { a.cable->pop_back(); });
  expect("fleet.robots[1].cable", [](Robot a, Robot) { a.cable->at(1).x = kNan; });
  expect("must begin at the start, at (0, 0)", [](Robot a, Robot) { a.cable->front().y = 1; });
  expect("must end at the target, at (4, 0)", [](Robot a, Robot) { a.cable->back().y = 1; });
  expect("the target of b is where the start of a is", [](Robot, Robot b) { b.target = {0, 0}; });
  expect("the target of b is where the start of b is", [](Robot, Robot b) { b.target = {0, 2}; });
}

TEST(CheckFleet, WantsARobot) {
  EXPECT_EQ(CheckFleet({}).error().message, "fleet.robots is empty: list a robot");
  EXPECT_NE(RequireFleet({}).error().message.find("the scene has no fleet; add"), std::string::npos);
}

}  // namespace
}  // namespace tautline
