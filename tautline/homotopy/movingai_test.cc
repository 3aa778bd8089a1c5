// The shortest taut path against the published optimal path lengths of the MovingAI benchmarks.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "tautline/base/test_scale.h"
#include "tautline/homotopy/classes.h"
#include "tautline/scene/map_world.h"
#include "tautline/scene/movingai_map.h"
#include "tautline/scene/movingai_scen.h"
#include "tautline/scene/text_file.h"

namespace tautline {
namespace {

constexpr std::size_t kMaxBytes = 10'000'000;
const std::string kFolder = "scenes/maps/movingai/";

struct Files {
  const char* name;
  const char* map;
  const char* scen;

  friend void PrintTo(const Files& files, std::ostream* out) { *out << files.map; }
};

class MovingAi : public testing::TestWithParam<Files> {};

INSTANTIATE_TEST_SUITE_P(Maps, MovingAi,
                         testing::Values(Files{"Arena", "arena.map", "arena.map.scen"},
                                         Files{"Den312d", "den312d.map", "den312d.map.scen"},
                                         Files{"Lak104d", "lak104d.map", "lak104d.map.scen"},
                                         Files{"Empty16", "empty-16-16.map", "empty-16-16-random-1.scen"},
                                         Files{"Maze32", "maze-32-32-2.map", "maze-32-32-2-random-1.scen"},
                                         Files{"Random32", "random-32-32-10.map", "random-32-32-10-random-1.scen"},
                                         Files{"Room64", "room-64-64-16.map", "room-64-64-16-random-1.scen"}),
                         [](const auto& suite) { return std::string(suite.param.name); });

TautSpace SpaceOfMap(const std::string& file) {
  MapWorld map = WorldFromGrid(ParseMovingAiMap(ReadTextFile(file, kMaxBytes).value(), file).value(), {}).value();
  World world;
  world.outline = std::move(map.outline);
  world.obstacles = std::move(map.obstacles);
  return TautSpace(BuildFreeSpace(world).value());
}

TEST_P(MovingAi, AnyAngleIsNoLongerThanOctileAndNoShorterThanStraight) {
  const TautSpace space = SpaceOfMap(kFolder + GetParam().map);
  const std::string file = kFolder + GetParam().scen;
  const auto problems = ParseMovingAiScen(ReadTextFile(file, kMaxBytes).value(), file).value();
  const auto step = std::max<std::size_t>(1, problems.size() / static_cast<std::size_t>(ScaledTestCount(500)));
  for (std::size_t i = 0; i < problems.size(); i += step) {
    const ScenProblem& problem = problems[i];
    SCOPED_TRACE(file + ":" + std::to_string(i + 2));
    const Point start = CellCentre(problem.start, problem.height), goal = CellCentre(problem.goal, problem.height);
    const ClassList list = FindClasses(space, start, goal, {.max_length = {}, .max_count = 1});
    ASSERT_EQ(list.classes.size(), 1U);
    // The files give six significant digits.
    EXPECT_LE(list.classes[0].length, problem.octile_length * (1 + 5e-6) + 1e-6);
    EXPECT_GE(list.classes[0].length, Distance(start, goal) * (1 - 1e-12));
  }
}

}  // namespace
}  // namespace tautline
