// The bits of a double as an integer, and back.
#ifndef TAUTLINE_BASE_DOUBLE_BITS_H_
#define TAUTLINE_BASE_DOUBLE_BITS_H_

#include <cstdint>
#include <cstring>

namespace tautline {

/// The IEEE 754 representation of a double. As std::bit_cast, which the browser's compiler lacks.
inline std::uint64_t DoubleBits(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// The double with these bits.
inline double DoubleOfBits(std::uint64_t bits) {
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

}  // namespace tautline

#endif  // TAUTLINE_BASE_DOUBLE_BITS_H_
