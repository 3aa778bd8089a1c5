// A map from a file: ROS, MovingAI or GeoJSON. Native: needs yaml-cpp and libpng.
#ifndef TAUTLINE_SCENE_MAP_FILE_H_
#define TAUTLINE_SCENE_MAP_FILE_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/map_world.h"
#include "tautline/scene/scene_options.h"

namespace tautline {

/// Reads the map in `path`, told by its extension: `.yaml` and `.yml` are ROS maps, whose image (PGM or PNG) is looked
/// up beside them, `.map` is MovingAI, `.geojson` and `.json` are GeoJSON. Errors: kUnreadable (no such file; also of
/// the image), kUnsupported for another extension, and those of the readers, with file and line. O(size).
[[nodiscard]] Expected<MapWorld> ReadMapFile(const std::string& path, const SceneOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MAP_FILE_H_
