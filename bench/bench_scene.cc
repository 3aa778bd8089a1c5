#include "bench/bench_scene.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "tautline/scene/json_document.h"
#include "tautline/scene/map_file.h"
#include "tautline/scene/scene_reader.h"
#include "tautline/scene/text_file.h"

namespace tautline {
namespace {

template <class T>
T ValueOf(Expected<T> expected) {
  if (!expected) throw std::runtime_error(ToString(expected.error()));
  return *std::move(expected);
}

}  // namespace

BenchScene ReadCdt2025(const std::string& name) {
  const std::string path = "scenes/maps/cdt2025/" + name + ".json";
  const auto data = nlohmann::json::parse(ValueOf(ReadTextFile(path, 10'000'000)));
  const Scene scene = ValueOf(ReadScene(ValueOf(ParseJson(data.at("scene").dump(), path)), path));
  BenchScene result{scene.world, scene.tether.value(), {}};
  for (const auto& expected : data.at("expected")) {
    result.goals.push_back({expected.at("goal").at(0).get<double>(), expected.at("goal").at(1).get<double>()});
  }
  return result;
}

BenchScene ReadMap(const std::string& path, double clearance) {
  MapWorld map = ValueOf(ReadMapFile(path));
  BenchScene scene;
  scene.world.outline = std::move(map.outline);
  scene.world.obstacles = std::move(map.obstacles);
  scene.world.clearance = clearance;
  return scene;
}

}  // namespace tautline
