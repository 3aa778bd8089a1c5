#include "tautline/draw/line_style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tautline/geometry/point.h"

namespace tautline {
namespace {

struct Colour {
  double red = 0;
  double green = 0;
  double blue = 0;
};

/// From dark to light through hues that the colour-blind tell apart, never lighter than a line on
/// white may be.
constexpr std::array<Colour, 5> kRamp = {{{20, 20, 90}, {0, 100, 160}, {0, 140, 115}, {190, 130, 0}, {205, 75, 120}}};

std::string Hex(double channel) {
  constexpr char kDigits[] = "0123456789abcdef";
  const int value = static_cast<int>(std::lround(std::clamp(channel, 0.0, 255.0)));
  return {kDigits[value / 16], kDigits[value % 16]};
}

std::string RampColour(double t) {
  const double position = std::clamp(t, 0.0, 1.0) * (kRamp.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), kRamp.size() - 2);
  const double f = position - static_cast<double>(i);
  const auto mix = [f](double a, double b) { return Hex(a + f * (b - a)); };
  return "#" + mix(kRamp[i].red, kRamp[i + 1].red) + mix(kRamp[i].green, kRamp[i + 1].green) +
         mix(kRamp[i].blue, kRamp[i + 1].blue);
}

}  // namespace

LineStyle ClassLine(int rank, int count) {
  constexpr std::array<const char*, 4> kDashes = {"", "9 3", "3 2.5", "10 3 2 3"};
  return {.colour = RampColour(count > 1 ? static_cast<double>(rank) / (count - 1) : 0),
          .width = rank == 0 ? 2.6 : 1.9,
          .dashes = kDashes[static_cast<std::size_t>(rank) % kDashes.size()]};
}

std::string ComponentTint(int rank) {
  constexpr std::array<const char*, 5> kTints = {"#dcebf7", "#fbeecb", "#f6dfe9", "#d9f0e6", "#ebe3f5"};
  return rank <= 0 ? kFreeColour : kTints[static_cast<std::size_t>(rank - 1) % kTints.size()];
}

}  // namespace tautline
