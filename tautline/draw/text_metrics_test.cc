#include "tautline/draw/text_metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tautline {
namespace {

using ::testing::ElementsAre;

TEST(TextMetrics, CountsCharactersNotBytes) {
  EXPECT_DOUBLE_EQ(TextWidth("ßß", 10), 2 * TextWidth("ß", 10));
  EXPECT_LT(TextWidth("il", 10), TextWidth("mw", 10));
  EXPECT_LT(TextWidth("abc", 10), TextWidth("abc", 10, true));
}

TEST(TextMetrics, EllipsizeCutsBetweenCharacters) {
  EXPECT_EQ(Ellipsize("pillar", 10, 1000), "pillar");
  const std::string cut = Ellipsize("ßßßßßßßßßß", 10, 40);
  EXPECT_LE(TextWidth(cut, 10), 40);
  EXPECT_EQ(cut, "ßßßß…");
}

TEST(TextMetrics, WrapsAtSpaces) {
  EXPECT_THAT(Wrap("one two three", {.size = 10, .width = 60}), ElementsAre("one two", "three"));
  EXPECT_THAT(Wrap("", {.size = 10, .width = 60}), ElementsAre());
}

TEST(TextMetrics, NumbersKeepTheirUnits) {
  EXPECT_THAT(Wrap("limit 18.00 m", {.size = 10, .width = 60}), ElementsAre("limit", "18.00 m"));
}

TEST(TextMetrics, TheLastLineIsShortened) {
  const std::vector<std::string> lines = Wrap("one two three four five", {.size = 10, .width = 45, .max_lines = 2});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_THAT(lines[1], ::testing::EndsWith("…"));
}

}  // namespace
}  // namespace tautline
