// A map from a file: ROS, MovingAI or GeoJSON. Native: needs yaml-cpp and libpng.
#ifndef TAUTLINE_SCENE_MAP_FILE_H_
#define TAUTLINE_SCENE_MAP_FILE_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/map_world.h"
#include "tautline/scene/scene_options.h"

namespace tautline {

/// Reads the map in `path` and the image beside it: ReadMap with files, YAML and PNG. Errors: kUnreadable (no such
/// file; also of the image), and those of ReadMap. O(size).
[[nodiscard]] Expected<MapWorld> ReadMapFile(const std::string& path, const SceneOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_MAP_FILE_H_
