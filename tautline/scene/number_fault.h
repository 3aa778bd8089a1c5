// What a number of a scene may be: one set of rules for files and for scenes built in C++.
#ifndef TAUTLINE_SCENE_NUMBER_FAULT_H_
#define TAUTLINE_SCENE_NUMBER_FAULT_H_

#include <optional>
#include <span>
#include <string>

#include "tautline/base/error.h"
#include "tautline/geometry/point.h"

namespace tautline {

/// The largest coordinate of a world, metres. The coordinate grid is then 2^-51 of it or 2^-39 of the extent, whichever
/// is coarser: at most 0.05 mm, so that features of a millimetre stay what they are.
inline constexpr double kLargestCoordinate = 1e7;

/// The largest size of any other number, such as a length in metres.
inline constexpr double kLargestNumber = 1e15;

/// What is wrong with a value and how to mend it: the rest of a sentence that starts with the value's name.
struct Fault {
  std::string text;                           ///< "must be ..."
  ErrorCode code = ErrorCode::kInvalidInput;  ///< kLimitExceeded for what is too large.
};

/// Not finite, or larger than kLargestNumber.
std::optional<Fault> NumberFault(double value);

/// As NumberFault, or not larger than 0.
std::optional<Fault> PositiveFault(double value);

/// As NumberFault, or smaller than 0.
std::optional<Fault> NonNegativeFault(double value);

/// Not finite, or a coordinate larger than kLargestCoordinate.
std::optional<Fault> PointFault(Point p);

/// The first PointFault of a list; "[3] is ..." tells which point, counted from 1. O(n).
std::optional<Fault> PointsFault(std::span<const Point> points);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_NUMBER_FAULT_H_
