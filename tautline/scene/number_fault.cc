#include "tautline/scene/number_fault.h"

#include <cmath>
#include <cstddef>

#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// " is 5", where FormatNumber knows no text for what is not finite.
std::string Is(double value) {
  if (std::isnan(value)) return " is not a number";
  if (std::isinf(value)) return " is infinite";
  return " is " + FormatNumber(value);
}

}  // namespace

std::optional<Fault> NumberFault(double value) {
  if (!std::isfinite(value)) return Fault{Is(value) + ": it must be finite"};
  if (std::fabs(value) > kLargestNumber) {
    return Fault{Is(value) + ": numbers go up to 1e15", ErrorCode::kLimitExceeded};
  }
  return std::nullopt;
}

std::optional<Fault> PositiveFault(double value) {
  if (auto fault = NumberFault(value)) return fault;
  if (value > 0) return std::nullopt;
  return Fault{Is(value) + ": it must be larger than 0"};
}

std::optional<Fault> NonNegativeFault(double value) {
  if (auto fault = NumberFault(value)) return fault;
  if (value >= 0) return std::nullopt;
  return Fault{Is(value) + ": it must not be negative"};
}

std::optional<Fault> PointFault(Point p) {
  for (const double value : {p.x, p.y}) {
    if (!std::isfinite(value)) return Fault{Is(value) + ": coordinates must be finite"};
    if (std::fabs(value) <= kLargestCoordinate) continue;
    return Fault{Is(value) + ": coordinates go up to 1e7 metres; move the origin nearer or check the units",
                 ErrorCode::kLimitExceeded};
  }
  return std::nullopt;
}

std::optional<Fault> PointsFault(std::span<const Point> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const auto fault = PointFault(points[i])) {
      return Fault{"[" + std::to_string(i + 1) + "]" + fault->text, fault->code};
    }
  }
  return std::nullopt;
}

}  // namespace tautline
