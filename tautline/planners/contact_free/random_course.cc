#include "tautline/planners/contact_free/random_course.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace tautline {
namespace {

/// Of the robot, and the least way between two obstacles, metres.
constexpr double kRadius = 0.5, kPassage = 1.6;
/// What the robot has around it where it starts and where it goes to, besides its radius.
constexpr double kRoom = 0.25;
/// From base to goal at least, metres.
constexpr double kLeastWay = 6;
/// So often a place is drawn before another course is.
constexpr int kTrials = 200;

Ring RectangleOf(const Box& box) { return {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}; }

double Gap(const Box& a, const Box& b) {
  const double dx = std::max({a.low.x - b.high.x, b.low.x - a.high.x, 0.0});
  const double dy = std::max({a.low.y - b.high.y, b.low.y - a.high.y, 0.0});
  return std::sqrt(dx * dx + dy * dy);
}

/// Obstacles in a rectangle, drawn one by one.
struct Yard {
  Point size;
  std::vector<Box> boxes;

  /// Whether the box leaves passages to all others and to the walls, or stands at a wall.
  bool Fits(const Box& box) const {
    const auto wall = [](double gap) { return gap <= 0 || gap >= kPassage; };
    return wall(box.low.x) && wall(box.low.y) && wall(size.x - box.high.x) && wall(size.y - box.high.y) &&
           std::all_of(boxes.begin(), boxes.end(), [&](const Box& other) { return Gap(box, other) >= kPassage; });
  }
  void Try(const Box& box) {
    if (Fits(box)) boxes.push_back(box);
  }
  bool HasRoom(Point p) const {
    const double room = kRadius + kRoom;
    return p.x >= room && p.y >= room && p.x <= size.x - room && p.y <= size.y - room &&
           std::all_of(boxes.begin(), boxes.end(), [&](const Box& box) {
             return Gap({p, p}, box) >= room;
           });
  }
  Point Draw(Rng& rng) const { return {rng.Uniform(0, size.x), rng.Uniform(0, size.y)}; }
};

Box BoxAt(Point low, double width, double height) { return {low, low + Point{width, height}}; }

void AddDots(Yard& yard, Rng& rng) {
  const double side = rng.Uniform(0.6, 1);
  for (int k = 0; k < 60; ++k) yard.Try(BoxAt(yard.Draw(rng), side, side));
}

/// Two bars across the yard, each with a passage.
void AddBars(Yard& yard, Rng& rng) {
  const double thick = rng.Uniform(0.4, 1.2);
  double y = rng.Uniform(3, 4.5);
  for (int bar = 0; bar < 2; ++bar) {
    const double gap = rng.Uniform(1.8, 2.6), at = rng.Uniform(0.5, yard.size.x - gap - 0.5);
    yard.boxes.push_back(BoxAt({0, y}, at, thick));
    yard.boxes.push_back(BoxAt({at + gap, y}, yard.size.x - at - gap, thick));
    y += thick + rng.Uniform(2.2, 4);
  }
}

void AddRooms(Yard& yard, Rng& rng) {
  for (int k = 0; k < 40; ++k) {
    const bool tall = rng.UniformInt(0, 1) == 1;
    const double length = rng.Uniform(0.6, 4.5), width = rng.Uniform(0.5, 1.4);
    Box box = BoxAt(yard.Draw(rng), tall ? width : length, tall ? length : width);
    // A third of them stand at a wall.
    if (rng.UniformInt(0, 2) == 0) {
      box = BoxAt({rng.UniformInt(0, 1) == 0 ? 0 : yard.size.x - box.size().x, box.low.y}, box.size().x, box.size().y);
    }
    if (box.high.x <= yard.size.x && box.high.y <= yard.size.y) yard.Try(box);
  }
}

Yard DrawYard(Rng& rng) {
  Yard yard{{rng.Uniform(12, 15), rng.Uniform(12, 15)}, {}};
  const int style = rng.UniformInt(0, 2);
  if (style == 0) AddDots(yard, rng);
  if (style == 1) AddBars(yard, rng);
  if (style == 2) AddRooms(yard, rng);
  if (rng.UniformInt(0, 1) == 1) return yard;
  // The same, turned by a quarter.
  Yard turned{{yard.size.y, yard.size.x}, {}};
  for (const Box& box : yard.boxes) turned.boxes.push_back({{box.low.y, box.low.x}, {box.high.y, box.high.x}});
  return turned;
}

Scene SceneOf(const Yard& yard) {
  Scene scene;
  scene.world.outline = RectangleOf({{0, 0}, yard.size});
  for (const Box& box : yard.boxes) {
    scene.world.obstacles.push_back({.name = "o" + std::to_string(scene.world.obstacles.size() + 1),
                                     .polygon = PolygonWithHoles{RectangleOf(box), {}}});
  }
  scene.robot.radius = kRadius;
  return scene;
}

Yard YardOf(const Scene& scene) {
  Yard yard{BoundingBox(scene.world.outline).high, {}};
  for (const Obstacle& obstacle : scene.world.obstacles) yard.boxes.push_back(BoundingBox(obstacle.polygon->outer));
  return yard;
}

std::optional<Point> DrawPlace(const Yard& yard, Rng& rng, std::optional<Point> away_from) {
  for (int trial = 0; trial < kTrials; ++trial) {
    const Point p = yard.Draw(rng);
    if (yard.HasRoom(p) && (!away_from || Distance(*away_from, p) >= kLeastWay)) return p;
  }
  return std::nullopt;
}

}  // namespace

Scene RandomCourse(Rng& rng) {
  for (;;) {
    const Yard yard = DrawYard(rng);
    const auto base = DrawPlace(yard, rng, std::nullopt);
    const auto goal = base ? DrawPlace(yard, rng, base) : std::nullopt;
    if (!goal) continue;
    Scene scene = SceneOf(yard);
    scene.tether = Tether{*base, rng.Uniform(1.3, 2) * (yard.size.x + yard.size.y) * 0.7, std::nullopt};
    scene.goal = *goal;
    return scene;
  }
}

Scene SceneAfter(const Scene& scene, const TetherEnv& driven) {
  Scene now = scene;
  const auto nodes = driven.cable().nodes();
  Polyline laid(nodes.begin(), nodes.end());
  laid.push_back(driven.pose().at);
  now.tether->laid = std::move(laid);
  now.robot.heading = driven.pose().heading_rad;
  return now;
}

Scene NextCourse(const Scene& course, const TetherEnv& driven, Rng& rng) {
  Scene next = SceneAfter(course, driven);
  const auto goal = DrawPlace(YardOf(course), rng, driven.pose().at);
  if (goal) next.goal = *goal;
  return next;
}

}  // namespace tautline
