#include "tautline/scene/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tautline/scene/map_file.h"

namespace tautline {
namespace {

namespace fs = std::filesystem;

/// A folder that vanishes with the test.
class SceneFile : public testing::Test {
 protected:
  SceneFile()
      : folder_(fs::temp_directory_path() /
                ("tautline_scene_file_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_ / "maps");
  }
  ~SceneFile() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }

  std::string ErrorOf(const std::string& path) const {
    const auto scene = ReadSceneFile(path);
    if (scene) return "no error";
    std::string text = ToString(scene.error());
    for (auto at = text.find(folder_.string()); at != std::string::npos; at = text.find(folder_.string())) {
      text.replace(at, folder_.string().size(), "DIR");
    }
    return text;
  }

  fs::path folder_;
};

const char kRoom[] = "world:\n  outline: [[0,0],[20,0],[20,10],[0,10]]\ngoal: [18, 2]\n";
const char kRosMap[] =
    "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST_F(SceneFile, YamlAndJsonReadTheSame) {
  const auto yaml = ReadSceneFile(Write("s.yaml", kRoom));
  const std::string text = R"({"world": {"outline": [[0,0],[20,0],[20,10],[0,10]]}, "goal": [18, 2]})";
  const auto json = ReadSceneFile(Write("s.json", text));
  const auto unnamed = ReadSceneFile(Write("scene", text));
  ASSERT_TRUE(yaml && json && unnamed);
  EXPECT_EQ(yaml->world.outline, json->world.outline);
  EXPECT_EQ(yaml->goal, unnamed->goal);
}

TEST_F(SceneFile, NamesFileAndLine) {
  EXPECT_EQ(ErrorOf(Write("s.yaml", std::string(kRoom) + "goals: 1\n")),
            "DIR/s.yaml:4: unknown key 'goals' in the scene: did you mean 'goal'?");
  EXPECT_EQ(ErrorOf("/no/such/file"), "/no/such/file: no such file, or it may not be read");
  EXPECT_EQ(ErrorOf(folder_.string()), "DIR: cannot be read: is it a file?");
  EXPECT_EQ(ErrorOf(Write("s.json", "")).substr(0, 31), "DIR/s.json:1: not valid JSON: s");
  EXPECT_EQ(ErrorOf(Write("s.yaml", "")), "DIR/s.yaml:1: the file is empty");
}

TEST_F(SceneFile, TheMapLiesBesideTheScene) {
  Write("maps/m.yaml", kRosMap);
  Write("maps/m.pgm", "P2 3 2 255\n0 254 205\n254 254 254\n");
  const std::string path = Write("s.yaml", "world: {map: maps/m.yaml, obstacles: [{circle: [2, 2.5, 0.1]}]}\n");
  const auto scene = ReadSceneFile(path);
  ASSERT_TRUE(scene) << ToString(scene.error());
  EXPECT_EQ(scene->world.map->kind, "ros");
  EXPECT_EQ(scene->world.map->path, "maps/m.yaml");
  EXPECT_EQ(scene->world.map->free_cells, 4u);
  EXPECT_EQ(scene->world.map->blocked_cells, 1u);
  EXPECT_EQ(scene->world.map->unknown_cells, 1u);
  EXPECT_EQ(scene->world.outline, (Ring{{1, 2}, {2.5, 2}, {2.5, 3}, {1, 3}}));
  ASSERT_EQ(scene->world.obstacles.size(), 3u);
  EXPECT_EQ(scene->world.obstacles[2].name, "o3");
  EXPECT_EQ(scene->world.cells->columns, 3);
  EXPECT_EQ(ReadSceneFile(path, {.unknown_free = true})->world.obstacles.size(), 2u);
}

TEST_F(SceneFile, ReadsAMovingAiMap) {
  Write("m.map", "type octile\nheight 2\nwidth 3\nmap\n..@\n...\n");
  const auto scene = ReadSceneFile(Write("s.yaml", "world: {map: m.map}\n"));
  ASSERT_TRUE(scene) << ToString(scene.error());
  EXPECT_EQ(scene->world.map->kind, "movingai");
  ASSERT_EQ(scene->world.obstacles.size(), 1u);
  EXPECT_TRUE(StrictlyInside(*scene->world.obstacles[0].polygon, {2.5, 1.5}));
}

TEST_F(SceneFile, ErrorsOfMapsNameTheFileThatIsAtFault) {
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: no.map\n")),
            "DIR/s.yaml:2: the map DIR/no.map: no such file, or it may not be read");
  Write("maps/m.yaml", kRosMap);
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: maps/m.yaml\n")),
            "DIR/s.yaml:2: the map DIR/maps/m.pgm: no such file, or it may not be read");
  Write("m.map", "type octile\nheight 2\nwidth 3\nmap\n..\n......\n");
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: m.map\n")),
            "DIR/m.map:5: the row has 2 cells, but the header says 3");
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: m.pgm\n")),
            "DIR/m.pgm: an image alone has no scale: name its ROS map YAML (such as m.yaml) instead");
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: m.dwg\n")).substr(0, 36), "DIR/m.dwg: not a map that tautline r");
}

TEST_F(SceneFile, MapsOfNoiseAreRefusedBeforeTheyAreTraced) {
  // A chequerboard: every cell has four corners of its own.
  constexpr int kSide = 4096;
  std::string text = "type octile\nheight 4096\nwidth 4096\nmap\n";
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) text += (row + column) % 2 == 0 ? '.' : '@';
    text += '\n';
  }
  Write("noise.map", text);
  EXPECT_EQ(ErrorOf(Write("s.yaml", "world:\n  map: noise.map\n")),
            "DIR/noise.map: the boundaries of its cells have 33554432 corners, more than 16000000: remove the noise or "
            "scale the map down");
}

TEST_F(SceneFile, MapsLieWithinTheRangeOfCoordinates) {
  Write("m.pgm", "P2 3 2 255\n0 254 205\n254 254 254\n");
  const auto error_of = [this](const std::string& resolution, const std::string& origin) {
    Write("m.yaml", "image: m.pgm\nresolution: " + resolution + "\norigin: " + origin +
                        "\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    return ErrorOf(Write("s.yaml", "world:\n  map: m.yaml\n"));
  };
  EXPECT_EQ(error_of("0.05", "[9.9e6, -9.9e6, 0]"), "no error");
  EXPECT_EQ(error_of("1e6", "[8e6, 0, 0]"),
            "DIR/m.yaml: corner [2] is 1.1e+07: coordinates go up to 1e7 metres; move the origin nearer or check the "
            "units; see origin and resolution");
  EXPECT_EQ(error_of("1", "[0, 2e7, 0]"),
            "DIR/m.yaml:3: origin is 2e+07: coordinates go up to 1e7 metres; move the origin nearer or check the "
            "units");
  EXPECT_EQ(error_of("1", "[.nan, 0, 0]"), "DIR/m.yaml:3: the number '.nan' must be finite");
  EXPECT_EQ(error_of(".inf", "[0, 0, 0]"), "DIR/m.yaml:2: the number '.inf' must be finite");
}

TEST_F(SceneFile, SimplifyMustBeALength) {
  const std::string path = Write("s.yaml", kRoom);
  EXPECT_EQ(ToString(ReadSceneFile(path, {.simplify = -1}).error()),
            "--simplify: must be a length in metres, 0 or more");
}

TEST(ReadSceneFile, RealMapsAreReadWhole) {
  struct Case {
    const char* path;
    std::size_t obstacles;
    std::size_t free_cells;
  };
  for (const Case c :
       {Case{"scenes/maps/ros/willow-2010-02-18-0.10.yaml", 371, 109207},
        Case{"scenes/maps/ros/depot.yaml", 131, 179481}, Case{"scenes/maps/ros/tb3_sandbox.yaml", 10, 7903},
        Case{"scenes/maps/movingai/arena.map", 6, 2054}, Case{"scenes/maps/movingai/empty-16-16.map", 0, 256}}) {
    const auto world = ReadMapFile(c.path);
    ASSERT_TRUE(world) << ToString(world.error());
    EXPECT_EQ(world->obstacles.size(), c.obstacles) << c.path;
    EXPECT_EQ(world->source.free_cells, c.free_cells) << c.path;
  }
}

TEST(ReadSceneFile, EverySceneOfTheRepositoryIsGood) {
  int scenes = 0;
  for (const auto& entry : fs::directory_iterator("scenes")) {
    if (!entry.is_regular_file()) continue;
    const std::string extension = entry.path().extension().string();
    if (extension != ".yaml" && extension != ".json") continue;
    const auto scene = ReadSceneFile(entry.path().string());
    EXPECT_TRUE(scene) << ToString(scene.error());
    ++scenes;
  }
  EXPECT_GT(scenes, 5);
}

TEST(ReadSceneFile, TheScenesOfTheMapsAreGood) {
  EXPECT_TRUE(ReadMapFile("scenes/maps/geojson/westport-house-floor-gf.geojson"));
  EXPECT_TRUE(ReadMapFile("scenes/maps/ros/intel-lab.yaml"));
}

}  // namespace
}  // namespace tautline
