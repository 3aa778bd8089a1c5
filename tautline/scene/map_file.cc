#include "tautline/scene/map_file.h"

#include "tautline/scene/map_reader.h"
#include "tautline/scene/png_gray.h"
#include "tautline/scene/text_file.h"
#include "tautline/scene/yaml_document.h"

namespace tautline {

Expected<MapWorld> ReadMapFile(const std::string& path, const SceneOptions& options) {
  return ReadMap(path, {.read = ReadTextFile, .parse_settings = ParseYaml, .parse_png = ParsePng}, options);
}

}  // namespace tautline
