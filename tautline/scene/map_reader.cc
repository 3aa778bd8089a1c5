#include "tautline/scene/map_reader.h"

#include <filesystem>
#include <utility>

#include "tautline/scene/geojson.h"
#include "tautline/scene/json_document.h"
#include "tautline/scene/movingai_map.h"
#include "tautline/scene/number_fault.h"
#include "tautline/scene/pgm.h"
#include "tautline/scene/ros_map.h"

namespace tautline {
namespace {

/// Images and grids as text: a value of a plain PGM takes up to six bytes.
constexpr std::size_t kMaxMapBytes = std::size_t{512} << 20;

tl::unexpected<Error> Unsupported(std::string message, const std::string& where) {
  return tl::unexpected<Error>(Error{ErrorCode::kUnsupported, std::move(message), where});
}

std::string LowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

/// PNG is told by its first byte, everything else must be a PGM.
Expected<RasterImage> ReadImage(const std::string& path, const MapSources& sources) {
  return sources.read(path, kMaxMapBytes).and_then([&](const std::string& bytes) {
    return !bytes.empty() && bytes[0] == '\x89' ? sources.parse_png(bytes, path) : ParsePgm(bytes, path);
  });
}

Expected<MapWorld> WorldOfKind(const char* kind, OccupancyGrid grid, const std::string& path,
                               const SceneOptions& options) {
  auto world = WorldFromGrid(std::move(grid), options);
  if (!world) return tl::unexpected<Error>(Error{world.error().code, world.error().message, path});
  world->source.kind = kind;
  return world;
}

Expected<MapWorld> ReadRosMap(const std::string& path, const MapSources& sources, const SceneOptions& options) {
  const auto text = sources.read(path, kMaxDocumentBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  const auto settings = sources.parse_settings(*text, path).and_then([&path](const Document& document) {
    return ReadRosMapSettings(document, path);
  });
  if (!settings) return tl::unexpected<Error>(settings.error());
  const auto image = ReadImage((std::filesystem::path(path).parent_path() / settings->image).string(), sources);
  if (!image) return tl::unexpected<Error>(image.error());
  OccupancyGrid grid = GridFromRosImage(*image, *settings);
  if (const auto fault = PointsFault(GridOutline(grid))) {
    return tl::unexpected<Error>(Error{fault->code, "corner " + fault->text + "; see origin and resolution", path});
  }
  return WorldOfKind("ros", std::move(grid), path, options);
}

Expected<MapWorld> ReadMovingAiMap(const std::string& path, const MapSources& sources, const SceneOptions& options) {
  const auto text = sources.read(path, kMaxMapBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return ParseMovingAiMap(*text, path).and_then([&](OccupancyGrid grid) {
    return WorldOfKind("movingai", std::move(grid), path, options);
  });
}

Expected<MapWorld> ReadGeoJsonMap(const std::string& path, const MapSources& sources) {
  const auto text = sources.read(path, kMaxDocumentBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return ParseJson(*text, path).and_then([&path](const Document& document) { return ReadGeoJson(document, path); });
}

}  // namespace

Expected<MapWorld> ReadMap(const std::string& path, const MapSources& sources, const SceneOptions& options) {
  const std::string extension = LowerExtension(path);
  if (extension == ".yaml" || extension == ".yml") return ReadRosMap(path, sources, options);
  if (extension == ".map") return ReadMovingAiMap(path, sources, options);
  if (extension == ".geojson" || extension == ".json") return ReadGeoJsonMap(path, sources);
  if (extension == ".pgm" || extension == ".png") {
    const std::string yaml = std::filesystem::path(path).stem().string() + ".yaml";
    return Unsupported("an image alone has no scale: name its ROS map YAML (such as " + yaml + ") instead", path);
  }
  return Unsupported("not a map that tautline reads: use a ROS .yaml, a MovingAI .map or a .geojson", path);
}

}  // namespace tautline
