// How a caller watches a long computation and stops it.
#ifndef TAUTLINE_BASE_STOP_H_
#define TAUTLINE_BASE_STOP_H_

#include <chrono>
#include <functional>
#include <string_view>
#include <utility>

namespace tautline {

/// Asked now and then by a long computation whether to go on; an empty one means always. It may be called from the
/// threads that compute, about a thousand times a second.
using KeepGoing = std::function<bool()>;

/// Goes on until a moment: a time budget. The one place of the library that reads a clock, on its caller's behalf.
inline KeepGoing Until(std::chrono::steady_clock::time_point deadline) {
  return [deadline] { return std::chrono::steady_clock::now() < deadline; };
}

/// Told how far a long computation has come: what it does now, for a person, and the share of that done, 0 to 1.
/// Returns whether to go on. An empty one means always.
using Watcher = std::function<bool(std::string_view stage, double share)>;

/// Thrown inside a computation whose caller said stop, and caught where the computation was called: it never leaves
/// the library.
struct Stopped {};

/// Asks once in so many steps, since asking costs more than a step.
class StopCheck {
 public:
  /// Never stops.
  StopCheck() = default;
  /// Asks `keep_going` at every `steps`-th step.
  StopCheck(KeepGoing keep_going, int steps) : keep_going_(std::move(keep_going)), steps_(steps) {}

  /// Counts a step. Throws Stopped when the caller does not want to go on.
  void Step() {
    if (!keep_going_ || ++count_ < steps_) return;
    count_ = 0;
    if (!keep_going_()) throw Stopped();
  }

 private:
  KeepGoing keep_going_;
  int steps_ = 1;
  int count_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_BASE_STOP_H_
