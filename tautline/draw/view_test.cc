#include "tautline/draw/view.h"

#include <gtest/gtest.h>

namespace tautline {
namespace {

constexpr double kRounding = 1e-6;  // Pixels.

void ExpectNear(Point a, Point b) {
  EXPECT_NEAR(a.x, b.x, kRounding);
  EXPECT_NEAR(a.y, b.y, kRounding);
}

TEST(View, TurnsYUpIntoYDown) {
  const View view({{0, 0}, {10, 10}}, {{0, 0}, {100, 100}});
  ExpectNear(view.ToPixels(Point{0, 0}), {0, 100});
  ExpectNear(view.ToPixels(Point{10, 10}), {100, 0});
  ExpectNear(view.ToPixels(Point{2, 7}), {20, 30});
}

TEST(View, KeepsTheAspectAndCentres) {
  const View wide({{0, 0}, {20, 10}}, {{0, 0}, {100, 100}});
  EXPECT_DOUBLE_EQ(wide.pixels_per_metre(), 5);
  ExpectNear(wide.ToPixels(Point{0, 0}), {0, 75});
  ExpectNear(wide.ToPixels(Point{20, 10}), {100, 25});
}

TEST(View, TinyAndFarWorlds) {
  for (const double factor : {1e-3, 1.0, 1e7}) {
    const Point offset{3 * factor, -40 * factor};
    const View view({offset, offset + Point{2 * factor, factor}}, {{10, 10}, {210, 110}});
    ExpectNear(view.ToPixels(offset), {10, 110});
    ExpectNear(view.ToPixels(offset + Point{2 * factor, factor}), {210, 10});
  }
}

TEST(View, FlatAndEmptyBoxesCanBeShown) {
  const View empty(Box{}, {{0, 0}, {100, 100}});
  ExpectNear(empty.ToPixels(Point{0, 0}), {50, 50});
  const View point({{3, 4}, {3, 4}}, {{0, 0}, {100, 100}});
  ExpectNear(point.ToPixels(Point{3, 4}), {50, 50});
  const View line({{0, 1}, {10, 1}}, {{0, 0}, {100, 50}});
  ExpectNear(line.ToPixels(Point{10, 1}), {100, 25});
}

}  // namespace
}  // namespace tautline
