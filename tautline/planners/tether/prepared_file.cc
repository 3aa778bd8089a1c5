#include "tautline/planners/tether/prepared_file.h"

#include <boost/crc.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tautline/base/double_bits.h"
#include "tautline/planners/tether/prepared_check.h"
#include "tautline/scene/world_digest.h"

namespace tautline {
namespace {

using Json = nlohmann::json;

/// Raised whenever what is written, or what it means, changes.
constexpr int kVersion = 1;
constexpr std::string_view kName = "tautline prepared world, version ";

std::uint32_t Checksum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

/// Bytes of integers, least first.
class Packer {
 public:
  void Add(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) bytes_.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void Add(double value) { Add(DoubleBits(value), 8); }

  Json Take() { return Json::binary(std::move(bytes_)); }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Reads what Packer wrote; throws std::out_of_range at the end.
class Unpacker {
 public:
  explicit Unpacker(const Json& json) : bytes_(json.get_binary()) {}

  std::uint64_t Take(int bytes) {
    std::uint64_t value = 0;
    for (int i = 0; i < bytes; ++i) value |= std::uint64_t{bytes_.at(at_++)} << (8 * i);
    return value;
  }
  double TakeDouble() { return DoubleOfBits(Take(8)); }

  bool done() const { return at_ == bytes_.size(); }

 private:
  const Json::binary_t& bytes_;
  std::size_t at_ = 0;
};

/// Lets through CBOR of the shape that Write gives it: not so deep that reading it exhausts the stack, nor of so many
/// values that it exhausts the memory.
class ShapeCheck : public nlohmann::json_sax<Json> {
 public:
  bool null() override { return Count(); }
  bool boolean(bool) override { return Count(); }
  bool number_integer(number_integer_t) override { return Count(); }
  bool number_unsigned(number_unsigned_t) override { return Count(); }
  bool number_float(number_float_t, const string_t&) override { return Count(); }
  bool string(string_t& text) override { return Count() && IsText(text); }
  bool binary(binary_t&) override { return Count(); }
  bool start_object(std::size_t) override { return Count() && ++depth_ <= kDeepest; }
  bool key(string_t& text) override { return Count() && IsText(text); }
  bool end_object() override { return --depth_, true; }
  bool start_array(std::size_t) override { return Count() && ++depth_ <= kDeepest; }
  bool end_array() override { return --depth_, true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  static constexpr int kDeepest = 16;
  static constexpr std::int64_t kMostValues = 64'000'000;

  bool Count() { return ++values_ <= kMostValues; }

  /// Text that is not UTF-8 could not be printed in an answer.
  static bool IsText(const std::string& text) {
    static_cast<void>(Json(text).dump());  // Throws Json::exception.
    return true;
  }

  int depth_ = 0;
  std::int64_t values_ = 0;
};

Json ToJson(Point p) { return Json::array({p.x, p.y}); }
Point ToPoint(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

Json ToJson(const Box& box) { return Json::array({ToJson(box.low), ToJson(box.high)}); }

Json ToJson(const BoundaryRing& ring) {
  Packer points;
  for (const Point p : ring.points) {
    points.Add(p.x);
    points.Add(p.y);
  }
  return {{"points", points.Take()}, {"obstacle", ring.obstacle.value()}};
}

BoundaryRing ToRing(const Json& json) {
  BoundaryRing ring;
  Unpacker points(json.at("points"));
  while (!points.done()) {
    const double x = points.TakeDouble();
    ring.points.push_back({x, points.TakeDouble()});
  }
  ring.obstacle = ObstacleId(json.at("obstacle").get<std::int32_t>());
  return ring;
}

Json ToJson(const FreeComponent& component) {
  Json json = {{"outer", ToJson(component.outer)}, {"holes", Json::array()}, {"area", component.area}};
  for (const BoundaryRing& hole : component.holes) json["holes"].push_back(ToJson(hole));
  return json;
}

FreeComponent ToComponent(const Json& json) {
  FreeComponent component{ToRing(json.at("outer")), {}, json.at("area").get<double>()};
  for (const Json& hole : json.at("holes")) component.holes.push_back(ToRing(hole));
  return component;
}

Json ToJson(const FreeSpace& space) {
  Json json = {{"components", Json::array()}, {"islands", Json::array()}, {"merges", Json::array()},
               {"snaps", Json::array()},      {"box", ToJson(space.box)}, {"clearance", space.clearance},
               {"snap", space.snap},          {"grid", space.grid}};
  for (const FreeComponent& component : space.components) json["components"].push_back(ToJson(component));
  for (const Island& island : space.islands) {
    json["islands"].push_back({{"name", island.name},
                               {"representative", ToJson(island.representative)},
                               {"members", island.members},
                               {"area", island.area}});
  }
  for (const Merge& merge : space.merges) {
    json["merges"].push_back({{"members", merge.members}, {"with_wall", merge.with_wall}});
  }
  for (const Snap& snap : space.snaps) {
    json["snaps"].push_back(
        {{"obstacle", snap.obstacle}, {"from", ToJson(snap.from)}, {"to", ToJson(snap.to)}, {"onto", snap.onto}});
  }
  return json;
}

FreeSpace ToFreeSpace(const Json& json) {
  FreeSpace space;
  for (const Json& component : json.at("components")) space.components.push_back(ToComponent(component));
  for (const Json& island : json.at("islands")) {
    space.islands.push_back({island.at("name").get<std::string>(), ToPoint(island.at("representative")),
                             island.at("members").get<std::vector<std::string>>(), island.at("area").get<double>()});
  }
  for (const Json& merge : json.at("merges")) {
    space.merges.push_back({merge.at("members").get<std::vector<std::string>>(), merge.at("with_wall").get<bool>()});
  }
  for (const Json& snap : json.at("snaps")) {
    space.snaps.push_back({snap.at("obstacle").get<std::string>(), ToPoint(snap.at("from")), ToPoint(snap.at("to")),
                           snap.at("onto").get<std::string>()});
  }
  space.box.low = ToPoint(json.at("box").at(0));
  space.box.high = ToPoint(json.at("box").at(1));
  space.clearance = json.at("clearance").get<double>();
  space.snap = json.at("snap").get<double>();
  space.grid = json.at("grid").get<double>();
  CheckPreparedSpace(space);
  return space;
}

Json ToJson(const SightList& sight) {
  Packer counts, sightings;
  for (const std::int32_t count : sight.counts) counts.Add(static_cast<std::uint64_t>(count), 4);
  for (const Sighting& sighting : sight.sightings) {
    sightings.Add(static_cast<std::uint64_t>(sighting.corner.value()), 4);
    sightings.Add(static_cast<std::uint64_t>(sighting.tail), 1);
    sightings.Add(static_cast<std::uint64_t>(sighting.head), 1);
  }
  return {{"counts", counts.Take()}, {"sightings", sightings.Take()}};
}

SightList ToSightList(const Json& json) {
  SightList sight;
  Unpacker counts(json.at("counts")), sightings(json.at("sightings"));
  while (!counts.done()) sight.counts.push_back(static_cast<std::int32_t>(counts.Take(4)));
  while (!sightings.done()) {
    const CornerId corner(static_cast<std::int32_t>(sightings.Take(4)));
    const auto tail = static_cast<Side>(sightings.Take(1));
    sight.sightings.push_back({corner, tail, static_cast<Side>(sightings.Take(1))});
  }
  CheckPreparedSight(sight);
  return sight;
}

}  // namespace

std::string PreparedFile::Write(const TetherPlanner& planner, const World& world) {
  Json json = {{"world", WorldDigest(world)},
               {"free_space", ToJson(planner.space().free_space())},
               {"sight", ToJson(planner.space().graph().sight())}};
  if (planner.ground_.has_clearance()) json["ungrown"] = ToJson(planner.ungrown_space());
  std::string body;
  Json::to_cbor(json, body);
  return std::string(kName) + std::to_string(kVersion) + "\n" + std::to_string(Checksum(body)) + "\n" + body;
}

Expected<TetherPlanner> PreparedFile::Read(std::string_view bytes, const World& world) {
  if (!bytes.starts_with(kName)) return InvalidInput("not a prepared map: make one with --save-prepared");
  bytes.remove_prefix(kName.size());
  const std::string version = std::to_string(kVersion) + "\n";
  if (!bytes.starts_with(version)) {
    return InvalidInput("a prepared map of another version of tautline: make it anew with --save-prepared");
  }
  bytes.remove_prefix(version.size());
  const auto damaged = [] { return InvalidInput("the prepared map is damaged: make it anew with --save-prepared"); };
  const std::size_t line = bytes.find('\n');
  if (line == std::string_view::npos) return damaged();
  const std::string_view body = bytes.substr(line + 1);
  if (bytes.substr(0, line) != std::to_string(Checksum(body))) return damaged();
  // The checksum guards against accidents; what else may be wrong with the content, the checks of mesh and graph find.
  try {
    ShapeCheck check;
    if (!Json::sax_parse(body, &check, Json::input_format_t::cbor)) return damaged();
    const Json json = Json::from_cbor(body);
    if (json.at("world").get<std::uint64_t>() != WorldDigest(world)) {
      return InvalidInput(
          "the prepared map was made for another world, or for the same one with another clearance or other options: "
          "make it anew with --save-prepared");
    }
    auto space = std::make_unique<const TautSpace>(ToFreeSpace(json.at("free_space")), ToSightList(json.at("sight")));
    std::optional<FreeSpace> ungrown;
    if (json.contains("ungrown")) ungrown = ToFreeSpace(json.at("ungrown"));
    return TetherPlanner(TautGround(std::move(space), std::move(ungrown)));
  } catch (const Json::exception&) {
    return damaged();
  } catch (const std::logic_error&) {
    return damaged();
  }
}

}  // namespace tautline
