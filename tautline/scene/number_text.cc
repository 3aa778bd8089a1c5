#include "tautline/scene/number_text.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>

namespace tautline {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// The parts of a decimal number while it is read: mantissa * 10^exponent, where `exact` says that no digit was lost.
struct Decimal {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  int digits = 0;
  bool negative = false;
  bool exact = true;
};

constexpr std::uint64_t kLargestExactMantissa = std::uint64_t{1} << 53;

/// Reads digits from `text` at `i`; each one after the point lowers the exponent.
void ReadDigits(std::string_view text, std::size_t& i, int exponent_step, Decimal& decimal) {
  for (; i < text.size() && IsDigit(text[i]); ++i, ++decimal.digits) {
    if (decimal.mantissa > kLargestExactMantissa / 10 - 1) {
      decimal.exact = false;
      continue;
    }
    decimal.mantissa = decimal.mantissa * 10 + static_cast<std::uint64_t>(text[i] - '0');
    decimal.exponent += exponent_step;
  }
}

/// Reads "e-12" at `i` to the end of the text. False when it is not that.
bool ReadExponent(std::string_view text, std::size_t i, Decimal& decimal) {
  ++i;
  const bool negative = i < text.size() && text[i] == '-';
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
  if (i == text.size()) return false;
  int exponent = 0;
  for (; i < text.size(); ++i) {
    if (!IsDigit(text[i])) return false;
    if (exponent < 100000) exponent = exponent * 10 + (text[i] - '0');
  }
  decimal.exponent += negative ? -exponent : exponent;
  return true;
}

/// The grammar [-+]? (digits [. digits?]? | . digits) ([eE] [-+]? digits)?
std::optional<Decimal> ReadDecimal(std::string_view text) {
  Decimal decimal;
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) decimal.negative = text[i++] == '-';
  ReadDigits(text, i, 0, decimal);
  if (i < text.size() && text[i] == '.') ReadDigits(text, ++i, -1, decimal);
  if (decimal.digits == 0) return std::nullopt;
  if (i == text.size()) return decimal;
  if ((text[i] != 'e' && text[i] != 'E') || !ReadExponent(text, i, decimal)) return std::nullopt;
  return decimal;
}

/// Powers of ten that are doubles exactly.
double PowerOfTen(int exponent) {
  double power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

/// The general case, by the classic locale of the standard library.
double ParseSlowly(std::string_view text, const Decimal& decimal) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> value;
  if (!stream.fail()) return value;
  // The grammar holds, so the only failures are overflow and underflow.
  const double size = decimal.exponent > 0 ? std::numeric_limits<double>::infinity() : 0;
  return decimal.negative ? -size : size;
}

}  // namespace

std::optional<double> ParseNumber(std::string_view text) {
  const auto decimal = ReadDecimal(text);
  if (!decimal) return std::nullopt;
  // Both factors are doubles exactly, so one rounding gives the nearest double [Clinger1990].
  constexpr int kLargestExactPower = 22;
  if (!decimal->exact || decimal->exponent > kLargestExactPower || decimal->exponent < -kLargestExactPower) {
    return ParseSlowly(text, *decimal);
  }
  const double mantissa = static_cast<double>(decimal->mantissa);
  const double value =
      decimal->exponent < 0 ? mantissa / PowerOfTen(-decimal->exponent) : mantissa * PowerOfTen(decimal->exponent);
  return decimal->negative ? -value : value;
}

std::string FormatNumber(double value) {
  for (int digits = 6; digits < 17; ++digits) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(digits);
    stream << value;
    if (ParseNumber(stream.str()) == value) return stream.str();
  }
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(17);
  stream << value;
  return stream.str();
}

std::string ShortNumber(double value) {
  constexpr double kNothing = 1e-9;
  constexpr int kDigitsOfSmall = 6, kDecimals = 4, kMostDigits = 12;
  int digits = std::fabs(value) < 1 ? kDigitsOfSmall : kDecimals + 1;
  for (double size = std::fabs(value); size >= 10 && digits < kMostDigits; size /= 10) ++digits;
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(digits);
  stream << (std::fabs(value) < kNothing ? 0 : value);
  return stream.str();
}

std::string Metres(double value) { return ShortNumber(value) + " m"; }

std::string ToText(Point point) { return "(" + FormatNumber(point.x) + ", " + FormatNumber(point.y) + ")"; }

std::string ShortText(Point point) { return "(" + ShortNumber(point.x) + ", " + ShortNumber(point.y) + ")"; }

}  // namespace tautline
