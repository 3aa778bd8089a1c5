// Maps of ROS map_server: a YAML file of settings and an image.
#ifndef TAUTLINE_SCENE_ROS_MAP_H_
#define TAUTLINE_SCENE_ROS_MAP_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/geometry/occupancy_grid.h"
#include "tautline/scene/document.h"
#include "tautline/scene/raster_image.h"

namespace tautline {

/// How the brightness of a pixel becomes the state of a cell.
enum class RosMapMode { kTrinary, kScale, kRaw };

/// The settings of a map YAML, as nav2_map_server reads them.
struct RosMapSettings {
  std::string image;                       ///< As written: absolute, or relative to the YAML file.
  double resolution_m = 0;                 ///< Metres per pixel: 1e-6..1e6.
  Point origin;                            ///< Of the lower left corner of the lower left pixel, metres.
  double yaw_rad = 0;                      ///< Counter-clockwise.
  bool negate = false;                     ///< White is occupied.
  double occupied_thresh = 0;              ///< 0..1.
  double free_thresh = 0;                  ///< 0..1, not above occupied_thresh.
  RosMapMode mode = RosMapMode::kTrinary;  ///< How pixels become cells.
};

/// Reads the settings. `image`, `resolution`, `origin` (x, y, yaw), `negate`, `occupied_thresh` and `free_thresh` are
/// required, `mode` is trinary when absent; unknown keys are ignored, as map_server ignores them. Errors:
/// kInvalidInput with file and line.
[[nodiscard]] Expected<RosMapSettings> ReadRosMapSettings(const Document& document, const std::string& file);

/// The cells of the map. With shade = the mean of red, green and blue (0..1) and occ = 1 - shade (shade when negated):
///   trinary: occ > occupied_thresh is blocked, occ < free_thresh is free, everything between is unknown; when the
///            image has transparency, opacity counts as a fourth channel of the mean;
///   scale:   a pixel that is not fully opaque is unknown; the thresholds decide as above, and the graded values
///            between them, which map_server publishes as 1..99, are unknown;
///   raw:     v = round(255 shade) is the occupancy in percent, whatever `negate` says; above 100 is unknown; the
///            rest is blocked when v > 100 occupied_thresh, free when v < 100 free_thresh, else unknown.
/// This is what nav2_map_server publishes; the rules for the graded values of scale and raw are tautline's, on the
/// side of caution. O(pixels).
OccupancyGrid GridFromRosImage(const RasterImage& image, const RosMapSettings& settings);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_ROS_MAP_H_
