#include "tautline/draw/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tautline/draw/example_fleet.h"
#include "tautline/draw/example_pictures.h"

namespace tautline {
namespace {

constexpr char kSvg[] =
    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"40\" height=\"20\"><rect width=\"9\" "
    "height=\"9\"/></svg>";

/// A big-endian number of four bytes.
std::uint32_t NumberAt(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

TEST(RenderPng, HasMagicAndSize) {
  const Expected<std::string> png = RenderPng(kSvg, 2.5);
  ASSERT_TRUE(png) << ToString(png.error());
  EXPECT_EQ(png->substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(NumberAt(*png, 16), 100u);
  EXPECT_EQ(NumberAt(*png, 20), 50u);
}

TEST(RenderPng, RefusesBadInput) {
  EXPECT_FALSE(RenderPng("no svg"));
  EXPECT_FALSE(RenderPng(""));
  EXPECT_FALSE(RenderPng(kSvg, 0));
  EXPECT_FALSE(RenderPng(kSvg, -1));
  const Expected<std::string> large = RenderPng(kSvg, 1e4);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().code, ErrorCode::kLimitExceeded);
}

/// With TAUTLINE_PICTURES=FOLDER set, the examples are left there for a person to look at.
TEST(RenderPng, RendersEveryExample) {
  const char* folder = std::getenv("TAUTLINE_PICTURES");
  if (folder != nullptr) std::filesystem::create_directories(folder);
  std::vector<NamedPicture> pictures = ExamplePictures();
  for (NamedPicture& picture : FleetPictures()) pictures.push_back(std::move(picture));
  for (const NamedPicture& picture : pictures) {
    const Expected<std::string> png = RenderPng(picture.svg, folder != nullptr ? 1 : 0.1);
    ASSERT_TRUE(png) << picture.name << ": " << ToString(png.error());
    if (folder == nullptr) continue;
    const std::string stem = std::string(folder) + "/" + picture.name;
    std::ofstream(stem + ".svg") << picture.svg;
    std::ofstream(stem + ".png", std::ios::binary) << *png;
  }
}

}  // namespace
}  // namespace tautline
