// An SVG picture as PNG. Native: needs librsvg, cairo and fontconfig.
#ifndef TAUTLINE_DRAW_PNG_H_
#define TAUTLINE_DRAW_PNG_H_

#include <string>

#include "tautline/base/error.h"

namespace tautline {

/// Renders an SVG document with `scale` pixels per SVG pixel on white; the bytes of the PNG file.
/// Errors: kInvalidInput (not an SVG that librsvg reads, a scale that is not positive),
/// kLimitExceeded (more than kMaxPngPixels pixels on a side).
[[nodiscard]] Expected<std::string> RenderPng(const std::string& svg, double scale = 1);

/// Whether the system has a font; without one, RenderPng draws a box for every letter. Reads fontconfig's cache.
[[nodiscard]] bool HasFont();

/// The longest side of a rendered picture, pixels; cairo's own limit.
inline constexpr int kMaxPngPixels = 32'767;

}  // namespace tautline

#endif  // TAUTLINE_DRAW_PNG_H_
