#include "apps/cli/in_order.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace tautline::cli {
namespace {

/// The squares of 0 to count - 1, computed in times that are all but in order.
std::vector<std::size_t> Squares(std::size_t count, int threads) {
  std::vector<std::size_t> taken;
  InOrder<std::size_t>::Run(
      {.count = count, .threads = threads},
      [](std::size_t item) {
        std::this_thread::sleep_for(std::chrono::microseconds((item * 7919) % 13 * 20));
        return item * item;
      },
      [&](std::size_t item, std::size_t square) {
        EXPECT_EQ(item, taken.size());
        taken.push_back(square);
        return true;
      });
  return taken;
}

TEST(InOrder, TakesAllResultsInOrderForAnyNumberOfThreads) {
  for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
    std::vector<std::size_t> want;
    for (std::size_t i = 0; i < count; ++i) want.push_back(i * i);
    for (const int threads : {1, 2, 3, 8, 2000}) EXPECT_EQ(Squares(count, threads), want) << count << ' ' << threads;
  }
}

TEST(InOrder, TakesEachResultBeforeTheLastIsComputed) {
  std::atomic<int> computed = 0;
  int computed_at_first = 0;
  InOrder<int>::Run(
      {.count = 10'000, .threads = 4}, [&](std::size_t) { return ++computed; },
      [&](std::size_t item, int) {
        if (item == 0) computed_at_first = computed;
        return true;
      });
  EXPECT_EQ(computed, 10'000);
  EXPECT_LT(computed_at_first, 10'000);
}

TEST(InOrder, StopsWhenNoMoreAreWanted) {
  for (const int threads : {1, 4}) {
    std::atomic<int> computed = 0;
    std::size_t taken = 0;
    InOrder<int>::Run(
        {.count = 1'000'000, .threads = threads}, [&](std::size_t) { return ++computed; },
        [&](std::size_t, int) { return ++taken < 5; });
    EXPECT_EQ(taken, 5u);
    EXPECT_LT(computed, 2000);
  }
}

TEST(InOrder, HandsOnWhatAComputationThrowsWhenItsTurnComes) {
  for (const int threads : {1, 3}) {
    std::size_t taken = 0;
    const auto run = [&] {
      InOrder<int>::Run(
          {.count = 100, .threads = threads},
          [](std::size_t item) {
            if (item >= 40) throw std::logic_error(std::to_string(item));
            return 0;
          },
          [&](std::size_t, int) { return ++taken > 0; });
    };
    try {
      run();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::logic_error& fault) {
      EXPECT_STREQ(fault.what(), "40");
    }
    EXPECT_EQ(taken, 40u);
  }
}

}  // namespace
}  // namespace tautline::cli
