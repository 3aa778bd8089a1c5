// An array that grows without moving.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_CHUNKED_ARRAY_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_CHUNKED_ARRAY_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tautline {

/// An array in pieces of 16 KiB: growing neither moves what is there nor needs room twice.
template <class T>
class ChunkedArray {
 public:
  static constexpr std::size_t kChunk = (std::size_t{1} << 14) / sizeof(T);  ///< Elements in a piece.

  /// Makes room for `count` elements that lie one behind the other and returns the position of the first. Numbers are
  /// not set: the memory may be touched first by the thread that sets them. Requires count <= kChunk.
  std::size_t Grow(std::size_t count) {
    if (chunks_.empty() || used_ + count > kChunk) {
      chunks_.emplace_back(new T[kChunk]);
      used_ = 0;
    }
    const std::size_t first = (chunks_.size() - 1) * kChunk + used_;
    used_ += count;
    return first;
  }

  /// The element at a position that Grow made.
  T& operator[](std::size_t i) { return chunks_[i / kChunk][i % kChunk]; }
  /// The same to read.
  const T& operator[](std::size_t i) const { return chunks_[i / kChunk][i % kChunk]; }

  /// One more than the last position.
  std::size_t end() const { return chunks_.empty() ? 0 : (chunks_.size() - 1) * kChunk + used_; }
  /// The memory it holds.
  std::size_t bytes() const { return chunks_.size() * kChunk * sizeof(T); }

 private:
  std::vector<std::unique_ptr<T[]>> chunks_;
  std::size_t used_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_CHUNKED_ARRAY_H_
