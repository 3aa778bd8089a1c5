#include "tautline/scene/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/scene/check_tether.h"
#include "tautline/scene/field_reader.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// How far the probabilities of futures may sum past or short of 1: the rounding of their decimal texts.
constexpr double kProbabilityTolerance = 1e-9;

class SceneReader {
 public:
  SceneReader(const std::string& file, const MapLoader& load_map) : load_map_(load_map), reader_(file) {
    scene_.path = file;
  }

  Expected<Scene> Run(const Document& document) {
    if (reader_.IsMap(document, "a scene")) ReadAll(document);
    if (!reader_.ok()) return tl::unexpected<Error>(reader_.error());
    return std::move(scene_);
  }

 private:
  void ReadAll(const Document& document) {
    RefuseMap(document);
    reader_.KnownKeys(document, "the scene",
                      {"world", "tether", "robot", "goal", "cables", "tasks", "max_boundary", "futures", "fleet"});
    RequireWorld(document);
    if (const Document* value = document.Find("world")) scene_.world = ReadWorld(*value, reader_, load_map_);
    same_m_ = SamePointTolerance(BoundingBox(scene_.world.outline));
    if (const Document* value = document.Find("tether")) ReadTether(*value);
    if (const Document* value = document.Find("robot")) ReadRobot(*value);
    if (const Document* value = document.Find("goal")) scene_.goal = reader_.ReadPoint(*value, "goal");
    if (const Document* value = document.Find("cables")) ReadCables(*value);
    if (const Document* value = document.Find("tasks")) scene_.tasks = reader_.ReadPoints(*value, "tasks", 0);
    if (const Document* value = document.Find("max_boundary")) {
      scene_.max_boundary = reader_.ReadPositive(*value, "max_boundary");
    }
    if (const Document* value = document.Find("futures")) ReadFutures(*value);
    if (const Document* value = document.Find("fleet")) ReadFleet(*value);
  }

  /// A map given in the place of a scene gets an answer of its own.
  void RefuseMap(const Document& document) {
    const bool ros = document.Find("image") != nullptr && document.Find("resolution") != nullptr;
    const bool geojson = document.Find("type") != nullptr && document.Find("features") != nullptr;
    if (!ros && !geojson) return;
    reader_.Fail(document.position, "this is a map, not a scene: write a scene with 'world: {map: " +
                                        scene_.path.substr(scene_.path.find_last_of('/') + 1) + "}'");
  }

  void RequireWorld(const Document& document) {
    if (document.Find("world") != nullptr) return;
    for (const std::string_view key : {"tether", "robot", "goal", "cables", "tasks", "futures"}) {
      if (document.Find(key) == nullptr) continue;
      reader_.Fail(document.Find(key)->position,
                   "the scene has '" + std::string(key) + "' but no 'world': add one with an outline or a map");
    }
    if (document.Find("fleet") == nullptr) reader_.Fail(document.position, "the scene has neither 'world' nor 'fleet'");
  }

  /// Makes `given` the point that it must be; an error when it is another one.
  void Join(Point& given, Point wanted, Position at, const std::string& what) {
    if (!reader_.ok()) return;
    if (Distance(given, wanted) > same_m_) {
      return reader_.Fail(at, what + " at " + ToText(wanted) + ", not at " + ToText(given));
    }
    given = wanted;
  }

  void ReadTether(const Document& value) {
    if (!reader_.IsMap(value, "tether")) return;
    reader_.KnownKeys(value, "tether", {"base", "length", "laid"});
    Tether tether;
    if (const Document* base = reader_.Required(value, "tether", "base")) {
      tether.base = reader_.ReadPoint(*base, "tether.base");
    }
    if (const Document* length = reader_.Required(value, "tether", "length")) {
      tether.length = reader_.ReadNonNegative(*length, "tether.length");
    }
    if (const Document* laid = value.Find("laid")) {
      tether.laid = reader_.ReadPoints(*laid, "tether.laid", 1);
      if (reader_.ok()) Join(tether.laid->front(), tether.base, laid->position, "tether.laid must start at the base,");
    }
    scene_.tether = std::move(tether);
  }

  void ReadRobot(const Document& value) {
    if (!reader_.IsMap(value, "robot")) return;
    reader_.KnownKeys(value, "robot", {"radius", "heading"});
    if (const Document* radius = value.Find("radius")) {
      scene_.robot.radius = reader_.ReadPositive(*radius, "robot.radius");
    }
    if (const Document* heading = value.Find("heading")) {
      scene_.robot.heading = reader_.ReadNumber(*heading, "robot.heading");
    }
  }

  void ReadCables(const Document& value) {
    if (!reader_.IsMap(value, "cables")) return;
    reader_.KnownKeys(value, "cables", {"anchors", "laid", "words"});
    Cables cables;
    if (const Document* anchors = reader_.Required(value, "cables", "anchors")) {
      cables.anchors = reader_.ReadPoints(*anchors, "cables.anchors", 3);
    }
    if (const Document* laid = value.Find("laid")) cables.laid = ReadLaidCables(*laid, cables.anchors);
    if (const Document* words = value.Find("words")) {
      if (cables.laid) reader_.Fail(words->position, "cables has both laid and words: give one of them");
      cables.words = ReadSideWords(*words, cables.anchors.size());
    }
    scene_.cables = std::move(cables);
  }

  /// One polyline per anchor, all from one point, the robot, to their anchors.
  std::vector<Polyline> ReadLaidCables(const Document& value, const std::vector<Point>& anchors) {
    const std::string what = "cables.laid";
    std::vector<Polyline> cables;
    if (!reader_.IsList(value, what)) return cables;
    if (value.items.size() != anchors.size()) {
      reader_.Fail(value.position, what + " has " + std::to_string(value.items.size()) + " cables for " +
                                       std::to_string(anchors.size()) + " anchors: it needs one per anchor");
    }
    for (std::size_t i = 0; i < value.items.size() && reader_.ok(); ++i) {
      const Document& item = value.items[i];
      cables.push_back(reader_.ReadPoints(item, Element(what, i), 2));
      if (!reader_.ok()) break;
      Join(cables[i].front(), cables[0].front(), item.position, Element(what, i) + " must start at the robot,");
      Join(cables[i].back(), anchors[i], item.position, Element(what, i) + " must end at its anchor,");
    }
    return cables;
  }

  /// One word per anchor, each a text "a b^-1" or a list of letters ["a", "b^-1"].
  std::vector<std::string> ReadSideWords(const Document& value, std::size_t anchors) {
    const std::string what = "cables.words";
    std::vector<std::string> words;
    if (!reader_.IsList(value, what)) return words;
    if (value.items.size() != anchors) {
      reader_.Fail(value.position, what + " has " + std::to_string(value.items.size()) + " words for " +
                                       std::to_string(anchors) +
                                       " anchors: it needs one per anchor, from it to the next");
    }
    for (std::size_t i = 0; i < value.items.size() && reader_.ok(); ++i) {
      words.push_back(ReadWordText(value.items[i], Element(what, i)));
    }
    return words;
  }

  std::string ReadWordText(const Document& value, const std::string& what) {
    if (value.is(Document::Kind::kString)) return value.text;
    std::string text;
    if (!reader_.IsList(value, what)) return text;
    for (std::size_t i = 0; i < value.items.size() && reader_.ok(); ++i) {
      text += (i > 0 ? " " : "") + reader_.ReadText(value.items[i], Element(what, i));
    }
    return text;
  }

  void ReadFutures(const Document& value) {
    if (!reader_.IsList(value, "futures")) return;
    double sum = 0;
    for (std::size_t i = 0; i < value.items.size() && reader_.ok(); ++i) {
      scene_.futures.push_back(ReadFuture(value.items[i], Element("futures", i)));
      sum += scene_.futures.back().probability;
    }
    if (reader_.ok() && std::fabs(sum - 1) > kProbabilityTolerance) {
      reader_.Fail(value.position,
                   "the probabilities of the futures sum to " + FormatNumber(sum) + ": they must sum to 1");
    }
  }

  Future ReadFuture(const Document& value, const std::string& what) {
    Future future;
    if (!reader_.IsMap(value, what)) return future;
    reader_.KnownKeys(value, what, {"probability", "moves"});
    if (const Document* probability = reader_.Required(value, what, "probability")) {
      future.probability = reader_.ReadNonNegative(*probability, what + ".probability");
    }
    const Document* moves = reader_.Required(value, what, "moves");
    if (moves == nullptr || !reader_.IsList(*moves, what + ".moves")) return future;
    for (std::size_t i = 0; i < moves->items.size() && reader_.ok(); ++i) {
      future.moves.push_back(ReadMove(moves->items[i], Element(what + ".moves", i)));
    }
    return future;
  }

  ObstacleMove ReadMove(const Document& value, const std::string& what) {
    ObstacleMove move;
    if (!reader_.IsMap(value, what)) return move;
    reader_.KnownKeys(value, what, {"obstacle", "path"});
    if (const Document* obstacle = reader_.Required(value, what, "obstacle")) {
      move.obstacle = reader_.ReadText(*obstacle, what + ".obstacle");
      if (reader_.ok()) CheckObstacle(move.obstacle, obstacle->position);
    }
    if (const Document* path = reader_.Required(value, what, "path")) {
      move.path = reader_.ReadPoints(*path, what + ".path", 2);
    }
    return move;
  }

  void CheckObstacle(const std::string& name, Position at) {
    std::vector<std::string_view> names;
    for (const Obstacle& obstacle : scene_.world.obstacles) names.push_back(obstacle.name);
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    const std::string_view nearest = NearestName(name, names);
    reader_.Fail(
        at, "there is no obstacle " + Quoted(name) +
                (nearest.empty() ? ": name one of world.obstacles" : ": did you mean '" + std::string(nearest) + "'?"));
  }

  void ReadFleet(const Document& value) {
    if (!reader_.IsMap(value, "fleet")) return;
    reader_.KnownKeys(value, "fleet", {"speed", "radius", "tether", "robots"});
    FleetRobot common;
    ReadBody(value, "fleet", common);
    Fleet fleet;
    const Document* robots = reader_.Required(value, "fleet", "robots");
    if (robots != nullptr && reader_.IsList(*robots, "fleet.robots")) {
      if (robots->items.empty()) reader_.Fail(robots->position, "fleet.robots is empty: list a robot");
      for (std::size_t i = 0; i < robots->items.size() && reader_.ok(); ++i) {
        fleet.robots.push_back(ReadRobot(robots->items[i], i, common));
      }
      CheckRobotNames(fleet, *robots);
    }
    scene_.fleet = std::move(fleet);
  }

  /// What a robot may say of itself and the fleet of all its robots.
  void ReadBody(const Document& value, const std::string& what, FleetRobot& robot) {
    if (const Document* speed = value.Find("speed")) robot.speed = reader_.ReadPositive(*speed, what + ".speed");
    if (const Document* radius = value.Find("radius"))
      robot.radius = reader_.ReadNonNegative(*radius, what + ".radius");
    if (const Document* tether = value.Find("tether"))
      robot.tether = reader_.ReadNonNegative(*tether, what + ".tether");
  }

  FleetRobot ReadRobot(const Document& value, std::size_t index, const FleetRobot& common) {
    const std::string what = Element("fleet.robots", index);
    FleetRobot robot = common;
    if (!reader_.IsMap(value, what)) return robot;
    reader_.KnownKeys(value, what, {"name", "start", "target", "cable", "speed", "radius", "tether"});
    const Document* name = value.Find("name");
    robot.name = name != nullptr ? reader_.ReadName(*name, what + ".name") : "r" + std::to_string(index + 1);
    if (const Document* start = reader_.Required(value, what, "start")) {
      robot.start = reader_.ReadPoint(*start, what + ".start");
    }
    if (const Document* target = reader_.Required(value, what, "target")) {
      robot.target = reader_.ReadPoint(*target, what + ".target");
    }
    ReadBody(value, what, robot);
    if (reader_.ok() && robot.speed == 0) {
      reader_.Fail(value.position, what + " has no speed: add 'speed' to the robot or to the fleet");
    }
    if (const Document* cable = value.Find("cable")) robot.cable = ReadRobotCable(*cable, what + ".cable", robot);
    return robot;
  }

  Polyline ReadRobotCable(const Document& value, const std::string& what, const FleetRobot& robot) {
    Polyline cable = reader_.ReadPoints(value, what, 2);
    if (!reader_.ok()) return cable;
    Join(cable.front(), robot.start, value.position, what + " must begin at the start,");
    Join(cable.back(), robot.target, value.position, what + " must end at the target,");
    return cable;
  }

  void CheckRobotNames(const Fleet& fleet, const Document& robots) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < fleet.robots.size(); ++i) {
      if (names.insert(fleet.robots[i].name).second) continue;
      reader_.Fail(robots.items[i].position, "two robots are named " + Quoted(fleet.robots[i].name) + ": rename one");
    }
  }

  const MapLoader& load_map_;
  FieldReader reader_;
  Scene scene_;
  double same_m_ = 0;
};

}  // namespace

Expected<Scene> ReadScene(const Document& document, const std::string& file, const MapLoader& load_map) {
  return SceneReader(file, load_map).Run(document);
}

}  // namespace tautline
