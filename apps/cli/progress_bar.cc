#include "apps/cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "apps/cli/signals_blocked.h"

namespace tautline::cli {
namespace {

constexpr std::chrono::seconds kSilence{1};
constexpr std::chrono::milliseconds kPeriod{200};
/// Back to the start of the line, and nothing behind.
constexpr char kClearLine[] = "\r\033[K";

std::string Duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(std::ceil(std::min(seconds, 1e9)));
  if (whole < 120) return fmt::format("{} s", whole);
  if (whole < 7200) return fmt::format("{} min", (whole + 30) / 60);
  return fmt::format("{} h", (whole + 1800) / 3600);
}

}  // namespace

std::string ProgressText(std::string_view stage, std::optional<double> share, double seconds) {
  if (!share) return fmt::format("{}, for {}", stage, Duration(seconds));
  const double done = std::clamp(*share, 0.0, 1.0);
  // Rounded down: what is not done is not a hundred.
  std::string text = fmt::format("{} {:3} %", stage, static_cast<int>(100 * done));
  if (done >= 0.01) text += fmt::format(", {} left", Duration(seconds * (1 - done) / done));
  return text;
}

ProgressBar::ProgressBar(bool wanted)
    : enabled_(wanted && isatty(STDERR_FILENO) == 1), start_(Clock::now()), stage_start_(start_) {
  if (!enabled_) return;
  const SignalsBlocked blocked;  // The main thread handles them.
  thread_ = std::thread([this] { Show(); });
}

ProgressBar::~ProgressBar() {
  if (!enabled_) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  done_changed_.notify_one();
  thread_.join();
  Clear();
}

void ProgressBar::Tell(std::string_view stage, std::optional<double> share) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  if (stage_ != stage) {
    stage_ = stage;
    stage_start_ = Clock::now();
  }
  share_ = share;
  news_ = true;
}

void ProgressBar::Remark(std::string_view remark) {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  remark_ = remark;
}

void ProgressBar::Clear() {
  if (!enabled_) return;
  const std::lock_guard lock(mutex_);
  news_ = false;
  if (!shown_) return;
  std::fputs(kClearLine, stderr);
  shown_ = false;
}

KeepGoing ProgressBar::Passing(std::string_view stage) {
  if (!enabled_) return {};
  return [this, stage = std::string(stage)] {
    Tell(stage, std::nullopt);
    return true;
  };
}

Watcher ProgressBar::watcher() {
  if (!enabled_) return {};
  return [this](std::string_view stage, double share) {
    Tell(stage, share);
    return true;
  };
}

void ProgressBar::Show() {
  std::unique_lock lock(mutex_);
  if (done_changed_.wait_until(lock, start_ + kSilence, [this] { return done_; })) return;
  do {
    if (!news_) continue;
    const std::chrono::duration<double> since = Clock::now() - stage_start_;
    const std::string text = ProgressText(stage_, share_, since.count()) + (remark_.empty() ? "" : "; ") + remark_;
    std::fprintf(stderr, "%s%s", kClearLine, text.c_str());
    std::fflush(stderr);
    shown_ = true;
  } while (!done_changed_.wait_for(lock, kPeriod, [this] { return done_; }));
}

}  // namespace tautline::cli
