// Index types that cannot be mixed up: Index<struct VertexTag> is not Index<struct TriangleTag>.
#ifndef TAUTLINE_BASE_INDEX_H_
#define TAUTLINE_BASE_INDEX_H_

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace tautline {

/// A position in an array of things of kind `Tag`. The default value is "none".
template <class Tag>
class Index {
 public:
  /// The index of nothing.
  constexpr Index() = default;
  /// The index of the thing at a position from 0; negative: of nothing.
  constexpr explicit Index(std::int32_t value) : value_(value) {}
  /// The same from a size. Requires value < 2^31.
  constexpr explicit Index(std::size_t value) : value_(static_cast<std::int32_t>(value)) {}

  /// The position as a signed number; -1 for nothing.
  constexpr std::int32_t value() const { return value_; }
  /// The position, for use as a subscript. Requires valid().
  constexpr std::size_t index() const { return static_cast<std::size_t>(value_); }
  /// Whether it is the index of something.
  constexpr bool valid() const { return value_ >= 0; }

  /// The next position.
  constexpr Index& operator++() {
    ++value_;
    return *this;
  }

  /// By position; nothing comes first.
  friend constexpr auto operator<=>(Index, Index) = default;

 private:
  std::int32_t value_ = -1;
};

}  // namespace tautline

// Doxygen does not find the scope of a specialization in std.
/// @cond
template <class Tag>
struct std::hash<tautline::Index<Tag>> {
  std::size_t operator()(tautline::Index<Tag> id) const noexcept { return std::hash<std::int32_t>{}(id.value()); }
};
/// @endcond

#endif  // TAUTLINE_BASE_INDEX_H_
