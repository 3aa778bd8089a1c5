// A small seeded generator of random numbers with the same output on every platform.
#ifndef TAUTLINE_BASE_RNG_H_
#define TAUTLINE_BASE_RNG_H_

#include <cstdint>

namespace tautline {

/// SplitMix64 [Steele2014]: 64 bits of state, the same bytes for the same seed everywhere.
class Rng {
 public:
  /// Starts the sequence that belongs to `seed`.
  explicit Rng(std::uint64_t seed) : state_(seed) {}

  /// The next 64 random bits.
  std::uint64_t Next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }

  /// A seed whose generator goes on from here.
  std::uint64_t state() const { return state_; }

  /// Uniform in [0, 1).
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

  /// Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

  /// Uniform among low, low + 1, ..., high (both included; the slight bias of the remainder is accepted).
  int UniformInt(int low, int high) {
    return low + static_cast<int>(Next() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::uint64_t state_;
};

}  // namespace tautline

#endif  // TAUTLINE_BASE_RNG_H_
