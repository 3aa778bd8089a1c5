#include "tautline/draw/label_placer.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

const Box kFrame{{0, 0}, {200, 200}};
const Box kSymbol{{90, 90}, {110, 110}};
constexpr Point kSize{40, 12};

TEST(LabelPlacer, PrefersTheRight) {
  const LabelPlacer placer(kFrame);
  const LabelPlacer::Place place = placer.FindBeside(kSymbol, kSize);
  EXPECT_GT(place.box.low.x, kSymbol.high.x);
  EXPECT_LT(place.cost, LabelPlacer::kCrossing);
}

TEST(LabelPlacer, AvoidsWhatIsTaken) {
  LabelPlacer placer(kFrame);
  placer.Take({{112, 80}, {200, 120}});
  const LabelPlacer::Place place = placer.FindBeside(kSymbol, kSize);
  EXPECT_LT(place.box.high.x, kSymbol.low.x);
}

TEST(LabelPlacer, AvoidsLines) {
  LabelPlacer placer(kFrame);
  const Polyline through = {{0, 100}, {200, 100}};
  placer.TakeLine(through);
  const LabelPlacer::Place place = placer.FindBeside(kSymbol, kSize);
  EXPECT_FALSE(Meets(place.box, through[0], through[1]));
}

TEST(LabelPlacer, StaysInTheFrame) {
  const LabelPlacer placer(kFrame);
  const LabelPlacer::Place place = placer.FindBeside({{180, 90}, {195, 110}}, kSize);
  EXPECT_LE(place.box.high.x, 200);
}

TEST(Meets, SegmentsAndBoxes) {
  const Box box{{0, 0}, {10, 10}};
  EXPECT_TRUE(Meets(box, {-5, 5}, {15, 5}));
  EXPECT_TRUE(Meets(box, {2, 2}, {3, 3}));
  EXPECT_FALSE(Meets(box, {-5, 8}, {3, 20}));
  EXPECT_FALSE(Meets(box, {11, 0}, {11, 10}));
}

}  // namespace
}  // namespace tautline
