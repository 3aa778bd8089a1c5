// Ranges of a computation in several threads that wait between the ranges.
#ifndef APPS_CLI_PARALLEL_RANGES_H_
#define APPS_CLI_PARALLEL_RANGES_H_

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tautline::cli {

/// Threads that share out [0, count) among themselves and the caller, again and again, in pieces so small that none
/// waits long for another.
class RangeThreads {
 public:
  /// What a range is given to.
  using Work = std::function<void(std::size_t begin, std::size_t end)>;

  /// Starts threads - 1 threads. Requires threads >= 1.
  explicit RangeThreads(int threads);
  RangeThreads(const RangeThreads&) = delete;
  RangeThreads& operator=(const RangeThreads&) = delete;
  ~RangeThreads();

  /// Returns when all of [0, count) is done. An exception of the work is thrown again.
  void Run(std::size_t count, const Work& work);

 private:
  void Wait();
  void Share();

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable begun_, done_;
  std::atomic<std::size_t> round_ = 0;  ///< Grows with each Run; what the threads wait for.
  std::atomic<std::size_t> busy_ = 0;   ///< Threads that have not finished the round.
  std::atomic<std::size_t> next_ = 0;   ///< The first item that no thread has taken.
  std::atomic<bool> stop_ = false;
  std::size_t count_ = 0, piece_ = 1;
  const Work* work_ = nullptr;
  std::exception_ptr fault_;
};

}  // namespace tautline::cli

#endif  // APPS_CLI_PARALLEL_RANGES_H_
