// Numbers and lengths as text for pictures: short, without exponents, the same bytes everywhere.
#ifndef TAUTLINE_DRAW_LENGTH_TEXT_H_
#define TAUTLINE_DRAW_LENGTH_TEXT_H_

#include <string>

namespace tautline {

/// `value` rounded to `decimals` (0 to 9) places, with all of them written: "12.30". "?" when it is
/// not finite.
std::string FixedText(double value, int decimals);

/// As FixedText without trailing zeros: "12.3", "0", "-4". "0" when it is not finite, so that it
/// can stand in an attribute.
std::string CompactText(double value, int decimals);

/// How many decimals a length deserves in a world that is `extent_m` metres wide: two for rooms and
/// buildings, more for smaller worlds, fewer for larger ones.
int LengthDecimals(double extent_m);

/// The least number of decimals (at least `decimals`, at most 9) with which two different numbers
/// look different.
int DecimalsToTellApart(double a, double b, int decimals);

/// "12.34 m".
std::string LengthText(double length_m, int decimals);

/// "123.4 m²", with about four digits.
std::string AreaText(double area_m2);

/// The largest of 1, 2, 5 times a power of ten that is not above `length_m` (> 0).
double RoundLengthBelow(double length_m);

/// A round length in the unit that suits it: "5 m", "2 km", "50 cm", "1 mm", "20 µm".
std::string RoundLengthText(double length_m);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_LENGTH_TEXT_H_
