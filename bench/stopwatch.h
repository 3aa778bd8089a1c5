// How long something takes, and what many such times amount to.
#ifndef TAUTLINE_BENCH_STOPWATCH_H_
#define TAUTLINE_BENCH_STOPWATCH_H_

#include <time.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tautline {

/// The processor time of this thread so far, seconds: what other programs do meanwhile does not count.
inline double ThreadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Seconds on the clock on the wall: for work in several threads.
inline double WallSeconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The processor seconds that one call of `work` takes. Reading the clock costs less than half a microsecond.
template <class Work>
double SecondsOf(Work work) {
  const double start = ThreadSeconds();
  work();
  return ThreadSeconds() - start;
}

/// What many measurements amount to; zeros when there are none.
struct Summary {
  double median = 0;
  double p99 = 0;
  double worst = 0;
  double mean = 0;
};

inline Summary Summarize(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&values](double fraction) {
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(values.size())));
    return values[std::max<std::size_t>(rank, 1) - 1];
  };
  Summary summary{at(0.5), at(0.99), values.back(), 0};
  for (const double value : values) summary.mean += value / static_cast<double>(values.size());
  return summary;
}

/// The seconds that work(i) takes for each i below `count`: the least of `passes` passes over all of them, so that
/// what else the machine does is not counted while caches are as cold as between different questions.
template <class Work>
std::vector<double> SecondsOfEach(std::size_t count, int passes, Work work) {
  std::vector<double> seconds(count, 1e300);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t i = 0; i < count; ++i) {
      seconds[i] = std::min(seconds[i], SecondsOf([&] { work(i); }));
    }
  }
  return seconds;
}

}  // namespace tautline

#endif  // TAUTLINE_BENCH_STOPWATCH_H_
