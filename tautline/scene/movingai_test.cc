#include <gtest/gtest.h>

#include <cmath>
#include <queue>

#include "tautline/geometry/grid_sketch.h"
#include "tautline/scene/movingai_map.h"
#include "tautline/scene/movingai_scen.h"
#include "tautline/scene/text_file.h"

namespace tautline {
namespace {

std::string MapErrorOf(std::string_view text) {
  const auto grid = ParseMovingAiMap(text, "m.map");
  return grid ? "no error" : ToString(grid.error());
}

std::string ScenErrorOf(std::string_view text) {
  const auto problems = ParseMovingAiScen(text, "m.scen");
  return problems ? "no error" : ToString(problems.error());
}

TEST(ParseMovingAiMap, TheFirstRowIsTheHighest) {
  const auto grid = ParseMovingAiMap("type octile\nheight 2\nwidth 3\nmap\n.GS\n@TW\n", "m.map");
  ASSERT_TRUE(grid) << ToString(grid.error());
  EXPECT_EQ(*grid, GridFromSketch({"...",  //
                                   "###"}));
}

TEST(ParseMovingAiMap, AcceptsWindowsLineEndsAndBlankLinesAtTheEnd) {
  const auto grid = ParseMovingAiMap("type octile\r\nheight 1\r\nwidth 2\r\nmap\r\n.O\r\n\r\n", "m.map");
  ASSERT_TRUE(grid) << ToString(grid.error());
  EXPECT_EQ(*grid, GridFromSketch({".#"}));
}

TEST(ParseMovingAiMap, NamesTheLineOfAFault) {
  const std::string header = "type octile\nheight 2\nwidth 3\nmap\n";
  EXPECT_EQ(MapErrorOf(header + "...\n..\n....."), "m.map:6: the row has 2 cells, but the header says 3");
  EXPECT_EQ(MapErrorOf(header + "....\n...\n"), "m.map:5: the row has 4 cells, but the header says 3");
  EXPECT_EQ(MapErrorOf(header + "...\n"), "m.map:5: the map has 1 rows, but the header says 2");
  EXPECT_EQ(MapErrorOf(header + "...\n...\n...\n"), "m.map:7: the map has more rows than the header says: 2");
  EXPECT_EQ(MapErrorOf("type octile\nheight two\n").substr(0, 28), "m.map:2: a MovingAI map star");
  EXPECT_EQ(MapErrorOf("hello").substr(0, 28), "m.map:1: a MovingAI map star");
  EXPECT_EQ(MapErrorOf("type octile\nheight 2\nmap\n...").substr(0, 28), "m.map:3: the header of the M");
  EXPECT_EQ(MapErrorOf(""), "m.map:1: the header of the MovingAI map has no height or no width");
}

TEST(ParseMovingAiMap, RefusesMapsThatAreTooLargeOrCutOff) {
  EXPECT_NE(MapErrorOf("type octile\nheight 100000\nwidth 100000\nmap\n").find("8192"), std::string::npos);
  EXPECT_NE(MapErrorOf("type octile\nheight 5000\nwidth 5000\nmap\n").find("cut off"), std::string::npos);
}

TEST(ParseMovingAiScen, ReadsBothSpellings) {
  const auto problems =
      ParseMovingAiScen("version 1.0\n40 maps/a.map 8 9 1 2 3 4 2.82843\n0\tb.map\t8\t9\t7\t8\t0\t0\t11\n", "m.scen");
  ASSERT_TRUE(problems) << ToString(problems.error());
  ASSERT_EQ(problems->size(), 2u);
  EXPECT_EQ((*problems)[0].map, "maps/a.map");
  EXPECT_EQ((*problems)[0].start, (ScenCell{1, 2}));
  EXPECT_EQ((*problems)[0].goal, (ScenCell{3, 4}));
  EXPECT_EQ((*problems)[0].octile_length, 2.82843);
  EXPECT_EQ(CellCentre((*problems)[0].start, 9), (Point{1.5, 6.5}));
}

TEST(ParseMovingAiScen, NamesTheLineOfAFault) {
  EXPECT_EQ(ScenErrorOf("1 2 3"), "m.scen:1: a scen file starts with 'version 1'");
  EXPECT_EQ(ScenErrorOf("version 1\n\n0 a 8 9 1 2 3").substr(0, 28), "m.scen:3: a problem needs ni");
  EXPECT_EQ(ScenErrorOf("version 1\n0 a 8 9 8 2 3 3 1").substr(0, 9), "m.scen:2:");
  for (const std::string length : {"nan", "inf", "-inf", "1e999", "-1"}) {
    EXPECT_EQ(ScenErrorOf("version 1\n0 a 8 9 1 2 3 3 1\n0 a 8 9 1 2 3 3 " + length).substr(0, 28),
              "m.scen:3: a problem needs ni")
        << length;
  }
}

/// The shortest path over 8 neighbours that cuts no corners, cells.
double OctileLength(const OccupancyGrid& grid, ScenCell from, ScenCell to) {
  const auto free = [&grid](int column, int row) {
    return grid.contains(column, row) && grid.at(column, row) == CellState::kFree;
  };
  const auto index = [&grid](ScenCell cell) { return grid.index(cell.column, grid.rows - 1 - cell.row); };
  std::vector<double> best(grid.cells.size(), 1e300);
  std::priority_queue<std::pair<double, std::size_t>> queue;
  best[index(from)] = 0;
  queue.push({0, index(from)});
  while (!queue.empty()) {
    const auto [negative, cell] = queue.top();
    queue.pop();
    if (-negative > best[cell]) continue;
    const int column = static_cast<int>(cell) % grid.columns, row = static_cast<int>(cell) / grid.columns;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (!free(column + dx, row + dy) || !free(column + dx, row) || !free(column, row + dy)) continue;
        const double length = best[cell] + std::sqrt(dx * dx + dy * dy);
        const std::size_t next = grid.index(column + dx, row + dy);
        if (length >= best[next]) continue;
        best[next] = length;
        queue.push({-length, next});
      }
    }
  }
  return best[index(to)];
}

TEST(MovingAi, MapsAndProblemsAgreeOnLengths) {
  const std::string folder = "scenes/maps/movingai/";
  for (const std::string name : {"arena.map", "lak104d.map", "den312d.map"}) {
    const auto map = ReadTextFile(folder + name, 1 << 20);
    const auto scen = ReadTextFile(folder + name + ".scen", 1 << 20);
    ASSERT_TRUE(map && scen) << name;
    const auto grid = ParseMovingAiMap(*map, name);
    const auto problems = ParseMovingAiScen(*scen, name);
    ASSERT_TRUE(grid && problems) << name;
    for (const ScenProblem& problem : *problems) {
      ASSERT_NEAR(OctileLength(*grid, problem.start, problem.goal), problem.octile_length, 1e-3) << name;
    }
  }
}

}  // namespace
}  // namespace tautline
