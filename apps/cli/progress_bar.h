// How far a long computation is, for people who wait at a terminal.
#ifndef APPS_CLI_PROGRESS_BAR_H_
#define APPS_CLI_PROGRESS_BAR_H_

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "tautline/base/stop.h"

namespace tautline::cli {

/// One line on standard error with stage, percentage and time left, after the first second; nothing where standard
/// error is no terminal. The line is gone when the bar is.
class ProgressBar {
 public:
  /// Starts to count the time. `wanted`: false shows nothing.
  explicit ProgressBar(bool wanted);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  /// What is being done now and the share of it that is done, 0 to 1; no share: unknown. From any thread.
  void Tell(std::string_view stage, std::optional<double> share);

  /// What else is to be said behind it, from now on; from any thread.
  void Remark(std::string_view remark);

  /// Removes the line, so that something else can be printed; it comes back with the next news.
  void Clear();

  /// Tells of a stage whose share nobody knows, each time that a library function asks whether to go on: always.
  KeepGoing Passing(std::string_view stage);

  /// Hands what a library function tells to the bar, which must outlive it.
  Watcher watcher();

 private:
  using Clock = std::chrono::steady_clock;

  void Show();

  bool enabled_ = false;
  Clock::time_point start_;
  std::mutex mutex_;
  std::condition_variable done_changed_;
  std::string stage_;
  Clock::time_point stage_start_;
  std::optional<double> share_;
  std::string remark_;
  bool news_ = false;   ///< Told since the line was removed.
  bool shown_ = false;  ///< The line stands on the terminal.
  bool done_ = false;
  std::thread thread_;  ///< Draws, also while nothing is told.
};

/// "visibility graph  42 %, 12 s left", or without a share "visibility graph, for 12 s": `seconds` since the stage
/// began, and none left is foretold before a hundredth is done.
std::string ProgressText(std::string_view stage, std::optional<double> share, double seconds);

}  // namespace tautline::cli

#endif  // APPS_CLI_PROGRESS_BAR_H_
