// An image as the map readers need it: brightness and opacity of every pixel.
#ifndef TAUTLINE_SCENE_RASTER_IMAGE_H_
#define TAUTLINE_SCENE_RASTER_IMAGE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tautline {

/// The largest map or image, cells or pixels: 8192 x 8192.
inline constexpr std::size_t kMaxCells = std::size_t{1} << 26;

/// columns x rows pixels, the top row first.
struct RasterImage {
  int columns = 0;                        ///< Pixels from left to right.
  int rows = 0;                           ///< Pixels from top to bottom.
  int maximum = 255;                      ///< The value of a full channel: 1..65535.
  std::vector<std::uint32_t> colour_sum;  ///< Red + green + blue, 0..3 * maximum; grey counts three times.
  std::vector<std::uint16_t> alpha;       ///< 0 (transparent)..maximum; empty when the image has no transparency.

  /// The position of a pixel in the vectors; row 0 is the top.
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

}  // namespace tautline

#endif  // TAUTLINE_SCENE_RASTER_IMAGE_H_
