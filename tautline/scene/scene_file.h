// A scene from a file, with its map. Native: needs yaml-cpp and libpng.
#ifndef TAUTLINE_SCENE_SCENE_FILE_H_
#define TAUTLINE_SCENE_SCENE_FILE_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/scene.h"
#include "tautline/scene/scene_options.h"

namespace tautline {

/// Reads the scene in `path` and the map it names, which is looked up beside the scene file. A name that ends in
/// `.json` is JSON, in `.yaml` or `.yml` YAML; any other is JSON when its text starts with `{`. Errors are one line,
/// with "file:line" where the fault has a place: kUnreadable (no such file), kLimitExceeded (64 MiB, and the limits of
/// the readers), kUnsupported, kInvalidInput. O(size of the files), apart from polygons, which are checked for
/// crossings in O(n log n) as a rule.
[[nodiscard]] Expected<Scene> ReadSceneFile(const std::string& path, const SceneOptions& options = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_SCENE_FILE_H_
