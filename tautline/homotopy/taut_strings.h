// Taut strings among pins that move: pushed where a pin meets them, bent around what holds them.
#ifndef TAUTLINE_HOMOTOPY_TAUT_STRINGS_H_
#define TAUTLINE_HOMOTOPY_TAUT_STRINGS_H_

#include <memory>
#include <span>
#include <tl/expected.hpp>
#include <vector>

#include "tautline/base/index.h"
#include "tautline/geometry/polygon.h"
#include "tautline/homotopy/corners.h"

namespace tautline {

/// A point that strings cannot pass through: the end of a string, or a corner of an obstacle.
using PinId = Index<struct PinTag>;

/// A taut string.
using StringId = Index<struct StringTag>;

/// A pin that a string touches.
struct StringBend {
  PinId pin;                ///< Which.
  Side side = Side::kNone;  ///< The side of a traveller along the string on which the pin lies; kNone at the two ends.

  /// Whether both are equal.
  friend bool operator==(const StringBend&, const StringBend&) = default;
};

/// A pin was led exactly through another one, so that nobody can say on which side it passed.
struct PinCollision {
  PinId moved;  ///< Which was to move.
  PinId met;    ///< What it would have met; for a pin that would stop there, too.
};

/// Strings in the plane, each tied to one pin and held by another. Moving a pin straight pushes every string that it
/// meets and takes along those that it holds or that bend around it; then all are pulled taut again. So the class of
/// the strings among the pins follows the motion exactly, and the strings are its shortest representatives. Strings
/// pass through each other's interior only where pins made them.
///
/// Pins must stay at different places, except that the pin that holds a string may start where the string is tied.
///
/// A string that passes through no other is an arc without crossings, and so is its image under the motion; such a
/// string never winds around a pin by more than half a turn beyond straight on.
class TautStrings {
 public:
  /// Pins by PinId, metres. No two may be at one place, but for those that Tie is called for next. An obstacle is the
  /// pins at its corners: pins that move must be led around it. O(n).
  explicit TautStrings(std::span<const Point> pins) : TautStrings(pins, pins) {}
  /// The same where pins will come to other places than these: `places` says which, roughly, for speed.
  TautStrings(std::span<const Point> pins, std::span<const Point> places);
  ~TautStrings();
  /// Moves.
  TautStrings(TautStrings&&) noexcept;
  /// Moves.
  TautStrings& operator=(TautStrings&&) noexcept;

  /// A string of length zero from a pin to another at the same place. Until the holder leaves, the pin that the string
  /// is tied to stands for both. Requires that nothing has moved, and pins that no other string begins or ends at.
  /// O(1).
  StringId Tie(PinId tied, PinId holder);

  /// Moves a pin straight to a place. Fails, and moves nothing, when another pin lies on the way or at its end. A pin
  /// whose string has length zero leaves the pin that the string is tied to, and never comes back to it exactly. Every
  /// decision is exact. O(strings near the way * bends + pins swept over), expected, for pins that are spread evenly.
  tl::expected<void, PinCollision> Move(PinId pin, Point to);

  /// Where a pin is.
  Point point(PinId pin) const;
  /// The pins that a string touches, from where it is tied to its holder; also those that it passes without a bend.
  std::span<const StringBend> bends(StringId string) const;
  /// Its length, metres.
  double length(StringId string) const;
  /// Its points.
  Polyline points(StringId string) const;
  /// How many strings.
  std::size_t size() const;
  /// How many pins.
  std::size_t pin_count() const;

 private:
  class Tangle;
  std::unique_ptr<Tangle> tangle_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_TAUT_STRINGS_H_
