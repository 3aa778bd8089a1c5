#include "tautline/scene/geojson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/scene/json_document.h"
#include "tautline/scene/text_file.h"

namespace tautline {
namespace {

Expected<MapWorld> Read(std::string_view text) {
  return ParseJson(text, "m.geojson").and_then([](const Document& document) {
    return ReadGeoJson(document, "m.geojson");
  });
}

MapWorld Good(std::string_view text) {
  auto world = Read(text);
  EXPECT_TRUE(world) << ToString(world.error());
  return world.value_or(MapWorld{});
}

std::string ErrorOf(std::string_view text) {
  const auto world = Read(text);
  return world ? "no error" : ToString(world.error());
}

std::string Collection(const std::string& features, const std::string& more = "") {
  return R"({"type": "FeatureCollection")" + more + R"(, "features": [)" + features + "]}";
}

std::string Feature(const std::string& properties, const std::string& rings) {
  return R"({"type": "Feature", "properties": {)" + properties +
         R"(}, "geometry": {"type": "Polygon", "coordinates": )" + rings + "}}";
}

const std::string kRoom = "[[[0,0],[20,0],[20,10],[0,10],[0,0]]]";
const std::string kDesk = "[[[4,4],[6,4],[6,6],[4,6],[4,4]]]";

TEST(ReadGeoJson, RolesSayWhatAPolygonIs) {
  const MapWorld world =
      Good(Collection(Feature(R"("role": "outline")", kRoom) + "," + Feature(R"("name": "long desk")", kDesk) + "," +
                      Feature(R"("role": "ignore")", kDesk)));
  EXPECT_EQ(world.outline.size(), 4u);
  ASSERT_EQ(world.obstacles.size(), 1u);
  EXPECT_EQ(world.obstacles[0].name, "long_desk");
  EXPECT_TRUE(world.obstacles[0].from_map);
  EXPECT_EQ(world.source.skipped_features, 1u);
  EXPECT_FALSE(world.source.geographic);
}

TEST(ReadGeoJson, NumbersAreFiniteAndCoordinatesInRange) {
  const auto with = [](const std::string& number) {
    return ErrorOf("{\"type\": \"Polygon\", \"coordinates\":\n[[[0,0],[20,0],[20," + number + "],[0,0]]]}");
  };
  EXPECT_EQ(with("10"), "no error");
  EXPECT_EQ(with("NaN").substr(0, 30), "m.geojson:2: not valid JSON: s");
  EXPECT_EQ(with("Infinity").substr(0, 30), "m.geojson:2: not valid JSON: s");
  EXPECT_EQ(with("1e999").substr(0, 30), "m.geojson:2: the number '1e999");
  EXPECT_EQ(
      with("2e7"),
      "m.geojson:2: the polygon[3] is 2e+07: coordinates go up to 1e7 metres; move the origin nearer or check the "
      "units");
}

TEST(ReadGeoJson, WithoutAnOutlineItIsTheGrownBoundingBox) {
  const MapWorld world = Good(R"({"type": "Polygon", "coordinates": )" + kRoom + "}");
  const Box box = BoundingBox(world.outline);
  EXPECT_EQ(box.low, (Point{-2, -2}));
  EXPECT_EQ(box.high, (Point{22, 12}));
}

TEST(ReadGeoJson, HolesLieInTheirPolygon) {
  const auto with = [](const std::string& hole) {
    // A room with a slot from above down to y = 1, between x = 9 and x = 10.
    return ErrorOf(R"({"type": "Polygon", "coordinates": [
        [[0,0],[20,0],[20,10],[10,10],[10,1],[9,1],[9,10],[0,10],[0,0]],)" +
                   hole + "]}");
  };
  EXPECT_EQ(with("[[1,1],[8,1],[8,5],[1,1]]"), "no error");
  EXPECT_EQ(with("[[0,0],[9,1],[8,5],[0,0]]"), "no error") << "touching";
  EXPECT_EQ(with("[[30,1],[31,1],[31,5],[30,1]]"),
            "m.geojson:1: the polygon's hole does not lie inside the polygon, at (30, 1): move it or leave it out");
  EXPECT_EQ(with("[[19,1],[21,1],[21,5],[19,1]]").substr(0, 55),
            "m.geojson:1: the polygon's hole does not lie inside the");
  EXPECT_EQ(with("[[8,2],[11,2],[11,3],[8,3],[8,2]]"),
            "m.geojson:1: the polygon's hole leaves the polygon on its edge 1 (8, 2)-(11, 2): move it or leave it out")
      << "across the slot, all its points inside";
}

TEST(ReadGeoJson, ReadsHolesCollectionsAndMultiPolygons) {
  const MapWorld world = Good(R"({"type": "GeometryCollection", "geometries": [
      {"type": "MultiPolygon", "coordinates": [[[[0,0],[9,0],[9,9],[0,0]], [[5,2],[6,2],[6,3],[5,2]]],
                                               [[[20,0,7],[29,0,7],[29,9,7],[20,0,7]]]]},
      {"type": "LineString", "coordinates": [[0,0],[1,1]]}]})");
  ASSERT_EQ(world.obstacles.size(), 2u);
  EXPECT_EQ(world.obstacles[0].polygon->holes.size(), 1u);
  EXPECT_EQ(world.source.skipped_features, 1u);
}

TEST(ReadGeoJson, HolesOfTheOutlineAreObstacles) {
  const MapWorld world =
      Good(Feature(R"("role": "outline")", "[[[0,0],[9,0],[9,9],[0,0]], [[5,2],[6,2],[6,3],[5,2]]]"));
  EXPECT_EQ(world.obstacles.size(), 1u);
}

TEST(ReadGeoJson, SmallPlacesOnTheGlobeAreProjectedToMetres) {
  // A square of 0.001 degrees at 60 degrees north.
  const MapWorld world = Good(Feature("", "[[[10,60],[10.001,60],[10.001,60.001],[10,60.001],[10,60]]]"));
  EXPECT_TRUE(world.source.geographic);
  EXPECT_NEAR(world.source.origin.x, 10.0005, 1e-12);
  EXPECT_NEAR(world.source.origin.y, 60.0005, 1e-12);
  const Point size = BoundingBox(world.obstacles[0].polygon->outer).size();
  // Lengths of a degree at 60 degrees from the tables of WGS84: 55800 m and 111412 m.
  EXPECT_NEAR(size.x, 55.8, 0.01);
  EXPECT_NEAR(size.y, 111.412, 0.01);
}

TEST(ReadGeoJson, ACrsMemberDecides) {
  const std::string small = "[[[0.1,0.1],[0.2,0.1],[0.2,0.2],[0.1,0.1]]]";
  const auto with = [](const std::string& name) {
    return R"(, "crs": {"type": "name", "properties": {"name": ")" + name + "\"}}";
  };
  EXPECT_TRUE(Good(Collection(Feature("", small))).source.geographic);
  EXPECT_FALSE(Good(Collection(Feature("", small), with("planar"))).source.geographic);
  EXPECT_TRUE(Good(Collection(Feature("", small), with("urn:ogc:def:crs:OGC:1.3:CRS84"))).source.geographic);
  EXPECT_NE(ErrorOf(Collection(Feature("", kRoom), with("EPSG:4326"))).find("more than 5 degrees"), std::string::npos);
}

TEST(ReadGeoJson, RefusesWhatCannotBeMeant) {
  EXPECT_EQ(ErrorOf(Collection("")),
            "m.geojson:1: the map holds no polygon with an area (0 other features were skipped)");
  EXPECT_NE(ErrorOf(Feature("", "[[[0,0],[9,9],[9,0],[0,8]]]")).find("crosses itself"), std::string::npos);
  EXPECT_NE(ErrorOf(Feature("", "[[[0,0],[9],[9,0]]]")).find("must be [x, y]"), std::string::npos);
  EXPECT_NE(ErrorOf(Feature(R"("role": "wall")", kRoom)).find("outline, obstacle or ignore"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({"type": "Circle"})").find("not GeoJSON"), std::string::npos);
  EXPECT_NE(ErrorOf("[]"), "no error");
  const std::string outline = Feature(R"("role": "outline")", kRoom);
  EXPECT_NE(ErrorOf(Collection(outline + "," + outline)).find("a second outline"), std::string::npos);
}

TEST(ReadGeoJson, ReadsAnIndoorMap) {
  const auto text = ReadTextFile("scenes/maps/geojson/westport-house-floor-gf.geojson", 1 << 20);
  ASSERT_TRUE(text);
  const MapWorld world = Good(*text);
  EXPECT_TRUE(world.source.geographic);
  EXPECT_EQ(world.source.skipped_features, 36u);  // Its doors.
  EXPECT_EQ(world.obstacles.size(), 74u);
  const Point size = BoundingBox(world.outline).size();
  EXPECT_NEAR(size.x, 60, 15);  // A house, not a country.
  EXPECT_NEAR(size.y, 60, 15);
}

}  // namespace
}  // namespace tautline
