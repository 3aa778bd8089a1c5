#include "apps/cli/goals_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tautline::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string ErrorOf(const std::string& text) {
  const auto goals = ParseGoals(text, "goals.txt");
  return goals ? "none" : ToString(goals.error());
}

TEST(ParseGoals, ReadsBlanksAndCommasAndSkipsComments) {
  const auto goals = ParseGoals("# all\n1 2\n\n  -3.5,4e-1\t\n5 , 6 # the last\r\n \t#\n.5 7", "goals.txt");
  ASSERT_TRUE(goals);
  EXPECT_EQ(*goals, (std::vector<Point>{{1, 2}, {-3.5, 0.4}, {5, 6}, {0.5, 7}}));
}

TEST(ParseGoals, RefusesWhatIsNoPointWithItsLine) {
  for (const std::string bad : {"1", "1 2 3", "1,2,3", "1,,2", ",1", "1,", ",", "1;2", "x 2", "1 nan", "inf 2", "0x1 2",
                                "1 2x", "1 2, 3", "[1, 2]", "1 2 //"}) {
    const std::string error = ErrorOf("0 0\n\n" + bad + "\n9 9\n");
    EXPECT_THAT(error, StartsWith("goals.txt:3: ")) << bad;
    EXPECT_THAT(error, HasSubstr("is not a goal")) << bad;
  }
}

TEST(ParseGoals, RefusesCoordinatesBeyondTheLimit) {
  EXPECT_THAT(ErrorOf("1 2\n1e8 0\n"), HasSubstr("goals.txt:2: '1e8 0' is 1e+08: coordinates go up to 1e7"));
  EXPECT_THAT(ErrorOf("0,1e400\n"), HasSubstr("goals.txt:1: '0,1e400' is infinite"));
}

TEST(ParseGoals, RefusesAFileWithoutGoals) {
  for (const char* none : {"", "\n\n", "# 1 2\n"}) EXPECT_THAT(ErrorOf(none), HasSubstr("goals.txt: no goal")) << none;
}

TEST(ParseGoals, ShowsLongAndStrangeLinesInOneShortLine) {
  const std::string error = ErrorOf("a\tb\v" + std::string(100'000, 'x'));
  EXPECT_LT(error.size(), 200u);
  EXPECT_EQ(error.find('\v'), std::string::npos);
}

TEST(ReadGoals, NamesAFileThatIsMissing) {
  EXPECT_THAT(ToString(ReadGoals("no/such/file").error()), HasSubstr("no/such/file: no such file"));
}

}  // namespace
}  // namespace tautline::cli
