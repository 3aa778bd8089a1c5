#include "tautline/scene/ros_map.h"

#include <gtest/gtest.h>

#include "tautline/scene/json_document.h"

namespace tautline {
namespace {

std::string Settings(const std::string& change = "") {
  return R"({"image": "m.pgm", "resolution": 0.05, "origin": [-10, 5, 0.5], "negate": 0, "occupied_thresh": 0.65,
             "free_thresh": 0.25)" +
         change + "}";
}

Expected<RosMapSettings> Read(std::string_view text) {
  return ParseJson(text, "m.yaml").and_then([](const Document& document) {
    return ReadRosMapSettings(document, "m.yaml");
  });
}

std::string ErrorOf(std::string_view text) {
  const auto settings = Read(text);
  return settings ? "no error" : ToString(settings.error());
}

/// One row of grey pixels.
RasterImage GreyRow(const std::vector<std::uint32_t>& greys) {
  RasterImage image;
  image.columns = static_cast<int>(greys.size());
  image.rows = 1;
  for (const std::uint32_t grey : greys) image.colour_sum.push_back(3 * grey);
  return image;
}

/// '#', '.' and '?' for the cells of row 0.
std::string RowText(const RasterImage& image, const RosMapSettings& settings) {
  const OccupancyGrid grid = GridFromRosImage(image, settings);
  std::string text;
  for (int column = 0; column < grid.columns; ++column) {
    const CellState state = grid.at(column, 0);
    text += state == CellState::kBlocked ? '#' : state == CellState::kFree ? '.' : '?';
  }
  return text;
}

RosMapSettings SettingsWith(RosMapMode mode, bool negate = false) {
  RosMapSettings settings;
  settings.resolution_m = 1;
  settings.occupied_thresh = 0.65;
  settings.free_thresh = 0.196;
  settings.mode = mode;
  settings.negate = negate;
  return settings;
}

TEST(ReadRosMapSettings, ReadsAllFields) {
  const auto settings = Read(Settings(R"(, "mode": "scale", "unknown_to_us": 1)"));
  ASSERT_TRUE(settings) << ToString(settings.error());
  EXPECT_EQ(settings->image, "m.pgm");
  EXPECT_EQ(settings->resolution_m, 0.05);
  EXPECT_EQ(settings->origin, (Point{-10, 5}));
  EXPECT_EQ(settings->yaw_rad, 0.5);
  EXPECT_FALSE(settings->negate);
  EXPECT_EQ(settings->mode, RosMapMode::kScale);
  EXPECT_EQ(Read(Settings())->mode, RosMapMode::kTrinary);
}

TEST(ReadRosMapSettings, RefusesWhatMapServerCannotMean) {
  EXPECT_EQ(ErrorOf(R"({"image": "m.pgm"})"), "m.yaml:1: the ROS map has no 'resolution': add it");
  EXPECT_NE(ErrorOf(Settings(R"(, "mode": "tri")")).find("trinary, scale or raw"), std::string::npos);
  EXPECT_NE(ErrorOf(R"({"image": "m.pgm", "resolution": 0, "origin": [0,0,0]})").find("larger than 0"),
            std::string::npos);
  EXPECT_NE(ErrorOf(R"({"image": "m.pgm", "resolution": 1, "origin": [0,0]})").find("[x, y, yaw]"), std::string::npos);
}

TEST(GridFromRosImage, TrinaryKnowsThreeStates) {
  // 205 is the grey that map_saver writes for unknown: (255 - 205) / 255 = 0.19608.
  EXPECT_EQ(RowText(GreyRow({0, 89, 90, 205, 206, 255}), SettingsWith(RosMapMode::kTrinary)), "##??..");
}

TEST(GridFromRosImage, NegateSwapsBlackAndWhite) {
  EXPECT_EQ(RowText(GreyRow({0, 255}), SettingsWith(RosMapMode::kTrinary, true)), ".#");
}

TEST(GridFromRosImage, TrinaryAveragesOpacityAsAFourthChannel) {
  RasterImage image = GreyRow({0, 0, 255});
  image.alpha = {255, 0, 0};
  // Opaque black: shade 1/4, occupancy 0.75. Transparent white: shade 3/4, occupancy 0.25.
  EXPECT_EQ(RowText(image, SettingsWith(RosMapMode::kTrinary)), "##?");
}

TEST(GridFromRosImage, ScaleTakesTransparentPixelsAsUnknown) {
  RasterImage image = GreyRow({0, 0, 128, 255});
  image.alpha = {255, 254, 255, 255};
  EXPECT_EQ(RowText(image, SettingsWith(RosMapMode::kScale)), "#??.");
}

TEST(GridFromRosImage, RawValuesArePercent) {
  EXPECT_EQ(RowText(GreyRow({0, 19, 20, 65, 66, 100, 101, 255}), SettingsWith(RosMapMode::kRaw)), "..??##??");
  EXPECT_EQ(RowText(GreyRow({0, 100}), SettingsWith(RosMapMode::kRaw, true)), ".#");
}

TEST(GridFromRosImage, TheFirstRowOfTheImageIsTheHighest) {
  RasterImage image;
  image.columns = 1;
  image.rows = 2;
  image.colour_sum = {0, 3 * 255};
  const OccupancyGrid grid = GridFromRosImage(image, SettingsWith(RosMapMode::kTrinary));
  EXPECT_EQ(grid.at(0, 1), CellState::kBlocked);
  EXPECT_EQ(grid.at(0, 0), CellState::kFree);
}

}  // namespace
}  // namespace tautline
