#include "tautline/scene/geojson.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "tautline/scene/field_reader.h"
#include "tautline/scene/ring_check.h"

namespace tautline {
namespace {

using Kind = Document::Kind;

enum class Role { kObstacle, kOutline, kIgnore };

/// One polygon as it stands in the file.
struct Piece {
  PolygonWithHoles polygon;
  std::string name;
  Role role = Role::kObstacle;
  Position position;
};

std::string TextOf(const Document& map, std::string_view key) {
  const Document* value = map.Find(key);
  return value != nullptr && value->is(Kind::kString) ? value->text : "";
}

/// A name that can stand in a word.
std::string WordName(std::string name) {
  for (char& c : name) c = c == '^' || c == 0x7f || static_cast<unsigned char>(c) <= ' ' ? '_' : c;
  return name;
}

/// Gathers the polygons of all features.
class Collector {
 public:
  explicit Collector(FieldReader& reader) : reader_(reader) {}

  void Collect(const Document& object) {
    if (!reader_.IsMap(object, "a GeoJSON object")) return;
    const std::string type = TextOf(object, "type");
    if (type == "FeatureCollection") {
      const Document* features = reader_.Required(object, "the FeatureCollection", "features");
      if (features == nullptr || !reader_.IsList(*features, "features")) return;
      for (const Document& feature : features->items) CollectFeature(feature);
    } else if (type == "Feature") {
      CollectFeature(object);
    } else {
      CollectGeometry(object, {});
    }
  }

  std::vector<Piece> pieces;
  std::size_t skipped = 0;

 private:
  void CollectFeature(const Document& feature) {
    if (!reader_.ok() || !reader_.IsMap(feature, "a feature")) return;
    Piece meta;
    const Document* properties = feature.Find("properties");
    if (properties != nullptr && properties->is(Kind::kMap)) {
      meta.name = WordName(TextOf(*properties, "name"));
      meta.role = ReadRole(*properties);
    }
    const Document* geometry = reader_.Required(feature, "the feature", "geometry");
    if (geometry == nullptr || geometry->is(Kind::kNull) || meta.role == Role::kIgnore) {
      ++skipped;
      return;
    }
    CollectGeometry(*geometry, meta);
  }

  Role ReadRole(const Document& properties) {
    const Document* role = properties.Find("role");
    if (role == nullptr || role->is(Kind::kNull)) {
      const std::string type = TextOf(properties, "type");
      return type == "building_outline" ? Role::kOutline : type == "door" ? Role::kIgnore : Role::kObstacle;
    }
    const std::string name = reader_.ReadText(*role, "role");
    if (name == "outline") return Role::kOutline;
    if (name == "ignore") return Role::kIgnore;
    if (name != "obstacle") {
      reader_.Fail(role->position, "role is " + Quoted(name) + ": it must be outline, obstacle or ignore");
    }
    return Role::kObstacle;
  }

  void CollectGeometry(const Document& geometry, const Piece& meta) {
    if (!reader_.ok() || !reader_.IsMap(geometry, "a geometry")) return;
    const std::string type = TextOf(geometry, "type");
    if (type == "GeometryCollection") {
      const Document* members = reader_.Required(geometry, "the GeometryCollection", "geometries");
      if (members == nullptr || !reader_.IsList(*members, "geometries")) return;
      for (const Document& member : members->items) CollectGeometry(member, meta);
      return;
    }
    if (type == "Polygon" || type == "MultiPolygon") return CollectPolygons(geometry, type, meta);
    for (const std::string_view other : {"Point", "MultiPoint", "LineString", "MultiLineString"}) {
      if (type == other) {
        ++skipped;
        return;
      }
    }
    reader_.Fail(geometry.position, "not GeoJSON: the object has no 'type' of RFC 7946");
  }

  void CollectPolygons(const Document& geometry, const std::string& type, const Piece& meta) {
    const Document* coordinates = reader_.Required(geometry, "the " + type, "coordinates");
    if (coordinates == nullptr || !reader_.IsList(*coordinates, "coordinates")) return;
    if (type == "Polygon") return CollectPolygon(*coordinates, meta);
    for (const Document& polygon : coordinates->items) CollectPolygon(polygon, meta);
  }

  void CollectPolygon(const Document& rings, const Piece& meta) {
    if (!reader_.ok() || !reader_.IsList(rings, "the coordinates of a polygon")) return;
    Piece piece = meta;
    piece.position = rings.position;
    for (const Document& coordinates : rings.items) {
      Ring ring = ReadRing(coordinates);
      if (&coordinates == &rings.items.front()) {
        piece.polygon.outer = std::move(ring);
      } else if (HasArea(ring)) {
        piece.polygon.holes.push_back(std::move(ring));
      }
    }
    if (!HasArea(piece.polygon.outer)) {
      ++skipped;
      return;
    }
    pieces.push_back(std::move(piece));
  }

  Ring ReadRing(const Document& coordinates) {
    Ring ring;
    if (!reader_.ok() || !reader_.IsList(coordinates, "a ring")) return ring;
    for (const Document& position : coordinates.items) {
      reader_.CountPoint(position.position);
      if (!position.is(Kind::kList) || position.items.size() < 2) {
        reader_.Fail(position.position,
                     "a position must be [x, y] or [longitude, latitude], not " + Describe(position));
        return ring;
      }
      ring.push_back({reader_.ReadNumber(position.items[0], "x"), reader_.ReadNumber(position.items[1], "y")});
    }
    return WithoutRepeats(ring);
  }

  FieldReader& reader_;
};

template <class Change>
void ForEachPoint(std::vector<Piece>& pieces, Change change) {
  for (Piece& piece : pieces) {
    for (Point& p : piece.polygon.outer) p = change(p);
    for (Ring& hole : piece.polygon.holes) {
      for (Point& p : hole) p = change(p);
    }
  }
}

Box BoxOf(const std::vector<Piece>& pieces) {
  Box box;
  for (const Piece& piece : pieces) {
    for (const Point p : piece.polygon.outer) box.Add(p);
  }
  return box;
}

/// The name in the `crs` member; empty without one.
std::string CrsName(const Document& document) {
  const Document* crs = document.Find("crs");
  if (crs == nullptr || !crs->is(Kind::kMap)) return "";
  const Document* properties = crs->Find("properties");
  return properties != nullptr && properties->is(Kind::kMap) ? TextOf(*properties, "name") : "";
}

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool IsGeographic(const Document& document, const Box& box) {
  const std::string name = CrsName(document);
  if (!name.empty()) {
    return EndsWith(name, "CRS84") || EndsWith(name, "EPSG:4326") || EndsWith(name, "EPSG::4326");
  }
  constexpr double kSiteDegrees = 0.5;
  const bool in_range = box.low.x >= -180 && box.high.x <= 180 && box.low.y >= -90 && box.high.y <= 90;
  return in_range && box.size().x < kSiteDegrees && box.size().y < kSiteDegrees;
}

/// Metres per degree of longitude (x) and latitude (y) at a latitude, from the WGS84 radii of curvature.
Point MetresPerDegree(double latitude_degrees) {
  constexpr double kSemiMajor = 6378137.0, kFlattening = 1 / 298.257223563;
  constexpr double kSquaredEccentricity = kFlattening * (2 - kFlattening);
  constexpr double kRadians = std::numbers::pi / 180;
  const double sine = std::sin(latitude_degrees * kRadians), cosine = std::cos(latitude_degrees * kRadians);
  const double w = std::sqrt(1 - kSquaredEccentricity * sine * sine);
  return {kRadians * cosine * kSemiMajor / w, kRadians * kSemiMajor * (1 - kSquaredEccentricity) / (w * w * w)};
}

/// Turns longitude and latitude into local metres; the origin goes into `source`.
void Project(std::vector<Piece>& pieces, const Box& box, Position at, FieldReader& reader, MapSource& source) {
  constexpr double kWidestDegrees = 5, kHighestLatitude = 89;
  const Point centre = box.centre();
  if (box.size().x > kWidestDegrees || box.size().y > kWidestDegrees || std::fabs(centre.y) > kHighestLatitude) {
    return reader.Fail(at,
                       "longitude and latitude span more than 5 degrees or reach a pole: project the map to metres "
                       "and name its crs",
                       ErrorCode::kUnsupported);
  }
  const Point scale = MetresPerDegree(centre.y);
  ForEachPoint(pieces, [=](Point p) { return Point{(p.x - centre.x) * scale.x, (p.y - centre.y) * scale.y}; });
  source.geographic = true;
  source.origin = centre;
}

void CheckPieces(const std::vector<Piece>& pieces, FieldReader& reader) {
  for (const Piece& piece : pieces) {
    if (!reader.ok()) return;
    reader.Check(RingFault(piece.polygon.outer), piece.position, "the polygon");
    for (const Ring& hole : piece.polygon.holes) {
      reader.Check(RingFault(hole), piece.position, "a hole of the polygon");
    }
    if (reader.ok()) reader.Check(HolesFault(piece.polygon), piece.position, "the polygon's");
  }
}

/// The bounding box grown by 10 % of its larger side.
Ring GrownBox(const Box& box) {
  const double margin = 0.1 * std::max(box.size().x, box.size().y);
  const Point low = box.low - Point{margin, margin}, high = box.high + Point{margin, margin};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

void AddObstacle(PolygonWithHoles polygon, std::string name, MapWorld& world) {
  Obstacle obstacle;
  obstacle.polygon = std::move(polygon);
  obstacle.name = std::move(name);
  obstacle.from_map = true;
  world.obstacles.push_back(std::move(obstacle));
}

void FillWorld(std::vector<Piece> pieces, FieldReader& reader, MapWorld& world) {
  const Box box = BoxOf(pieces);
  for (Piece& piece : pieces) {
    if (piece.role == Role::kObstacle) {
      AddObstacle(std::move(piece.polygon), std::move(piece.name), world);
      continue;
    }
    if (!world.outline.empty()) {
      return reader.Fail(piece.position, "a second outline: one feature only may have the role 'outline'");
    }
    world.outline = std::move(piece.polygon.outer);
    for (Ring& hole : piece.polygon.holes) AddObstacle({std::move(hole), {}}, "", world);
  }
  if (world.outline.empty()) world.outline = GrownBox(box);
}

}  // namespace

Expected<MapWorld> ReadGeoJson(const Document& document, const std::string& file) {
  FieldReader reader(file);
  Collector collector(reader);
  collector.Collect(document);
  if (reader.ok() && collector.pieces.empty()) {
    reader.Fail(document.position, "the map holds no polygon with an area (" + std::to_string(collector.skipped) +
                                       " other features were skipped)");
  }
  MapWorld world;
  world.source.kind = "geojson";
  world.source.skipped_features = collector.skipped;
  const Box box = BoxOf(collector.pieces);
  if (reader.ok() && IsGeographic(document, box)) {
    Project(collector.pieces, box, document.position, reader, world.source);
  }
  if (reader.ok()) CheckPieces(collector.pieces, reader);
  if (reader.ok()) FillWorld(std::move(collector.pieces), reader, world);
  if (!reader.ok()) return tl::unexpected<Error>(reader.error());
  return world;
}

}  // namespace tautline
