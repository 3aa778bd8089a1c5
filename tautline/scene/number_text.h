// Numbers from text and to text, the same in every locale.
#ifndef TAUTLINE_SCENE_NUMBER_TEXT_H_
#define TAUTLINE_SCENE_NUMBER_TEXT_H_

#include <optional>
#include <string>
#include <string_view>

#include "tautline/geometry/point.h"

namespace tautline {

/// The double nearest to a decimal number such as "12", "-0.5", "+3.", ".25" or "1e-3"; infinity when it is too large
/// for a double. Nothing when the whole text is not such a number: no blanks, no hexadecimal, no "inf", no "nan".
/// O(length).
std::optional<double> ParseNumber(std::string_view text);

/// The shortest text that ParseNumber reads back as the same finite number: "0.1", "-3", "1e+30".
std::string FormatNumber(double value);

/// A number for people: four decimals, or below 1 six digits, without trailing zeros: "74.3412", "1234.5678",
/// "0.0117766". What is nearer to 0 than 1e-9 is "0", as coordinates that rounding leaves them. Requires a finite one.
std::string ShortNumber(double value);

/// "12.34 m", by ShortNumber.
std::string Metres(double value);

/// "(1.5, -2)", exactly.
std::string ToText(Point point);

/// "(1.3333, -2)", by ShortNumber.
std::string ShortText(Point point);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_NUMBER_TEXT_H_
