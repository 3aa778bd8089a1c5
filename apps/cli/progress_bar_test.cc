#include "apps/cli/progress_bar.h"

#include <gtest/gtest.h>

namespace tautline::cli {
namespace {

TEST(ProgressText, ForetellsTheRestFromWhatIsDone) {
  EXPECT_EQ(ProgressText("goals", 0.25, 10), "goals  25 %, 30 s left");
  EXPECT_EQ(ProgressText("goals", 0.999, 99.9), "goals  99 %, 1 s left");
  EXPECT_EQ(ProgressText("goals", 1, 100), "goals 100 %, 0 s left");
  EXPECT_EQ(ProgressText("goals", 0.5, 600), "goals  50 %, 10 min left");
  EXPECT_EQ(ProgressText("goals", 0.5, 36'000), "goals  50 %, 10 h left");
}

TEST(ProgressText, ForetellsNothingBeforeTheFirstHundredth) {
  EXPECT_EQ(ProgressText("goals", 0, 3), "goals   0 %");
  EXPECT_EQ(ProgressText("goals", 0.009, 3), "goals   0 %");
}

TEST(ProgressText, TellsTheTimeWhereTheShareIsUnknown) {
  EXPECT_EQ(ProgressText("search", std::nullopt, 12.3), "search, for 13 s");
}

TEST(ProgressBar, HasNoWatcherWhenNobodyLooks) {
  ProgressBar bar(false);
  EXPECT_FALSE(bar.watcher());
  EXPECT_FALSE(bar.Passing("search"));
  bar.Tell("goals", 0.5);
  bar.Clear();
}

}  // namespace
}  // namespace tautline::cli
