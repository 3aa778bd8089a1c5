// A scene from a Document.
#ifndef TAUTLINE_SCENE_SCENE_READER_H_
#define TAUTLINE_SCENE_SCENE_READER_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"
#include "tautline/scene/scene.h"
#include "tautline/scene/world_reader.h"

namespace tautline {

/// Reads and checks a scene. `file` is its path and stands in the errors; `load_map` opens the map that the scene
/// names (absent: a scene with a map is an error). What is checked: every key is known; polygons and the outline have
/// an area and do not cross themselves; names are unique and can stand in words; sizes have the right sign; the
/// laid cable starts at the base, cable lines end where they must (to 1e-6 of the size of the world); futures name
/// obstacles that exist and their probabilities sum to 1. Whether base and goal are free is for planners to say.
/// Errors: kInvalidInput with "file:line", kLimitExceeded, and those of `load_map`. O(points log points).
[[nodiscard]] Expected<Scene> ReadScene(const Document& document, const std::string& file,
                                        const MapLoader& load_map = {});

}  // namespace tautline

#endif  // TAUTLINE_SCENE_SCENE_READER_H_
