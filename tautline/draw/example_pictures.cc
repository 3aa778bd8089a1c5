#include "tautline/draw/example_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace tautline {
namespace {

Point Mapped(Point p, double factor, Point offset) { return factor * p + offset; }

void Map(std::vector<Point>& points, double factor, Point offset) {
  for (Point& p : points) p = Mapped(p, factor, offset);
}

void Map(TautPath& path, double factor, Point offset) {
  Map(path.points, factor, offset);
  path.length *= factor;
}

Box Grown(const Box& box, double by) { return {box.low - Point{by, by}, box.high + Point{by, by}}; }

Word Letters(const std::vector<int>& letters) {
  Word word;
  for (const int letter : letters) {
    word.Append({ObstacleId(static_cast<std::size_t>(std::abs(letter) - 1)), letter < 0});
  }
  return word;
}

TautPath Path(Polyline points, const std::vector<int>& letters) {
  const double length = Length(points);
  return {std::move(points), length, Letters(letters)};
}

/// The classes of the room from the base to the goal, made up of corners of its grown obstacles.
std::vector<TautPath> RoomClasses() {
  const Point base{1, 1}, g{18, 2};
  const Point cart_ul{7.7, 2.3}, cart_ur{9.3, 2.3}, cart_ll{7.7, 0.7}, cart_lr{9.3, 0.7};
  const Point pillar_ul{3.7, 6.3}, pillar_ur{6.3, 6.3}, pillar_lr{6.3, 3.7}, pillar_ll{3.7, 3.7};
  const Point tank_ll{12.7, 5.2}, tank_ul{12.7, 7.8}, tank_ur{15.3, 7.8}, tank_lr{15.3, 5.2};
  std::vector<TautPath> classes = {
      Path({base, cart_ll, cart_lr, g}, {}),
      Path({base, cart_ul, cart_ur, g}, {2}),
      Path({base, pillar_ul, pillar_ur, g}, {1, 2}),
      Path({base, pillar_ul, pillar_ur, cart_ll, cart_lr, g}, {1}),
      Path({base, pillar_ul, pillar_ur, tank_ul, tank_ur, {18, 2}}, {1, 2, 3}),
      Path({base, pillar_lr, tank_ul, tank_ur, g}, {2, 3}),
      Path({base, tank_lr, tank_ur, tank_ul, tank_ll, g}, {2, -3}),
      Path({base, pillar_lr, pillar_ur, pillar_ul, pillar_ll, g}, {-1, 2}),
      Path({base, pillar_lr, pillar_ur, pillar_ul, pillar_ll, cart_ll, cart_lr, g}, {-1}),
      Path({base, pillar_ul, pillar_ur, tank_lr, tank_ur, tank_ul, tank_ll, g}, {1, 2, -3}),
      Path({base, pillar_ul, pillar_ur, pillar_lr, pillar_ll, pillar_ul, pillar_ur, g}, {1, 1, 2}),
      Path({base, cart_ul, cart_ur, cart_lr, cart_ll, cart_ul, cart_ur, g}, {2, 2}),
      Path({base, cart_ll, cart_lr, tank_lr, tank_ur, tank_ul, tank_ll, g}, {-3}),
      Path({base, pillar_lr, pillar_ur, pillar_ul, pillar_ll, tank_ul, tank_ur, g}, {-1, 2, 3}),
      Path({base, pillar_ul, pillar_ur, pillar_lr, pillar_ll, pillar_ul, pillar_ur, tank_ul, tank_ur, g},
           {1, 1, 2, 3})};
  std::stable_sort(classes.begin(), classes.end(),
                   [](const TautPath& a, const TautPath& b) { return a.length < b.length; });
  return classes;
}

PlanResult Infeasible(PlanObstruction obstruction, std::string explanation) {
  PlanResult result = RoomPlan();
  result.obstruction = obstruction;
  result.explanation = std::move(explanation);
  result.status = PlanStatus::kInfeasible;
  result.motion.reset();
  result.rejected.reset();
  return result;
}

std::string TooShort() {
  const Example room = Room();
  PlanResult result = Infeasible(PlanObstruction::kTetherTooShort,
                                 "The goal cannot be reached: the least tether of all classes is 17.10 m long, and "
                                 "the tether has 14.00 m.");
  result.limit = 14;
  result.shortest_tether = RoomClasses()[0];
  result.rejected = RoomPlan().rejected;
  return DrawPlan(room.scene, room.space, result);
}

std::string LaidTooLong() {
  const Example room = Room();
  PlanResult result = Infeasible(PlanObstruction::kLaidCableTooLong, "");
  result.limit = 9;
  return DrawPlan(room.scene, room.space, result);
}

std::string LaidBlocked() {
  Example room = Room();
  room.scene.tether->laid = Polyline{{1, 1}, {3, 5}, {5, 4.2}, {8, 4}, {14, 6.5}, {16.5, 8}};
  PlanResult result =
      Infeasible(PlanObstruction::kLaidCableBlocked, "The laid cable enters the clearance of pillar at (3.7, 4.72).");
  result.start = {};
  return DrawPlan(room.scene, room.space, result);
}

std::string GoalBlocked() {
  Example room = Room();
  room.scene.goal = Point{14.2, 6.3};
  return DrawPlan(room.scene, room.space,
                  Infeasible(PlanObstruction::kGoalBlocked, "The goal (14.2, 6.3) lies inside of tank."));
}

/// A building of three rooms without doors between them, specks, merges and snaps.
Example Building() {
  Example example = RectangleWorld({30, 14},
                                   {{"desk", {{2, 2}, {5, 3.5}}},
                                    {"a long cupboard <&\">", {{2, 9}, {3, 12}}},
                                    {"bin", {{7, 6}, {7.5, 6.5}}},
                                    {"crates", {{14, 4}, {17, 8}}},
                                    {"x1", {{23, 2}, {23.2, 2.2}}},
                                    {"x2", {{26, 10}, {26.2, 10.2}}}},
                                   0.25);
  FreeSpace& space = example.space;
  const std::vector<BoundaryRing> holes = space.components[0].holes;
  const auto room = [](double left, double right) {
    FreeComponent component;
    component.outer.points = BoxRing({left, 0.25}, {right, 13.75});
    component.area = (right - left) * 13.5;
    return component;
  };
  space.components = {room(0.25, 9.75), room(10.25, 19.75), room(20.25, 29.75)};
  space.components[0].holes = {holes[0], holes[1], holes[2]};
  space.components[1].holes = {holes[3]};
  space.components[2].holes = {holes[4], holes[5]};
  for (const double x : {10.0, 20.0}) {
    example.scene.world.obstacles.push_back({.name = "wall" + std::to_string(static_cast<int>(x)),
                                             .polygon = PolygonWithHoles{BoxRing({x - 0.05, 0}, {x + 0.05, 14}), {}},
                                             .circle = {},
                                             .representative = {}});
  }
  space.merges = {{{"crates", "pallet", "o7"}, false}, {{"wall10"}, true}, {{"wall20"}, true}};
  space.snap = 1e-6;
  space.snaps = {{"pallet", {17, 4}, {17, 4}, "crates"}};
  example.scene.path = "scenes/building.yaml";
  example.scene.tether = Tether{.base = {8.5, 1}, .length = 20, .laid = Polyline{{8.5, 1}, {6, 5}, {4, 6}, {5, 11}}};
  example.scene.goal = Point{24, 7};
  return example;
}

std::string Unreachable() {
  const Example building = Building();
  PlanResult result = Infeasible(PlanObstruction::kGoalUnreachable,
                                 "Walls separate the goal (24, 7) from the robot (5, 11): no path of any length.");
  result.start = Path({{8.5, 1}, {7.75, 6.75}, {5, 11}}, {});
  return DrawPlan(building.scene, building.space, result);
}

/// Hundreds of specks on a lattice, few of them on the way.
Example Specks() {
  std::vector<NamedRectangle> specks;
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < 18; ++j) {
      const Point low{4.0 * i + 2 + 0.3 * ((7 * i + 3 * j) % 5), 4.0 * j + 2 + 0.3 * ((5 * i + j) % 4)};
      const double side = (i * j) % 37 == 5 ? 2 : 0.5;
      specks.push_back({"o" + std::to_string(specks.size() + 1), {low, low + Point{side, side}}});
    }
  }
  Example example = RectangleWorld({98, 75}, specks, 0);
  example.scene.tether = Tether{.base = {1, 1}, .length = 120, .laid = {}};
  example.scene.goal = Point{90, 60.5};
  return example;
}

std::string SpecksPlan() {
  const Example specks = Specks();
  PlanResult result;
  result.status = PlanStatus::kSolved;
  result.limit = 120;
  const TautPath way = Path({{1, 1}, {46.5, 31.2}, {90, 60.5}}, {20, 58, -140, 201});
  result.start = Path({{1, 1}}, {});
  result.motion = Motion{way, way};
  return DrawPlan(specks.scene, specks.space, result);
}

std::string AllClasses() {
  const Example room = Room();
  PlanResult result = RoomPlan();
  const TautPath tether = result.motion->tether;
  result.all = {*result.motion};
  for (const TautPath& path : RoomClasses()) {
    if (result.all.size() < 5) result.all.push_back({Path(path.points, {}), tether});
  }
  return DrawPlan(room.scene, room.space, result);
}

std::string Classes() {
  const Example room = Room();
  return DrawClasses(room.scene, room.space, {.from = {1, 1}, .to = {18, 2}, .list = {.classes = RoomClasses()}});
}

std::string Narrow(Point size, Point base, Point goal) {
  Example example = RectangleWorld(size, {{"post", {{0.4 * size.x, 0.65 * size.y}, {0.45 * size.x, 0.7 * size.y}}}}, 0);
  example.scene.tether = Tether{.base = base, .length = 200, .laid = {}};
  example.scene.goal = goal;
  PlanResult result;
  result.status = PlanStatus::kSolved;
  result.limit = 200;
  result.motion = Motion{Path({base, goal}, {}), Path({base, goal}, {})};
  return DrawPlan(example.scene, example.space, result);
}

std::string PlanScaled(double factor, Point offset) {
  const Example room = Scaled(Room(), factor, offset);
  return DrawPlan(room.scene, room.space, Scaled(RoomPlan(), factor, offset));
}

std::string Taut() {
  const Example room = Room();
  return DrawTaut(room.scene, room.space, {.laid = *room.scene.tether->laid, .taut = RoomPlan().start});
}

std::string ReachPicture(const ReachOptions& options, Point base = {1, 1}, double length = 9) {
  Example room = Room();
  room.scene.tether = Tether{.base = base, .length = length, .laid = {}};
  return DrawReach(room.scene, room.space, Reach(room.scene, options).value());
}

}  // namespace

Ring BoxRing(Point low, Point high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

Example RectangleWorld(Point size, const std::vector<NamedRectangle>& obstacles, double clearance) {
  Example example;
  World& world = example.scene.world;
  FreeSpace& space = example.space;
  world.outline = BoxRing({0, 0}, size);
  world.clearance = space.clearance = clearance;
  space.box = {{0, 0}, size};
  FreeComponent component;
  const Point inset{clearance, clearance};
  component.outer.points = BoxRing(inset, size - inset);
  component.area = (size.x - 2 * clearance) * (size.y - 2 * clearance);
  for (const NamedRectangle& obstacle : obstacles) {
    const Box grown = Grown(obstacle.box, clearance);
    const Ring ring = BoxRing(grown.low, grown.high);
    world.obstacles.push_back({.name = obstacle.name,
                               .polygon = PolygonWithHoles{BoxRing(obstacle.box.low, obstacle.box.high), {}},
                               .circle = {},
                               .representative = {}});
    component.holes.push_back({Ring(ring.rbegin(), ring.rend()), ObstacleId(space.islands.size())});
    space.islands.push_back({obstacle.name, grown.centre(), {obstacle.name}, SignedArea(ring)});
    component.area -= SignedArea(ring);
  }
  space.components = {component};
  return example;
}

Example Room() {
  Example room = RectangleWorld({20, 10},
                                {{"pillar", {{4, 4}, {6, 6}}},
                                 {"cart", {{8, 1}, {9, 2}}},
                                 {"tank", {{13, 5.5}, {15, 7.5}}},
                                 {"p", {{17.2, 8.2}, {17.5, 8.5}}}},
                                0.3);
  room.scene.path = "scenes/room.yaml";
  room.scene.tether = Tether{
      .base = {1, 1}, .length = 18, .laid = Polyline{{1, 1}, {1.5, 4}, {3, 6.8}, {5.2, 8}, {8.5, 7.6}, {10, 5.5}}};
  room.scene.goal = Point{18, 2};
  return room;
}

PlanResult RoomPlan() {
  PlanResult result;
  result.status = PlanStatus::kSolved;
  result.limit = 18;
  const Point robot{10, 5.5}, goal{18, 2};
  result.start = Path({{1, 1}, {3.7, 6.3}, {6.3, 6.3}, robot}, {1});
  result.motion = Motion{Path({robot, {6.3, 6.3}, {3.7, 6.3}, {3.7, 3.7}, goal}, {-1, 2}),
                         Path({{1, 1}, {7.7, 2.3}, {9.3, 2.3}, goal}, {2})};
  result.rejected = Motion{Path({robot, goal}, {}), Path({{1, 1}, {3.7, 6.3}, {6.3, 6.3}, goal}, {1, 2})};
  return result;
}

Example Scaled(Example example, double factor, Point offset) {
  World& world = example.scene.world;
  FreeSpace& space = example.space;
  Map(world.outline, factor, offset);
  for (Obstacle& obstacle : world.obstacles) Map(obstacle.polygon->outer, factor, offset);
  for (FreeComponent& component : space.components) {
    Map(component.outer.points, factor, offset);
    for (BoundaryRing& hole : component.holes) Map(hole.points, factor, offset);
  }
  for (Island& island : space.islands) island.representative = Mapped(island.representative, factor, offset);
  space.box = {Mapped(space.box.low, factor, offset), Mapped(space.box.high, factor, offset)};
  world.clearance = space.clearance = factor * space.clearance;
  if (example.scene.tether) {
    Tether& tether = *example.scene.tether;
    tether.base = Mapped(tether.base, factor, offset);
    tether.length *= factor;
    if (tether.laid) Map(*tether.laid, factor, offset);
  }
  if (example.scene.goal) example.scene.goal = Mapped(*example.scene.goal, factor, offset);
  return example;
}

PlanResult Scaled(PlanResult result, double factor, Point offset) {
  result.limit *= factor;
  Map(result.start, factor, offset);
  for (std::optional<Motion>* motion : {&result.motion, &result.rejected}) {
    if (!*motion) continue;
    Map((*motion)->path, factor, offset);
    Map((*motion)->tether, factor, offset);
  }
  return result;
}

std::vector<NamedPicture> ExamplePictures() {
  const Example room = Room(), building = Building(), specks = Specks();
  return {{"plan", DrawPlan(room.scene, room.space, RoomPlan())},
          {"plan_all", AllClasses()},
          {"plan_too_short", TooShort()},
          {"plan_laid_too_long", LaidTooLong()},
          {"plan_laid_blocked", LaidBlocked()},
          {"plan_goal_blocked", GoalBlocked()},
          {"plan_unreachable", Unreachable()},
          {"plan_specks", SpecksPlan()},
          {"plan_wide", Narrow({100, 4}, {2, 1}, {95, 3})},
          {"plan_tall", Narrow({4, 60}, {1, 2}, {3, 55})},
          {"plan_tiny", PlanScaled(1e-4, {0, 0})},
          {"plan_huge", PlanScaled(1e5, {1e7, -3e7})},
          {"classes", Classes()},
          {"reach", ReachPicture({})},
          {"reach_sheets", ReachPicture({.sheets = true}, {1, 1}, 16)},
          {"reach_at", ReachPicture({.at = Point{16, 8.5}})},
          {"reach_at_blocked", ReachPicture({.at = Point{5, 5}})},
          {"reach_stopped", ReachPicture({.sheets = true, .budget = 20}, {1, 1}, 40)},
          {"reach_blocked", ReachPicture({}, {5, 5})},
          {"taut", Taut()},
          {"show", DrawShow(building.scene, building.space)},
          {"show_specks", DrawShow(specks.scene, specks.space)}};
}

}  // namespace tautline
