#include "tautline/draw/length_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace tautline {
namespace {

constexpr std::array<double, 10> kPowers = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

/// Beyond this the scaled value no longer fits an integer; nothing in a picture is so large.
constexpr double kLargest = 9e17;

}  // namespace

std::string FixedText(double value, int decimals) {
  if (!std::isfinite(value)) return "?";
  const double power = kPowers[static_cast<std::size_t>(std::clamp(decimals, 0, 9))];
  const std::int64_t scaled = std::llround(std::clamp(value * power, -kLargest, kLargest));
  const std::int64_t unit = static_cast<std::int64_t>(power), magnitude = std::abs(scaled);
  std::string text = (scaled < 0 ? "-" : "") + std::to_string(magnitude / unit);
  if (decimals <= 0) return text;
  const std::string fraction = std::to_string(magnitude % unit);
  return text + "." + std::string(static_cast<std::size_t>(decimals) - fraction.size(), '0') + fraction;
}

std::string CompactText(double value, int decimals) {
  if (!std::isfinite(value)) return "0";
  std::string text = FixedText(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

int LengthDecimals(double extent_m) {
  if (!(extent_m > 0) || !std::isfinite(extent_m)) return 2;
  if (extent_m >= 1e6) return 0;
  if (extent_m >= 5e3) return 1;
  if (extent_m >= 5) return 2;
  return std::min(9, 2 + static_cast<int>(std::ceil(std::log10(5 / extent_m))));
}

int DecimalsToTellApart(double a, double b, int decimals) {
  while (decimals < 9 && a != b && FixedText(a, decimals) == FixedText(b, decimals)) ++decimals;
  return decimals;
}

std::string LengthText(double length_m, int decimals) { return FixedText(length_m, decimals) + " m"; }

std::string AreaText(double area_m2) {
  if (!(area_m2 > 0) || !std::isfinite(area_m2)) return "0 m²";
  const int digits_before = static_cast<int>(std::floor(std::log10(area_m2))) + 1;
  return CompactText(area_m2, std::clamp(4 - digits_before, 0, 9)) + " m²";
}

double RoundLengthBelow(double length_m) {
  const double power = std::pow(10, std::floor(std::log10(length_m)));
  // A hair of tolerance: 5 must not become 2 because log10 or pow rounded.
  const double ratio = length_m / power * (1 + 1e-9);
  return (ratio >= 5 ? 5 : ratio >= 2 ? 2 : 1) * power;
}

std::string RoundLengthText(double length_m) {
  if (length_m >= 999.9) return CompactText(length_m / 1e3, 3) + " km";
  if (length_m >= 0.9999) return CompactText(length_m, 3) + " m";
  if (length_m >= 0.009999) return CompactText(length_m * 1e2, 3) + " cm";
  if (length_m >= 0.0009999) return CompactText(length_m * 1e3, 3) + " mm";
  return CompactText(length_m * 1e6, 6) + " µm";
}

}  // namespace tautline
