#include "tautline/planners/grid_manifold/manifold_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

using testing::HasSubstr;

TEST(ManifoldFile, GivesBackTheSameManifold) {
  for (std::int64_t seed = 0; seed < ScaledTestCount(100); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    options.length_m = ground.cell_m() * rng.Uniform(0, 10);
    if (seed % 3 == 0) options.max_vertices = 50;
    const GridManifold manifold = GridManifold::Build(ground, options);
    const std::string bytes = ManifoldFile::Write(manifold, 7);
    const auto loaded = ManifoldFile::Read(bytes, 7, ground, options);
    ASSERT_TRUE(loaded) << ToString(loaded.error());
    ASSERT_EQ(ManifoldFile::Write(*loaded, 7), bytes);
    ASSERT_EQ(loaded->stop(), manifold.stop());
    const ManifoldCounts a = manifold.Count(), b = loaded->Count();
    ASSERT_EQ(a.vertices, b.vertices);
    ASSERT_EQ(a.edges, b.edges);
    ASSERT_EQ(a.multiplicity, b.multiplicity);
  }
}

std::string ErrorOf(const std::string& bytes, std::uint64_t world, const ManifoldOptions& options) {
  const CellGround ground(GridFromSketch({"....", ".#..", "...."}), {});
  const auto loaded = ManifoldFile::Read(bytes, world, ground, options);
  return loaded ? "none" : ToString(loaded.error());
}

TEST(ManifoldFile, IsRefusedForAnotherQuestionAndWhenDamaged) {
  const CellGround ground(GridFromSketch({"....", ".#..", "...."}), {});
  ManifoldOptions options{.base = {0, 0}, .length_m = 6};
  const std::string bytes = ManifoldFile::Write(GridManifold::Build(ground, options), 7);
  EXPECT_EQ(ErrorOf(bytes, 7, options), "none");
  EXPECT_THAT(ErrorOf(bytes, 8, options), HasSubstr("another world"));
  ManifoldOptions other = options;
  other.length_m = 6.5;
  EXPECT_THAT(ErrorOf(bytes, 7, other), HasSubstr("length"));
  other = options;
  other.connectivity = Connectivity::kFour;
  EXPECT_THAT(ErrorOf(bytes, 7, other), HasSubstr("connectivity"));
  EXPECT_THAT(ErrorOf("scene", 7, options), HasSubstr("not a manifold"));
  EXPECT_THAT(ErrorOf("tautline manifold, version 99\n", 7, options), HasSubstr("another version"));
  for (std::size_t at = 30; at < bytes.size(); at += 5) {
    std::string broken = bytes;
    broken[at] = static_cast<char>(broken[at] + 1);
    EXPECT_THAT(ErrorOf(broken, 7, options), HasSubstr("damaged"));
    EXPECT_NE(ErrorOf(bytes.substr(0, at), 7, options), "none");
  }
}

}  // namespace
}  // namespace tautline
