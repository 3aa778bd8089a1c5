#include "tautline/scene/pgm.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

using std::string_literals::operator""s;

RasterImage Parsed(std::string_view bytes) {
  const auto image = ParsePgm(bytes, "m.pgm");
  EXPECT_TRUE(image) << ToString(image.error());
  return image.value_or(RasterImage{});
}

std::string ErrorOf(std::string_view bytes) {
  const auto image = ParsePgm(bytes, "m.pgm");
  return image ? "no error" : ToString(image.error());
}

std::vector<std::uint32_t> Greys(const RasterImage& image) {
  std::vector<std::uint32_t> greys;
  for (const std::uint32_t sum : image.colour_sum) greys.push_back(sum / 3);
  return greys;
}

TEST(ParsePgm, ReadsText) {
  const RasterImage image = Parsed("P2 # plain\n3 2\n# the largest\n9\n0 1 2\n3 4 9\n");
  EXPECT_EQ(image.columns, 3);
  EXPECT_EQ(image.rows, 2);
  EXPECT_EQ(image.maximum, 9);
  EXPECT_EQ(Greys(image), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 9}));
}

TEST(ParsePgm, ReadsBytes) {
  const RasterImage image = Parsed("P5\n# by a program\n2 2\n255\n\x00\x7f\xfe\xff"s);
  EXPECT_EQ(Greys(image), (std::vector<std::uint32_t>{0, 0x7f, 0xfe, 0xff}));
}

TEST(ParsePgm, ReadsWideValuesHighByteFirst) {
  const RasterImage image = Parsed("P5 2 1 65535\n\x01\x02\xff\xff"s);
  EXPECT_EQ(Greys(image), (std::vector<std::uint32_t>{0x102, 0xffff}));
}

TEST(ParsePgm, APixelMayLookLikeABlankOrAComment) {
  EXPECT_EQ(Greys(Parsed("P5 2 1 255\n\n#"s)), (std::vector<std::uint32_t>{'\n', '#'}));
}

TEST(ParsePgm, RefusesWhatIsNotAPgm) {
  EXPECT_EQ(ErrorOf("P6 1 1 255\nabc").substr(0, 16), "m.pgm: not a PGM");
  EXPECT_EQ(ErrorOf("").substr(0, 16), "m.pgm: not a PGM");
  EXPECT_EQ(ErrorOf("P5\n2 x\n255\n").substr(0, 25), "m.pgm:2: the PGM header m");
  EXPECT_EQ(ErrorOf("P5 0 4 255\n").substr(0, 24), "m.pgm:1: the PGM header ");
  EXPECT_EQ(ErrorOf("P5 4 4 70000\n").substr(0, 24), "m.pgm:1: the PGM header ");
}

TEST(ParsePgm, RefusesWhatIsCutOff) {
  EXPECT_EQ(ErrorOf("P5 4 4 255\nabc"), "m.pgm: the PGM ends before its 4 x 4 pixels: is it cut off?");
  EXPECT_NE(ErrorOf("P2 2 2 255\n1 2 3    "), "no error");
  EXPECT_NE(ErrorOf("P5 2 1 255"), "no error");
}

TEST(ParsePgm, RefusesValuesAboveTheLargest) {
  EXPECT_EQ(ErrorOf("P2 2 1 9\n1 10"), "m.pgm:2: a pixel is missing or is not a number up to 9");
  EXPECT_NE(ErrorOf("P5 2 1 9\n\x01\x0a"), "no error");
}

TEST(ParsePgm, RefusesImagesThatAreTooLarge) {
  EXPECT_EQ(ErrorOf("P5 100000 100000 255\n"), "m.pgm: more than 8192 x 8192 pixels: scale the map down");
  EXPECT_EQ(ErrorOf("P2 16777216 16777216 255\n"), "m.pgm: more than 8192 x 8192 pixels: scale the map down");
  EXPECT_EQ(ErrorOf("P5 99999999999999999999 1 255\n").substr(0, 24), "m.pgm:1: the PGM header ");
  // Nothing is allocated for pixels that are not there.
  EXPECT_EQ(ErrorOf("P5 8192 8192 65535\n"), "m.pgm: the PGM ends before its 8192 x 8192 pixels: is it cut off?");
}

}  // namespace
}  // namespace tautline
