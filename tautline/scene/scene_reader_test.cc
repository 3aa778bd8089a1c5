#include "tautline/scene/scene_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/scene/json_document.h"

namespace tautline {
namespace {

Expected<Scene> Read(std::string_view text, const MapLoader& load_map = {}) {
  return ParseJson(text, "s.json").and_then([&load_map](const Document& document) {
    return ReadScene(document, "s.json", load_map);
  });
}

Scene Good(std::string_view text) {
  auto scene = Read(text);
  EXPECT_TRUE(scene) << ToString(scene.error());
  return scene.value_or(Scene{});
}

std::string ErrorOf(std::string_view text) {
  const auto scene = Read(text);
  return scene ? "no error" : ToString(scene.error());
}

/// A scene with the members `rest` after a world of 20 m x 10 m with a pillar.
std::string InRoom(const std::string& rest) {
  return R"({"world": {"outline": [[0,0],[20,0],[20,10],[0,10]],
             "obstacles": [{"name": "pillar", "polygon": [[4,4],[6,4],[6,6],[4,6]]}]},)"
         "\n" +
         rest + "}";
}

/// A world with these obstacles.
std::string WithObstacles(const std::string& obstacles) {
  return R"({"world": {"outline": [[0,0],[20,0],[20,10],[0,10]], "obstacles": [)" + obstacles + "]}}";
}

std::string SquareAt(int x, const std::string& more = "") {
  const std::string a = std::to_string(x), b = std::to_string(x + 1);
  return R"({"polygon": [[)" + a + ",1],[" + b + ",1],[" + b + ",2],[" + a + ",2]]" + more + "}";
}

TEST(ReadScene, ReadsATetheredRobot) {
  const Scene scene = Good(InRoom(R"("tether": {"base": [1,1], "length": 18, "laid": [[1,1],[5,7],[9,5]]},
                                     "goal": [18,2])"));
  EXPECT_EQ(scene.path, "s.json");
  EXPECT_EQ(scene.world.outline.size(), 4u);
  EXPECT_EQ(scene.world.obstacles[0].name, "pillar");
  EXPECT_EQ(scene.world.clearance, 0);
  EXPECT_EQ(scene.world.snap, 1e-6);
  EXPECT_EQ(scene.tether->base, (Point{1, 1}));
  EXPECT_EQ(scene.tether->length, 18);
  EXPECT_EQ(scene.tether->laid->back(), (Point{9, 5}));
  EXPECT_EQ(scene.goal, (Point{18, 2}));
}

TEST(ReadScene, ReadsCirclesClearanceAndSnap) {
  const Scene scene = Good(R"({"world": {"outline": [[0,0],[9,0],[0,9]], "clearance": 0.25, "snap": 1e-4,
                               "obstacles": [{"circle": [1,2,0.5], "representative": [1,2.25]}]}})");
  EXPECT_EQ(scene.world.clearance, 0.25);
  EXPECT_EQ(scene.world.snap, 1e-4);
  EXPECT_EQ(scene.world.obstacles[0].circle, (Circle{{1, 2}, 0.5}));
  EXPECT_EQ(scene.world.obstacles[0].representative, (Point{1, 2.25}));
}

/// The text of `count` points on a circle of 1000 m about (1000, 1000).
std::string ManyPoints(std::size_t count) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    text += (i == 0 ? "[" : ",[") + std::to_string(1000 + 1000 * std::cos(angle)) + "," +
            std::to_string(1000 + 1000 * std::sin(angle)) + "]";
  }
  return text + "]";
}

TEST(ReadScene, TakesAMillionPointsAndNoMore) {
  const std::string outline = R"({"world": {"outline": [[0,0],[3e3,0],[3e3,3e3],[0,3e3]],)";
  EXPECT_EQ(ErrorOf(outline + "\n\"obstacles\": [{\"polygon\":\n" + ManyPoints(kMaxScenePoints) + "}]}}"),
            "s.json:3: more than 1000000 points: simplify the file");
  const Scene scene = Good(outline + "\n\"obstacles\": [{\"polygon\":\n" + ManyPoints(kMaxScenePoints - 4) + "}]}}");
  EXPECT_GT(scene.world.obstacles[0].polygon->outer.size(), 900000u);
}

TEST(ReadScene, CoordinatesGoUpToTenThousandKilometres) {
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": [1e7,-1e7])")), "no error");
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": [1,-1.1e7])")),
            "s.json:3: goal is -1.1e+07: coordinates go up to 1e7 metres; move the origin nearer or check the units");
  EXPECT_EQ(ErrorOf(WithObstacles(R"({"circle": [9e6,0,2e6]})")),
            "s.json:1: world.obstacles[1].circle reaches a point that is 1.1e+07: coordinates go up to 1e7 metres; "
            "move the origin nearer or check the units");
}

TEST(ReadScene, NamesObstaclesByTheirPosition) {
  const Scene scene =
      Good(WithObstacles(SquareAt(1) + "," + SquareAt(3, R"(,"name": "o3")") + "," + SquareAt(5) + "," + SquareAt(7)));
  EXPECT_EQ(scene.world.obstacles[0].name, "o1");
  EXPECT_EQ(scene.world.obstacles[1].name, "o3");
  EXPECT_EQ(scene.world.obstacles[2].name, "o4");
  EXPECT_EQ(scene.world.obstacles[3].name, "o5");
}

TEST(ReadScene, DropsRepeatedPoints) {
  const Scene scene = Good(WithObstacles(R"({"polygon": [[1,1],[2,1],[2,1],[2,2],[1,1]]})"));
  EXPECT_EQ(scene.world.obstacles[0].polygon->outer.size(), 3u);
}

TEST(ReadScene, ReadsCablesTasksAndFutures) {
  const Scene scene = Good(InRoom(R"("cables": {"anchors": [[0,0],[20,0],[20,10]],
                                                "laid": [[[9,5],[0,0]],[[9,5],[20,0]],[[9,5],[20,10]]]},
      "tasks": [[3,4],[15,6]], "max_boundary": 60,
      "futures": [{"probability": 0.1, "moves": [{"obstacle": "pillar", "path": [[5,5],[8,6]]}]},
                  {"probability": 0.2, "moves": []}, {"probability": 0.7, "moves": []}])"));
  EXPECT_EQ(scene.cables->laid->size(), 3u);
  EXPECT_EQ(scene.tasks.size(), 2u);
  EXPECT_EQ(scene.max_boundary, 60);
  EXPECT_EQ(scene.futures[0].moves[0].obstacle, "pillar");
}

TEST(ReadScene, ReadsAFleetWithoutAWorld) {
  const Scene scene = Good(R"({"fleet": {"speed": 0.5, "robots": [
      {"name": "r1", "start": [0,0], "target": [10,0], "cable": [[0,0],[5,4],[10,0]]},
      {"start": [0,5], "target": [10,5], "speed": 2}]}})");
  EXPECT_TRUE(scene.world.outline.empty());
  EXPECT_EQ(scene.fleet->robots[0].speed, 0.5);
  EXPECT_EQ(scene.fleet->robots[1].speed, 2);
  EXPECT_EQ(scene.fleet->robots[1].name, "r2");
  EXPECT_FALSE(scene.fleet->robots[1].cable);
}

TEST(ReadScene, RobotsMayHaveRadiusAndTetherOfTheirOwn) {
  const Scene scene = Good(R"({"fleet": {"speed": 1, "radius": 0.2, "tether": 12, "robots": [
      {"start": [0,0], "target": [10,0], "radius": 0.5},
      {"start": [0,5], "target": [10,5], "tether": 0}]}})");
  EXPECT_EQ(scene.fleet->robots[0].radius, 0.5);
  EXPECT_EQ(scene.fleet->robots[0].tether, 12);
  EXPECT_EQ(scene.fleet->robots[1].radius, 0.2);
  EXPECT_EQ(scene.fleet->robots[1].tether, 0);
  const Scene bare = Good(R"({"fleet": {"speed": 1, "robots": [{"start": [0,0], "target": [10,0]}]}})");
  EXPECT_EQ(bare.fleet->robots[0].radius, 0);
  EXPECT_FALSE(bare.fleet->robots[0].tether);
  EXPECT_NE(ErrorOf(R"({"fleet": {"speed": 1, "radius": -1, "robots": []}})").find("fleet.radius"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({"fleet": {"speed": 1, "robots": [{"start": [0,0], "target": [1,0], "tether": -2}]}})")
                .find("fleet.robots[1].tether"),
            std::string::npos);
}

TEST(ReadScene, AsksTheLoaderForTheMap) {
  const MapLoader loader = [](const std::string& name) -> Expected<MapWorld> {
    EXPECT_EQ(name, "office.yaml");
    MapWorld map;
    map.outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    for (const char* obstacle : {"", "desk", "desk"}) {
      map.obstacles.push_back({obstacle, std::nullopt, Circle{{1, 1}, 0.5}, std::nullopt, true});
    }
    return map;
  };
  const auto scene = Read(R"({"world": {"map": "office.yaml", "obstacles": [{"circle": [2,2,1]},
                                                                          {"circle": [3,3,1], "name": "desk"}]}})",
                          loader);
  ASSERT_TRUE(scene) << ToString(scene.error());
  std::string names;
  for (const Obstacle& obstacle : scene->world.obstacles) names += obstacle.name + " ";
  EXPECT_EQ(names, "o1 desk o3 desk_2 desk_3 ");
  EXPECT_EQ(scene->world.map->path, "office.yaml");
}

TEST(ReadScene, SaysWhereTheMapIsMissing) {
  const MapLoader loader = [](const std::string&) -> Expected<MapWorld> {
    return tl::unexpected<Error>(Error{ErrorCode::kUnreadable, "no such file", "a/office.yaml"});
  };
  const auto scene = Read("{\"world\":\n{\"map\": \"office.yaml\"}}", loader);
  EXPECT_EQ(ToString(scene.error()), "s.json:2: the map a/office.yaml: no such file");
}

TEST(ReadScene, UnknownKeysAreErrors) {
  EXPECT_EQ(ErrorOf(InRoom(R"("tether": {"base": [1,1], "lenght": 18})")),
            "s.json:3: unknown key 'lenght' in tether: did you mean 'length'?");
  EXPECT_EQ(ErrorOf(InRoom(R"("zebra": 1)")).substr(0, 53), "s.json:3: unknown key 'zebra' in the scene: known are");
}

TEST(ReadScene, ReadsTheBodyOfTheRobot) {
  const auto scene = Read(InRoom(R"("robot": {"radius": 0.3, "heading": -1.5})"));
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->robot.radius, 0.3);
  EXPECT_EQ(scene->robot.heading, -1.5);
  EXPECT_FALSE(Read(InRoom(R"("robot": {})"))->robot.radius);
  EXPECT_EQ(ErrorOf(InRoom(R"("robot": {"radius": 0})")), "s.json:3: robot.radius is 0: it must be larger than 0");
}

TEST(ReadScene, RefusesWrongKinds) {
  EXPECT_EQ(ErrorOf("[1]"), "s.json:1: a scene must be a map of keys and values, not a list of 1");
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": 5)")), "s.json:3: goal must be a point [x, y], not the number 5");
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": [1,2,3])")), "s.json:3: goal must be a point [x, y], not a list of 3");
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": [1,"2"])")),
            "s.json:3: goal must be a number, not the text '2': remove the quotes");
  EXPECT_EQ(ErrorOf(InRoom(R"("tasks": 3)")), "s.json:3: tasks must be a list, not the number 3: write it in [ ]");
  EXPECT_EQ(ErrorOf(InRoom(R"("tether": {"base": [1,1]})")), "s.json:3: tether has no 'length': add it");
  EXPECT_EQ(ErrorOf(InRoom(R"("goal": [1e16,0])")), "s.json:3: goal is 1e+16: numbers go up to 1e15");
}

TEST(ReadScene, RefusesWrongSizes) {
  EXPECT_EQ(ErrorOf(InRoom(R"("tether": {"base": [1,1], "length": -1})")),
            "s.json:3: tether.length is -1: it must not be negative");
  EXPECT_EQ(ErrorOf(InRoom(R"("max_boundary": 0)")), "s.json:3: max_boundary is 0: it must be larger than 0");
  EXPECT_EQ(ErrorOf(WithObstacles(R"({"circle": [1,1,0]})")),
            "s.json:1: world.obstacles[1].circle radius is 0: it must be larger than 0");
  EXPECT_EQ(ErrorOf(R"({"world": {"outline": [[0,0],[1,0],[1,1]], "clearance": -0.5}})"),
            "s.json:1: world.clearance is -0.5: it must not be negative");
}

TEST(ReadScene, ATetherOfLengthZeroIsAllowed) {
  EXPECT_EQ(Good(InRoom(R"("tether": {"base": [1,1], "length": 0})")).tether->length, 0);
}

TEST(ReadScene, RefusesPolygonsThatBoundNothing) {
  EXPECT_EQ(ErrorOf(WithObstacles(R"({"polygon": [[1,1],[2,2]]})")),
            "s.json:1: world.obstacles[1].polygon has 2 points: it needs 3 or more");
  EXPECT_EQ(ErrorOf(WithObstacles(R"({"polygon": [[0.1,0.1],[0.2,0.2],[0.3,0.3]]})")),
            "s.json:1: world.obstacles[1].polygon has no area: its points lie on a line");
  EXPECT_EQ(
      ErrorOf(WithObstacles(R"({"polygon": [[1,1],[3,3],[3,1],[1,3]]})")),
      "s.json:1: world.obstacles[1].polygon crosses itself: edge 1 (1, 1)-(3, 3) meets edge 3 (3, 1)-(1, 3); list "
      "the points in order around it");
  EXPECT_EQ(ErrorOf(R"({"world": {"outline": [[0,0],[4,4],[4,0],[0,3]]}})").substr(0, 38),
            "s.json:1: world.outline crosses itself");
}

TEST(ReadScene, RefusesUnclearObstacles) {
  EXPECT_EQ(ErrorOf(WithObstacles(R"({"name": "a"})")),
            "s.json:1: world.obstacles[1] must have exactly one of 'polygon' and 'circle'");
  EXPECT_EQ(ErrorOf(WithObstacles(SquareAt(1, R"(,"name": "a")") + "," + SquareAt(3, R"(,"name": "a")"))),
            "s.json:1: two obstacles are named 'a': rename one");
  EXPECT_NE(ErrorOf(WithObstacles(SquareAt(1, R"(,"name": "a b")"))).find("holds a blank"), std::string::npos);
  EXPECT_NE(ErrorOf(WithObstacles(SquareAt(1, R"(,"name": "a^-1")"))).find("holds a blank"), std::string::npos);
  EXPECT_NE(ErrorOf(WithObstacles(SquareAt(1, R"(,"name": "")"))).find("is empty"), std::string::npos);
  EXPECT_NE(ErrorOf(WithObstacles(SquareAt(1, R"(,"representative": [1,1.5])"))).find("strictly inside"),
            std::string::npos);
}

TEST(ReadScene, ExactlyOneOfMapAndOutline) {
  EXPECT_EQ(ErrorOf(R"({"world": {}})"), "s.json:1: world must have exactly one of 'map' and 'outline'");
  EXPECT_EQ(ErrorOf(R"({"goal": [1,2]})"),
            "s.json:1: the scene has 'goal' but no 'world': add one with an outline or a map");
  EXPECT_EQ(ErrorOf("{}"), "s.json:1: the scene has neither 'world' nor 'fleet'");
}

TEST(ReadScene, TheLaidCableStartsAtTheBase) {
  EXPECT_EQ(ErrorOf(InRoom(R"("tether": {"base": [1,1], "length": 18, "laid": [[2,1],[9,5]]})")),
            "s.json:3: tether.laid must start at the base, at (1, 1), not at (2, 1)");
  const Scene scene = Good(InRoom(R"("tether": {"base": [1,1], "length": 18, "laid": [[1.000001,1],[9,5]]})"));
  EXPECT_EQ(scene.tether->laid->front(), (Point{1, 1}));
}

TEST(ReadScene, CablesHaveWordsInstead) {
  const std::string anchors = R"("cables": {"anchors": [[0,0],[20,0],[20,10]], "words": )";
  const Scene scene = Good(InRoom(anchors + R"(["", "a b^-1", ["a", "b"]]})"));
  EXPECT_EQ(*scene.cables->words, (std::vector<std::string>{"", "a b^-1", "a b"}));
  EXPECT_NE(ErrorOf(InRoom(anchors + R"([""]})")).find("1 words for 3 anchors"), std::string::npos);
  EXPECT_NE(ErrorOf(InRoom(anchors + R"(["", 1, ""]})")).find("cables.words[2] must be a list"), std::string::npos);
  EXPECT_NE(ErrorOf(InRoom(anchors + R"(["", "", ""], "laid": [[[9,5],[0,0]],[[9,5],[20,0]],[[9,5],[20,10]]]})"))
                .find("both laid and words"),
            std::string::npos);
}

TEST(ReadScene, CablesRunFromTheRobotToTheirAnchors) {
  const std::string anchors = R"("cables": {"anchors": [[0,0],[20,0],[20,10]], "laid": )";
  EXPECT_NE(ErrorOf(InRoom(anchors + "[[[9,5],[0,0]]]}")).find("1 cables for 3 anchors"), std::string::npos);
  EXPECT_NE(ErrorOf(InRoom(anchors + "[[[9,5],[0,0]],[[9,6],[20,0]],[[9,5],[20,10]]]}")).find("start at the robot"),
            std::string::npos);
  EXPECT_NE(ErrorOf(InRoom(anchors + "[[[9,5],[0,0]],[[9,5],[20,1]],[[9,5],[20,10]]]}")).find("end at its anchor"),
            std::string::npos);
}

TEST(ReadScene, FuturesAreAProbabilityOverKnownObstacles) {
  EXPECT_EQ(ErrorOf(InRoom(R"("futures": [{"probability": 0.5, "moves": []}])")),
            "s.json:3: the probabilities of the futures sum to 0.5: they must sum to 1");
  EXPECT_EQ(
      ErrorOf(InRoom(R"("futures": [{"probability": 1, "moves": [{"obstacle": "piller", "path": [[1,1],[2,2]]}]}])")),
      "s.json:3: there is no obstacle 'piller': did you mean 'pillar'?");
}

TEST(ReadScene, RobotsHaveSpeedsAndNamesOfTheirOwn) {
  EXPECT_NE(ErrorOf(R"({"fleet": {"robots": [{"start": [0,0], "target": [1,0]}]}})").find("has no speed"),
            std::string::npos);
  EXPECT_NE(ErrorOf(R"({"fleet": {"speed": 1, "robots": []}})").find("is empty"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({"fleet": {"speed": 1, "robots": [{"name": "a", "start": [0,0], "target": [1,0]},
                                                         {"name": "a", "start": [0,1], "target": [1,1]}]}})")
                .find("two robots are named 'a'"),
            std::string::npos);
  EXPECT_NE(ErrorOf(R"({"fleet": {"speed": 1, "robots": [{"start": [0,0], "target": [1,0], "cable": [[0,0],[2,0]]}]}})")
                .find("must end at the target"),
            std::string::npos);
}

TEST(ReadScene, AMapInPlaceOfASceneGetsAnAnswerOfItsOwn) {
  EXPECT_NE(ErrorOf(R"({"image": "a.pgm", "resolution": 0.05})").find("this is a map"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({"type": "FeatureCollection", "features": []})").find("this is a map"), std::string::npos);
}

}  // namespace
}  // namespace tautline
