// Small scenes with answers worked out by hand, and their pictures: for the tests of this folder.
#ifndef TAUTLINE_DRAW_EXAMPLE_PICTURES_H_
#define TAUTLINE_DRAW_EXAMPLE_PICTURES_H_

#include <string>
#include <vector>

#include "tautline/draw/draw_classes.h"
#include "tautline/draw/draw_plan.h"
#include "tautline/draw/draw_reach.h"
#include "tautline/draw/draw_show.h"
#include "tautline/draw/draw_taut.h"

namespace tautline {

/// A scene with its free space.
struct Example {
  Scene scene;
  FreeSpace space;
};

/// An axis-aligned rectangle, counter-clockwise.
Ring BoxRing(Point low, Point high);

/// A rectangular world with named rectangular obstacles that stay apart, grown by `clearance` with
/// square corners.
struct NamedRectangle {
  std::string name;
  Box box;
};
Example RectangleWorld(Point size, const std::vector<NamedRectangle>& obstacles, double clearance);

/// A room of 20 m x 10 m with four obstacles and a laid cable; the goal asks the robot to go back
/// around the pillar.
Example Room();
PlanResult RoomPlan();

/// Every coordinate and length times `factor`, then moved by `offset`.
Example Scaled(Example example, double factor, Point offset);
PlanResult Scaled(PlanResult result, double factor, Point offset);

/// A finished picture and a name for its file.
struct NamedPicture {
  std::string name;
  std::string svg;
};

/// One picture of every kind, for a person to look at.
std::vector<NamedPicture> ExamplePictures();

}  // namespace tautline

#endif  // TAUTLINE_DRAW_EXAMPLE_PICTURES_H_
