#include "tautline/planners/tether/prepared_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tautline
