#include "apps/cli/parallel_ranges.h"

#include <algorithm>
#include <utility>

#include "apps/cli/signals_blocked.h"

namespace tautline::cli {
namespace {

/// Rounds follow each other within microseconds, and waking a sleeping thread takes longer than that.
constexpr int kSpins = 20'000;

}  // namespace

RangeThreads::RangeThreads(int threads) {
  const SignalsBlocked blocked;  // The calling thread handles them.
  for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { Wait(); });
}

RangeThreads::~RangeThreads() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    ++round_;
  }
  begun_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void RangeThreads::Run(std::size_t count, const Work& work) {
  if (threads_.empty()) return work(0, count);
  {
    const std::lock_guard lock(mutex_);
    work_ = &work;
    count_ = count;
    piece_ = std::max<std::size_t>(1, count / (8 * (threads_.size() + 1)));
    next_ = 0;
    busy_ = threads_.size();
    ++round_;
  }
  begun_.notify_all();
  Share();
  for (int i = 0; i < kSpins && busy_ != 0; ++i) {
  }
  std::unique_lock lock(mutex_);
  done_.wait(lock, [this] { return busy_ == 0; });
  if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void RangeThreads::Wait() {
  for (std::size_t seen = 0;; ++seen) {
    for (int i = 0; i < kSpins && round_ == seen; ++i) {
    }
    if (round_ == seen) {
      std::unique_lock lock(mutex_);
      begun_.wait(lock, [&] { return round_ != seen; });
    }
    if (stop_) return;
    Share();
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) done_.notify_one();
  }
}

void RangeThreads::Share() {
  try {
    for (;;) {
      const std::size_t begin = next_.fetch_add(piece_);
      if (begin >= count_) return;
      (*work_)(begin, std::min(count_, begin + piece_));
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    if (!fault_) fault_ = std::current_exception();
    next_ = count_;
  }
}

}  // namespace tautline::cli
