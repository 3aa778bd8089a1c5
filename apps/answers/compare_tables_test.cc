#include "apps/answers/compare_tables.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tautline {
namespace {

ComparedPath PathOf(const std::string& group, const std::string& method, double length_m, int contacts, bool success) {
  return {.scene = group + "_1",
          .group = group,
          .method = method,
          .seed = 1,
          .kernels = "portable",
          .cable_robot = -0.5,
          .found = success,
          .success = success,
          .length_m = length_m,
          .time_s = 60,
          .cable_obstacle = contacts,
          .path = {}};
}

TEST(CompareTables, AverageOverWhatReachedTheGoal) {
  const std::vector<ComparedPath> paths = {
      PathOf("dots", "learned", 8, 2, true), PathOf("dots", "learned", 10, 4, true),
      PathOf("dots", "learned", 99, 9, false), PathOf("dots", "dijkstra", 7, 0, true)};
  const auto cells = CellsOf(paths);
  ASSERT_EQ(cells.size(), 2);
  EXPECT_EQ(cells[0].count, 3);
  EXPECT_EQ(cells[0].success, 2);
  EXPECT_DOUBLE_EQ(cells[0].length_m.mean, 9);
  EXPECT_DOUBLE_EQ(cells[0].length_m.spread, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(cells[0].cable_obstacle.mean, 3);
  const std::string text = CompareMarkdown(cells, -0.5);
  // The paper's numbers stand beside ours.
  EXPECT_NE(text.find("| dots | learned | 2/3 | 9.00 ± 1.41 | 3.00 ± 1.41 | 0.00 ± 0.00 | 8.92 | 1.20 | 0.00 |"),
            std::string::npos)
      << text;
  EXPECT_EQ(text.find("### Without"), std::string::npos);
}

TEST(CompareTables, OtherWaysOfTrainingHaveTablesOfTheirOwn) {
  ComparedPath harsh = PathOf("dots_deployed", "learned", 8, 2, true), blind = harsh;
  harsh.cable_robot = -1;
  blind.reference = false;
  const auto cells = CellsOf(std::vector<ComparedPath>{PathOf("dots_deployed", "learned", 9, 1, true), harsh, blind});
  ASSERT_EQ(cells.size(), 3);
  const std::string text = CompareMarkdown(cells, -0.5);
  EXPECT_NE(text.find("### The reward for standing on the cable"), std::string::npos);
  EXPECT_NE(text.find("| dots_deployed | -1.00 | 1/1 |"), std::string::npos) << text;
  EXPECT_NE(text.find("| dots_deployed | without | 1/1 |"), std::string::npos) << text;
}

TEST(GroupOf, IsTheNameWithoutItsNumber) {
  EXPECT_EQ(GroupOf("dots_3"), "dots");
  EXPECT_EQ(GroupOf("dots_12_deployed"), "dots_deployed");
  EXPECT_EQ(GroupOf("two_bars_1"), "two_bars");
  EXPECT_EQ(GroupOf("room"), "room");
  EXPECT_EQ(GroupOf("room7"), "room7");
  EXPECT_EQ(GroupOf("7"), "7");
}

}  // namespace
}  // namespace tautline
