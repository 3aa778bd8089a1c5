// The `world` of a scene.
#ifndef TAUTLINE_SCENE_WORLD_READER_H_
#define TAUTLINE_SCENE_WORLD_READER_H_

#include <functional>
#include <string>

#include "tautline/base/error.h"
#include "tautline/scene/document.h"
#include "tautline/scene/field_reader.h"
#include "tautline/scene/map_world.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// Opens the map of a scene by its name as it stands in the scene.
using MapLoader = std::function<Expected<MapWorld>(const std::string& name)>;

/// Reads the value of the key `world`: outline or map, obstacles with their names, clearance, snap. Obstacles without
/// a name are called after their position in the scene, o1, o2, ...; those of the map continue the count; a name that
/// is taken is passed over. Errors go to `reader`. O(points log points).
World ReadWorld(const Document& document, FieldReader& reader, const MapLoader& load_map);

}  // namespace tautline

#endif  // TAUTLINE_SCENE_WORLD_READER_H_
