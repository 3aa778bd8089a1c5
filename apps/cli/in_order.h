// Many computations in several threads, their results in order.
#ifndef APPS_CLI_IN_ORDER_H_
#define APPS_CLI_IN_ORDER_H_

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "apps/cli/signals_blocked.h"

namespace tautline::cli {

/// How much there is to do, and by how many.
struct InOrderOptions {
  std::size_t count = 0;  ///< Items, numbered from 0 on.
  int threads = 1;        ///< Threads that compute, 1 or more; with 1, the calling thread itself.
};

/// Computes every item and hands the results to the calling thread in the order of their numbers, each as soon as its
/// turn comes. What is handed over does not depend on the number of threads.
template <class Result>
class InOrder {
 public:
  /// Computes one item; called from several threads at a time.
  using Compute = std::function<Result(std::size_t item)>;
  /// Takes one result, in order, in the calling thread; false when no more are wanted.
  using Take = std::function<bool(std::size_t item, Result result)>;

  /// Returns when all results are taken or no more are wanted. An exception of a computation is thrown again when its
  /// turn comes, one of `take` at once; in either case the other threads are waited for.
  static void Run(const InOrderOptions& options, const Compute& compute, const Take& take) {
    if (options.threads <= 1 || options.count <= 1) {
      for (std::size_t i = 0; i < options.count; ++i) {
        if (!take(i, compute(i))) return;
      }
      return;
    }
    InOrder(options, compute).TakeAll(take);
  }

 private:
  /// What a computation left: its result or what it threw.
  struct Done {
    std::optional<Result> result;
    std::exception_ptr fault;
  };

  InOrder(const InOrderOptions& options, const Compute& compute) : count_(options.count), compute_(compute) {
    const std::size_t threads = std::min(count_, static_cast<std::size_t>(options.threads));
    // Results that wait for a slow one before them take memory.
    done_.resize(std::min(count_, kAheadPerThread * threads));
    const SignalsBlocked blocked;  // The calling thread handles them.
    for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { Work(); });
  }

  ~InOrder() {
    {
      const std::lock_guard lock(mutex_);
      next_ = count_;
    }
    room_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void Work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      room_.wait(lock, [this] { return next_ >= count_ || next_ < taken_ + done_.size(); });
      if (next_ >= count_) return;
      const std::size_t item = next_++;
      lock.unlock();
      Done done;
      try {
        done.result.emplace(compute_(item));
      } catch (...) {
        done.fault = std::current_exception();
      }
      lock.lock();
      done_[item % done_.size()] = std::move(done);
      if (item == taken_) ready_.notify_one();
    }
  }

  void TakeAll(const Take& take) {
    for (std::size_t item = 0; item < count_; ++item) {
      std::unique_lock lock(mutex_);
      Done& slot = done_[item % done_.size()];
      ready_.wait(lock, [&slot] { return slot.result || slot.fault; });
      Done done = std::exchange(slot, {});
      ++taken_;
      lock.unlock();
      room_.notify_all();
      if (done.fault) std::rethrow_exception(done.fault);
      if (!take(item, std::move(*done.result))) return;
    }
  }

  static constexpr std::size_t kAheadPerThread = 64;

  const std::size_t count_;
  const Compute& compute_;
  std::mutex mutex_;
  std::condition_variable ready_;  ///< The next result to be taken is there.
  std::condition_variable room_;   ///< There is room for another result.
  std::size_t next_ = 0;           ///< The first item that no thread has begun.
  std::size_t taken_ = 0;          ///< How many results were taken.
  std::vector<Done> done_;         ///< Of item i at i modulo its size.
  std::vector<std::thread> threads_;
};

}  // namespace tautline::cli

#endif  // APPS_CLI_IN_ORDER_H_
