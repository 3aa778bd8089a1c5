// TAUTLINE_CHECK: a broken invariant is a fault of tautline's own and throws in every build.
#ifndef TAUTLINE_BASE_CHECK_H_
#define TAUTLINE_BASE_CHECK_H_

#include <stdexcept>
#include <string>

namespace tautline::internal {

[[noreturn]] inline void CheckFailed(const char* condition, const char* file, int line) {
  throw std::logic_error(std::string(file) + ":" + std::to_string(line) + ": broken invariant: " + condition);
}

}  // namespace tautline::internal

/// Throws std::logic_error unless `condition` holds. For invariants, never for input.
#define TAUTLINE_CHECK(condition)                                        \
  do {                                                                   \
    if (!(condition)) {                                                  \
      ::tautline::internal::CheckFailed(#condition, __FILE__, __LINE__); \
    }                                                                    \
  } while (false)

#endif  // TAUTLINE_BASE_CHECK_H_
