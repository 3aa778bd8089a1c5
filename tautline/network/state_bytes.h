// The state of a computation as bytes, the same on every machine, to go on from later.
#ifndef TAUTLINE_NETWORK_STATE_BYTES_H_
#define TAUTLINE_NETWORK_STATE_BYTES_H_

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tautline {

/// Collects numbers, low bytes first.
class StateWriter {
 public:
  /// 8 bytes.
  void Whole(std::int64_t value) {
    const auto bits = static_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>(bits >> shift);
  }
  /// 8 bytes, exactly that number.
  void Real(double value) {
    std::int64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    Whole(bits);
  }
  /// How many, and 4 bytes each.
  void Floats(std::span<const float> values) {
    Whole(static_cast<std::int64_t>(values.size()));
    for (const float value : values) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int shift = 0; shift < 32; shift += 8) bytes_ += static_cast<char>(bits >> shift);
    }
  }
  /// How many bytes, and those.
  void Text(std::string_view text) {
    Whole(static_cast<std::int64_t>(text.size()));
    bytes_ += text;
  }
  /// All of it.
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads them again in their order. What is missing reads as zeros and empty, and `whole()` is false from then on.
class StateReader {
 public:
  /// Keeps the view.
  explicit StateReader(std::string_view bytes) : bytes_(bytes) {}

  /// As StateWriter::Whole.
  std::int64_t Whole() {
    std::uint64_t bits = 0;
    const std::string_view part = Part(8);
    for (std::size_t i = 0; i < part.size(); ++i) {
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(part[i])) << (8 * i);
    }
    return static_cast<std::int64_t>(bits);
  }
  /// As StateWriter::Real.
  double Real() {
    const std::int64_t bits = Whole();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  /// As StateWriter::Floats.
  std::vector<float> Floats() {
    const std::string_view part = Part(Count(4) * 4);
    std::vector<float> values(part.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::uint32_t bits = 0;
      for (std::size_t j = 0; j < 4; ++j) {
        bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(part[4 * i + j])) << (8 * j);
      }
      std::memcpy(&values[i], &bits, sizeof bits);
    }
    return values;
  }
  /// As StateWriter::Text.
  std::string_view Text() { return Part(Count(1)); }
  /// A number of things that take at least `bytes_each` bytes and follow.
  std::size_t Count(std::size_t bytes_each) {
    const std::int64_t count = Whole();
    if (count >= 0 && static_cast<std::uint64_t>(count) <= bytes_.size() / bytes_each) {
      return static_cast<std::size_t>(count);
    }
    whole_ = false;
    return 0;
  }
  /// Whether nothing was missing yet.
  bool whole() const { return whole_; }
  /// Whether nothing is left.
  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view Part(std::size_t size) {
    if (size > bytes_.size()) {
      whole_ = false;
      return {};
    }
    const std::string_view part = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return part;
  }

  std::string_view bytes_;
  bool whole_ = true;
};

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_STATE_BYTES_H_
