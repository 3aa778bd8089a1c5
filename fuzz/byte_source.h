// Small choices from the bytes of a fuzzer: the shorter the input, the plainer the choices.
#ifndef FUZZ_BYTE_SOURCE_H_
#define FUZZ_BYTE_SOURCE_H_

#include <cstddef>
#include <cstdint>
#include <span>

namespace tautline::fuzz {

/// Hands out one byte after another; zeros after the last one.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  int Byte() { return next_ < bytes_.size() ? bytes_[next_++] : 0; }

  /// Among low, ..., high. Requires fewer than 256 values.
  int Int(int low, int high) { return low + Byte() % (high - low + 1); }

  /// One of a fixed list of choices.
  template <class T, std::size_t kCount>
  T Pick(const T (&choices)[kCount]) {
    return choices[static_cast<std::size_t>(Byte()) % kCount];
  }

  bool empty() const { return next_ >= bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace tautline::fuzz

#endif  // FUZZ_BYTE_SOURCE_H_
