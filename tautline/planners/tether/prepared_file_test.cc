#include "tautline/planners/tether/prepared_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tautline/base/rng.h"
#include "tautline/base/test_scale.h"
#include "tautline/planners/tether/random_tether.h"

namespace tautline {
namespace {

using testing::HasSubstr;

TEST(PreparedFile, GivesBackAPlannerThatAnswersTheSame) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(200); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    Scene scene = MakeRandomTether(rng, seed % 2 == 0).scene();
    if (seed % 3 == 0) scene.world.clearance = 0.05;
    const auto planner = TetherPlanner::Prepare(scene.world).value();
    const std::string bytes = PreparedFile::Write(planner, scene.world);
    const auto loaded = PreparedFile::Read(bytes, scene.world);
    ASSERT_TRUE(loaded) << ToString(loaded.error());
    ASSERT_EQ(PreparedFile::Write(*loaded, scene.world), bytes);
    const PlanResult a = planner.Plan(*scene.tether, *scene.goal), b = loaded->Plan(*scene.tether, *scene.goal);
    ASSERT_EQ(a.status, b.status);
    ASSERT_EQ(a.explanation, b.explanation);
    ASSERT_EQ(a.start.points, b.start.points);
    ASSERT_EQ(a.motion.has_value(), b.motion.has_value());
    if (!a.motion) continue;
    ASSERT_EQ(a.motion->path.points, b.motion->path.points);
    ASSERT_EQ(a.motion->tether.points, b.motion->tether.points);
    ASSERT_EQ(a.motion->tether.word, b.motion->tether.word);
  }
}

Scene AScene() {
  Rng rng(7);
  return MakeRandomTether(rng, false).scene();
}

std::string ErrorOf(const std::string& bytes, const World& world) {
  const auto loaded = PreparedFile::Read(bytes, world);
  return loaded ? "none" : ToString(loaded.error());
}

TEST(PreparedFile, IsRefusedForAnotherWorld) {
  const Scene scene = AScene();
  const std::string bytes = PreparedFile::Write(TetherPlanner::Prepare(scene.world).value(), scene.world);
  World grown = scene.world;
  grown.clearance = 1e-6;
  EXPECT_THAT(ErrorOf(bytes, grown), HasSubstr("another world"));
  World renamed = scene.world;
  renamed.obstacles[0].name += "x";
  EXPECT_THAT(ErrorOf(bytes, renamed), HasSubstr("another world"));
  World moved = scene.world;
  moved.outline[0].x -= 1e-9;
  EXPECT_THAT(ErrorOf(bytes, moved), HasSubstr("another world"));
}

TEST(PreparedFile, IsRefusedWhenItIsNoneOrOfAnotherVersionOrDamaged) {
  const Scene scene = AScene();
  const std::string bytes = PreparedFile::Write(TetherPlanner::Prepare(scene.world).value(), scene.world);
  EXPECT_THAT(ErrorOf("", scene.world), HasSubstr("not a prepared map"));
  EXPECT_THAT(ErrorOf("world: {}", scene.world), HasSubstr("not a prepared map"));
  std::string other = bytes;
  other[other.find(" 1\n") + 1] = '0';
  EXPECT_THAT(ErrorOf(other, scene.world), HasSubstr("another version"));
  for (std::size_t cut = bytes.find(" 1\n") + 3; cut < bytes.size(); cut += 1 + bytes.size() / 50) {
    EXPECT_THAT(ErrorOf(bytes.substr(0, cut), scene.world), HasSubstr("damaged")) << cut;
  }
  for (std::size_t at = bytes.find(" 1\n") + 3; at < bytes.size(); at += 1 + bytes.size() / 50) {
    std::string flipped = bytes;
    flipped[at] = static_cast<char>(flipped[at] ^ 4);
    EXPECT_THAT(ErrorOf(flipped, scene.world), HasSubstr("damaged")) << at;
  }
}

/// The bytes with another content and a checksum that fits it.
std::string WithContent(const std::string& bytes, const std::string& content) {
  boost::crc_32_type crc;
  crc.process_bytes(content.data(), content.size());
  return bytes.substr(0, bytes.find('\n') + 1) + std::to_string(crc.checksum()) + "\n" + content;
}

TEST(PreparedFile, ForgedContentIsRefusedOrPlannedWith) {
  const Scene scene = AScene();
  const std::string bytes = PreparedFile::Write(TetherPlanner::Prepare(scene.world).value(), scene.world);
  int refused = 0, read = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(3000); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    std::string content = bytes.substr(bytes.find('\n', bytes.find('\n') + 1) + 1);
    ASSERT_EQ(WithContent(bytes, content), bytes);
    for (std::int64_t i = rng.UniformInt(1, 3); i > 0; --i) {
      const auto at = static_cast<std::size_t>(rng.UniformInt(0, static_cast<std::int64_t>(content.size()) - 1));
      content[at] = static_cast<char>(rng.UniformInt(0, 255));
    }
    const auto planner = PreparedFile::Read(WithContent(bytes, content), scene.world);
    if (!planner) {
      ++refused;
      continue;
    }
    ++read;
    try {
      static_cast<void>(planner->Plan(*scene.tether, *scene.goal, {.all = true, .budget = 2000}));
    } catch (const std::logic_error&) {  // A plan along forged sight finds that it leaves the free ground.
    }
  }
  EXPECT_GT(refused, ScaledTestCount(1000));
  EXPECT_GT(read, ScaledTestCount(10));
}

TEST(PreparedFile, RingsThatCrossOrRunTheWrongWayAreRefused) {
  Scene scene;  // Two corners of a square exchanged make two edges cross.
  scene.world.outline = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Obstacle block;
  block.polygon = PolygonWithHoles{{{4, 4}, {6, 4}, {6, 6}, {4, 6}}, {}};
  scene.world.obstacles.push_back(block);
  const std::string bytes = PreparedFile::Write(TetherPlanner::Prepare(scene.world).value(), scene.world);
  const std::string content = bytes.substr(bytes.find('\n', bytes.find('\n') + 1) + 1);
  const auto forged = [&](const auto& change) {
    auto json = nlohmann::json::from_cbor(content);
    auto& points = json["free_space"]["components"][0]["outer"]["points"].get_binary();
    change(points, json);
    const auto cbor = nlohmann::json::to_cbor(json);
    return ErrorOf(WithContent(bytes, std::string(cbor.begin(), cbor.end())), scene.world);
  };
  constexpr std::ptrdiff_t kPoint = 16;  // Bytes.
  EXPECT_EQ(forged([](auto&, auto&) {}), "none");
  EXPECT_THAT(forged([](auto& points, auto&) {
                std::swap_ranges(points.begin(), points.begin() + kPoint, points.begin() + kPoint);
              }),
              HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto& points, auto&) {
                for (auto a = points.begin(), b = points.end() - kPoint; a < b; a += kPoint, b -= kPoint) {
                  std::swap_ranges(a, a + kPoint, b);
                }
              }),
              HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto& points, auto&) { points.resize(2 * kPoint); }), HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto& points, auto&) { std::fill_n(points.begin(), 8, std::uint8_t{0xff}); }),  // A NaN.
              HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto&, auto& json) { json["free_space"]["components"][0]["outer"]["obstacle"] = 1 << 30; }),
              HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto&, auto& json) { json["free_space"]["grid"] = 0.0; }), HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto&, auto& json) { json["free_space"]["components"].clear(); }), HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto&, auto& json) { json["sight"]["counts"].get_binary()[3] = 0xff; }), HasSubstr("damaged"));
  EXPECT_THAT(forged([](auto&, auto& json) { json["sight"]["sightings"].get_binary()[0] ^= 1; }), HasSubstr("damaged"));
}

TEST(PreparedFile, ContentThatIsTooDeepIsRefused) {
  const Scene scene = AScene();
  const std::string bytes = PreparedFile::Write(TetherPlanner::Prepare(scene.world).value(), scene.world);
  EXPECT_THAT(ErrorOf(WithContent(bytes, std::string(10'000'000, '\x81')), scene.world), HasSubstr("damaged"));
}

}  // namespace
}  // namespace tautline
