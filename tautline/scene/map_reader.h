// A map of any kind, told by its name, from wherever its bytes are.
#ifndef TAUTLINE_SCENE_MAP_READER_H_
#define TAUTLINE_SCENE_MAP_READER_H_

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"
#include "tautline/scene/map_world.h"
#include "tautline/scene/raster_image.h"
#include "tautline/scene/scene_options.h"

namespace tautline {

/// Where the bytes of a map come from, and the two readers that need native libraries where those are at hand. All
/// must be there; `path` stands in their errors.
struct MapSources {
  /// The bytes of a file. Errors: kUnreadable when there is none, kLimitExceeded above `max_bytes`.
  std::function<Expected<std::string>(const std::string& path, std::size_t max_bytes)> read;
  /// The settings of a ROS map.
  std::function<Expected<Document>(const std::string& text, const std::string& path)> parse_settings;
  /// A PNG.
  std::function<Expected<RasterImage>(const std::string& bytes, const std::string& path)> parse_png;
};

/// Reads the map at `path`, told by its extension: `.yaml` and `.yml` are ROS maps, whose image (PGM or PNG, told by
/// its first byte) is looked up beside them, `.map` is MovingAI, `.geojson` and `.json` are GeoJSON. Errors:
/// kUnsupported for another extension, those of the sources, and those of the readers, with file and line. O(size).
[[nodiscard]] Expected<MapWorld> ReadMap(const std::string& path, const MapSources& sources,
                                         const SceneOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MAP_READER_H_
