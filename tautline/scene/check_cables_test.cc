#include "tautline/scene/check_cables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace tautline {
namespace {

using testing::HasSubstr;

const Box kRoom{{0, 0}, {10, 10}};

Cables Good() {
  return {.anchors = {{0, 0}, {10, 0}, {5, 10}},
          .laid = std::vector<Polyline>{{{5, 5}, {0, 0}}, {{5, 5}, {10, 0}}, {{5, 5}, {5, 10}}},
          .words = {}};
}

std::string FaultAfter(const std::function<void(Cables&)>& spoil) {
  Cables cables = Good();
  spoil(cables);
  const auto checked = CheckCables(cables, kRoom);
  return checked ? "" : checked.error().message;
}

TEST(CheckCables, TakesGoodOnes) {
  EXPECT_TRUE(CheckCables(Good(), kRoom));
  EXPECT_TRUE(CheckCables({.anchors = Good().anchors, .laid = {}, .words = {}}, kRoom));
  EXPECT_TRUE(CheckCables({.anchors = Good().anchors, .laid = {}, .words = std::vector<std::string>(3)}, kRoom));
}

TEST(CheckCables, NamesWhatIsWrong) {
  EXPECT_THAT(FaultAfter([](Cables& c) { c.anchors.pop_back(); }), HasSubstr("2 points: it needs 3"));
  EXPECT_THAT(FaultAfter([](Cables& c) { c.anchors[1].x = NAN; }), HasSubstr("cables.anchors[2]"));
  EXPECT_THAT(FaultAfter([](Cables& c) { c.anchors[1].x = 1e9; }), HasSubstr("cables.anchors[2]"));
  EXPECT_THAT(FaultAfter([](Cables& c) { c.laid->pop_back(); }), HasSubstr("2 cables for 3 anchors"));
  EXPECT_THAT(FaultAfter([](Cables& c) { (*c.laid)[1].pop_back(); }), HasSubstr("cables.laid[2] has 1 points"));
  EXPECT_THAT(FaultAfter([](Cables& c) { (*c.laid)[1][0].y = INFINITY; }), HasSubstr("cables.laid[2]"));
  EXPECT_THAT(FaultAfter([](Cables& c) { (*c.laid)[2][0].y = 6; }),
              HasSubstr("cables.laid[3] must start at the robot"));
  EXPECT_THAT(FaultAfter([](Cables& c) { (*c.laid)[2][1].y = 9; }), HasSubstr("cables.laid[3] must end at its anchor"));
  EXPECT_THAT(FaultAfter([](Cables& c) { c.words = std::vector<std::string>(3); }), HasSubstr("both laid and words"));
  EXPECT_THAT(FaultAfter([](Cables& c) {
                c.laid.reset();
                c.words = std::vector<std::string>(2);
              }),
              HasSubstr("2 words for 3 anchors"));
}

TEST(RequireCables, SaysHowToAddThem) {
  Scene scene;
  EXPECT_THAT(RequireCables(scene).error().message, HasSubstr("add `cables:"));
  scene.cables = Cables{.anchors = Good().anchors, .laid = {}, .words = {}};
  EXPECT_TRUE(RequireCables(scene));
  EXPECT_THAT(RequireLaidCables(scene).error().message, HasSubstr("add `laid`"));
  scene.cables = Good();
  EXPECT_TRUE(RequireLaidCables(scene));
}

}  // namespace
}  // namespace tautline
