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
  constexpr Index() = default;
  constexpr explicit Index(std::int32_t value) : value_(value) {}
  constexpr explicit Index(std::size_t value) : value_(static_cast<std::int32_t>(value)) {}

  constexpr std::int32_t value() const { return value_; }
  constexpr std::size_t index() const { return static_cast<std::size_t>(value_); }
  constexpr bool valid() const { return value_ >= 0; }

  constexpr Index& operator++() {
    ++value_;
    return *this;
  }

  friend constexpr auto operator<=>(Index, Index) = default;

 private:
  std::int32_t value_ = -1;
};

}  // namespace tautline

template <class Tag>
struct std::hash<tautline::Index<Tag>> {
  std::size_t operator()(tautline::Index<Tag> id) const noexcept { return std::hash<std::int32_t>{}(id.value()); }
};

#endif  // TAUTLINE_BASE_INDEX_H_
