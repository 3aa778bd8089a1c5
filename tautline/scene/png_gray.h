// PNG images as brightness and opacity. Native: needs libpng.
#ifndef TAUTLINE_SCENE_PNG_GRAY_H_
#define TAUTLINE_SCENE_PNG_GRAY_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/scene/raster_image.h"

namespace tautline {

/// Reads a PNG of any colour type and depth, interlaced or not: palettes are resolved, a transparent colour becomes
/// alpha, 16 bits are kept, gamma and colour profiles are ignored. `file` stands in the errors: kInvalidInput with
/// libpng's reason, kLimitExceeded above kMaxCells pixels. O(pixels).
[[nodiscard]] Expected<RasterImage> ParsePng(std::string_view bytes, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_PNG_GRAY_H_
