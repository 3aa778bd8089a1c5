#include "tautline/scene/scene_file.h"

#include <cmath>
#include <filesystem>
#include <string_view>

#include "tautline/scene/document.h"
#include "tautline/scene/json_document.h"
#include "tautline/scene/map_file.h"
#include "tautline/scene/scene_reader.h"
#include "tautline/scene/text_file.h"
#include "tautline/scene/yaml_document.h"

namespace tautline {
namespace {

/// JSON is a map in braces; YAML in braces is nearly always JSON too, but only `.json` and pure JSON text say so.
bool LooksLikeJson(const std::string& path, std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool braces = first != std::string_view::npos && text[first] == '{';
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".json" || (braces && extension != ".yaml" && extension != ".yml");
}

/// A name that only maps have: ROS map YAML files cannot be told by theirs.
bool IsMapName(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".map" || extension == ".pgm" || extension == ".png" || extension == ".geojson";
}

}  // namespace

Expected<Scene> ReadSceneFile(const std::string& path, const SceneOptions& options) {
  if (!(options.simplify >= 0) || !std::isfinite(options.simplify)) {
    return InvalidInput("must be a length in metres, 0 or more", "--simplify");
  }
  if (IsMapName(path)) {
    return InvalidInput(
        "this is a map, not a scene; write a scene file that names it, a ROS map by its YAML: "
        "`world: {map: FILE}`",
        path);
  }
  const auto text = ReadTextFile(path, kMaxDocumentBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  const auto document = LooksLikeJson(path, *text) ? ParseJson(*text, path) : ParseYaml(*text, path);
  if (!document) return tl::unexpected<Error>(document.error());
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return ReadScene(*document, path, [&folder, &options](const std::string& name) {
    return ReadMapFile((folder / name).string(), options);
  });
}

}  // namespace tautline
