#include "tautline/scene/png_gray.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <vector>

#include "tautline/scene/text_file.h"

namespace tautline {
namespace {

void AppendBytes(png_structp png, png_bytep data, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), count);
}

struct PngShape {
  int columns = 1;
  int rows = 1;
  int depth = 8;
  int colour_type = PNG_COLOR_TYPE_GRAY;
  bool interlaced = false;
  std::vector<png_color> palette = {};
};

/// A PNG file with these samples, row by row; 16-bit samples high byte first.
std::string WritePng(const PngShape& shape, std::vector<png_byte> samples) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &bytes, AppendBytes, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(shape.columns), static_cast<png_uint_32>(shape.rows), shape.depth,
               shape.colour_type, shape.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, 0, 0);
  if (!shape.palette.empty()) png_set_PLTE(png, info, shape.palette.data(), static_cast<int>(shape.palette.size()));
  png_write_info(png, info);
  std::vector<png_bytep> rows;
  const std::size_t row_bytes = samples.size() / static_cast<std::size_t>(shape.rows);
  for (int row = 0; row < shape.rows; ++row) rows.push_back(samples.data() + static_cast<std::size_t>(row) * row_bytes);
  png_write_image(png, rows.data());
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

RasterImage Parsed(const std::string& bytes) {
  const auto image = ParsePng(bytes, "m.png");
  EXPECT_TRUE(image) << ToString(image.error());
  return image.value_or(RasterImage{});
}

using Sums = std::vector<std::uint32_t>;
using Alphas = std::vector<std::uint16_t>;

TEST(ParsePng, GreyCountsThreeTimes) {
  const RasterImage image = Parsed(WritePng({.columns = 2, .rows = 2}, {0, 1, 128, 255}));
  EXPECT_EQ(image.columns, 2);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.maximum, 255);
  EXPECT_EQ(image.colour_sum, (Sums{0, 3, 384, 765}));
  EXPECT_TRUE(image.alpha.empty());
}

TEST(ParsePng, ReadsColourAndOpacity) {
  const RasterImage rgb = Parsed(WritePng({.colour_type = PNG_COLOR_TYPE_RGB}, {10, 20, 40}));
  EXPECT_EQ(rgb.colour_sum, Sums{70});
  const RasterImage rgba = Parsed(WritePng({.colour_type = PNG_COLOR_TYPE_RGBA}, {10, 20, 40, 99}));
  EXPECT_EQ(rgba.colour_sum, Sums{70});
  EXPECT_EQ(rgba.alpha, Alphas{99});
  const RasterImage grey = Parsed(WritePng({.colour_type = PNG_COLOR_TYPE_GRAY_ALPHA}, {10, 7}));
  EXPECT_EQ(grey.colour_sum, Sums{30});
  EXPECT_EQ(grey.alpha, Alphas{7});
}

TEST(ParsePng, KeepsSixteenBits) {
  const RasterImage image = Parsed(WritePng({.depth = 16}, {1, 2}));
  EXPECT_EQ(image.maximum, 65535);
  EXPECT_EQ(image.colour_sum, Sums{3 * 0x102});
}

TEST(ParsePng, ExpandsOneBitGreysAndPalettes) {
  EXPECT_EQ(Parsed(WritePng({.columns = 2, .depth = 1}, {0b01000000})).colour_sum, (Sums{0, 765}));
  const PngShape palette{.columns = 2, .colour_type = PNG_COLOR_TYPE_PALETTE, .palette = {{1, 2, 3}, {9, 9, 9}}};
  EXPECT_EQ(Parsed(WritePng(palette, {1, 0})).colour_sum, (Sums{27, 6}));
}

TEST(ParsePng, ReadsInterlacedImages) {
  std::vector<png_byte> samples;
  for (int i = 0; i < 9 * 7; ++i) samples.push_back(static_cast<png_byte>(4 * i));
  const RasterImage image = Parsed(WritePng({.columns = 9, .rows = 7, .interlaced = true}, samples));
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(image.colour_sum[i], 3u * samples[i]);
}

TEST(ParsePng, RefusesBrokenFiles) {
  std::string bytes = WritePng({.columns = 2, .rows = 2}, {0, 1, 128, 255});
  EXPECT_EQ(ToString(ParsePng("", "m.png").error()), "m.png: not a readable PNG: the file is cut off");
  EXPECT_FALSE(ParsePng("hello, this is no image at all", "m.png"));
  for (std::size_t size = 0; size + 1 < bytes.size(); ++size) EXPECT_FALSE(ParsePng(bytes.substr(0, size), "m.png"));
  bytes[20] = static_cast<char>(bytes[20] ^ 1);
  EXPECT_FALSE(ParsePng(bytes, "m.png"));
}

/// Signature, header with its checksum, and the start of the pixels: what a bomb shows before it goes off.
std::string Announcing(std::uint32_t columns, std::uint32_t rows, int depth, int colour_type) {
  std::string header = "IHDR";
  for (const std::uint32_t side : {columns, rows}) {
    for (int shift = 24; shift >= 0; shift -= 8) header += static_cast<char>(side >> shift);
  }
  header += {static_cast<char>(depth), static_cast<char>(colour_type), 0, 0, 0};
  std::uint32_t crc = 0xffffffff;
  for (const char c : header) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xedb88320 ^ crc >> 1 : crc >> 1;
  }
  crc = ~crc;
  std::string text("\x89PNG\r\n\x1a\n\0\0\0\x0d", 12);
  text += header;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(crc >> shift);
  return text + std::string("\0\0\0\x01IDAT", 8);
}

TEST(ParsePng, RefusesBombsByTheirHeader) {
  const auto error_of = [](const std::string& bytes) { return ToString(ParsePng(bytes, "m.png").error()); };
  EXPECT_EQ(error_of(Announcing(100000, 100000, 8, PNG_COLOR_TYPE_GRAY)),
            "m.png: more than 8192 x 8192 pixels: scale the map down");
  EXPECT_EQ(error_of(Announcing(8193, 8192, 1, PNG_COLOR_TYPE_GRAY)),
            "m.png: more than 8192 x 8192 pixels: scale the map down");
  EXPECT_EQ(error_of(Announcing(8192, 8192, 16, PNG_COLOR_TYPE_RGBA)),
            "m.png: larger than 256 MiB when unpacked: convert it to 8-bit grey");
  // Within the limits, what is announced is allocated, and then missed.
  EXPECT_EQ(error_of(Announcing(8192, 8192, 8, PNG_COLOR_TYPE_RGBA)), "m.png: not a readable PNG: the file is cut off");
  EXPECT_EQ(ParsePng(Announcing(8193, 8192, 1, PNG_COLOR_TYPE_GRAY), "m.png").error().code, ErrorCode::kLimitExceeded);
}

TEST(ParsePng, ReadsARealMap) {
  const auto bytes = ReadTextFile("scenes/maps/ros/intel-lab.png", 1 << 20);
  ASSERT_TRUE(bytes);
  const RasterImage image = Parsed(*bytes);
  EXPECT_EQ(image.columns, 579);
  EXPECT_EQ(image.rows, 581);
}

}  // namespace
}  // namespace tautline
