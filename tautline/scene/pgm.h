// Portable grey maps (PGM), plain and binary.
#ifndef TAUTLINE_SCENE_PGM_H_
#define TAUTLINE_SCENE_PGM_H_

#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/scene/raster_image.h"

namespace tautline {

/// Reads a PGM: P2 (text) or P5 (binary), comments, values up to `maxval` <= 65535; binary values above 255 take two
/// bytes, the high one first. What follows the last pixel is ignored. `file` stands in the errors: kInvalidInput
/// (also for a file that ends early or a value above maxval), kUnsupported for other portable formats,
/// kLimitExceeded above kMaxCells pixels. O(length).
[[nodiscard]] Expected<RasterImage> ParsePgm(std::string_view bytes, const std::string& file);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_PGM_H_
