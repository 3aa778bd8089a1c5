// How long the random tests run.
#ifndef TAUTLINE_BASE_TEST_SCALE_H_
#define TAUTLINE_BASE_TEST_SCALE_H_

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace tautline {

/// For tests only: `count` scaled by the environment variable TAUTLINE_TEST_SCALE, an integer percentage that is 100
/// when absent or not a positive number; at least 1. Sanitizers run a few percent, `make soak` runs thousands.
inline std::int64_t ScaledTestCount(std::int64_t count) {
  const char* text = std::getenv("TAUTLINE_TEST_SCALE");
  const std::int64_t percent = text == nullptr ? 100 : std::atoll(text);
  return std::max<std::int64_t>(1, count * (percent > 0 ? percent : 100) / 100);
}

}  // namespace tautline

#endif  // TAUTLINE_BASE_TEST_SCALE_H_
