#include "tautline/planners/cable_workspace/cable_sections.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tautline/homotopy/print_point.h"

namespace tautline {
namespace {

/// The lengths agree where sections meet, and so do the slopes unless a corner lies on the way.
void ExpectContinuous(const std::vector<CableSection>& sections) {
  for (std::size_t i = 1; i < sections.size(); ++i) {
    EXPECT_EQ(sections[i].begin, sections[i - 1].end);
    EXPECT_NEAR(sections[i].LengthAt(sections[i].begin), sections[i - 1].LengthAt(sections[i].begin), 1e-12);
    if (sections[i].corner == sections[i - 1].corner) continue;
    EXPECT_NEAR(sections[i].SlopeAt(sections[i].begin), sections[i - 1].SlopeAt(sections[i].begin), 1e-12);
  }
}

TEST(CableSections, OfAStraightCableAreOne) {
  const Polyline before{{0, 0}, {3, 4}}, after{{0, 0}, {-3, 4}};
  const auto sections = CableSections({before, after, 0.5});
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_EQ(sections[0].corner, (Point{0, 0}));
  EXPECT_EQ(sections[0].end, 6);
  EXPECT_EQ(sections[0].LengthAt(0), 5.5);
  EXPECT_EQ(sections[0].LengthAt(3), 4.5);
  EXPECT_EQ(sections[0].SlopeAt(3), 0);
  EXPECT_EQ(sections[0].SlopeAt(0), -0.6);
}

TEST(CableSections, SwitchWhereTheEdgesOfBothSidesHitTheWay) {
  // From the apex (0, 0) both cables go round corners, by which the way from (-6, 8) to (6, 8) is cut.
  const Polyline before{{0, -2}, {0, 0}, {-1, 2}, {-6, 8}}, after{{0, -2}, {0, 0}, {1, 2}, {3, 5}, {6, 8}};
  const auto sections = CableSections({before, after, 0});
  ASSERT_EQ(sections.size(), 4u);
  EXPECT_EQ(sections[0].corner, (Point{-1, 2}));
  EXPECT_NEAR(sections[0].end, 2, 1e-12);  // (-4, 8), on the line from (0, 0) through (-1, 2).
  EXPECT_EQ(sections[1].corner, (Point{0, 0}));
  EXPECT_NEAR(sections[1].end, 10, 1e-12);
  EXPECT_EQ(sections[2].corner, (Point{1, 2}));
  EXPECT_NEAR(sections[2].end, 11, 1e-12);
  EXPECT_EQ(sections[3].corner, (Point{3, 5}));
  EXPECT_EQ(sections[3].end, 12);
  EXPECT_NEAR(sections[3].to_corner, 2 + std::sqrt(5) + std::sqrt(13), 1e-12);
  ExpectContinuous(sections);
}

TEST(CableSections, SplitAtACornerOnTheWay) {
  // The robot drives to the corner (0, 0) from which its cable comes, and on.
  const Polyline before{{0, -2}, {0, 0}, {-3, 0}}, after{{0, -2}, {0, 0}, {4, 0}};
  const auto sections = CableSections({before, after, 0});
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].end, 3);
  EXPECT_EQ(sections[0].SlopeAt(3), -1);
  EXPECT_EQ(sections[1].SlopeAt(3), 1);
  EXPECT_EQ(sections[1].LengthAt(7), 6);
  ExpectContinuous(sections);
}

TEST(CableSections, FromAndToACorner) {
  const Polyline at_corner{{0, 0}, {0, 2}}, beyond{{0, 0}, {0, 2}, {5, 2}};
  const auto away = CableSections({at_corner, beyond, 0}), back = CableSections({beyond, at_corner, 0});
  ASSERT_EQ(away.size(), 1u);
  ASSERT_EQ(back.size(), 1u);
  EXPECT_EQ(away[0].corner, (Point{0, 2}));
  EXPECT_EQ(back[0].corner, (Point{0, 2}));
  EXPECT_EQ(away[0].SlopeAt(0), 1);
  EXPECT_EQ(back[0].SlopeAt(5), -1);
  EXPECT_EQ(back[0].LengthAt(5), 2);
}

TEST(CableSections, OfARobotThatStays) {
  const Polyline cable{{0, 0}, {0, 2}, {3, 6}}, none{{1, 1}};
  const auto sections = CableSections({cable, cable, 1});
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_EQ(sections[0].corner, (Point{0, 2}));
  EXPECT_EQ(sections[0].LengthAt(0), 8);
  EXPECT_EQ(CableSections({none, none, 0})[0].LengthAt(0), 0);
}

}  // namespace
}  // namespace tautline
