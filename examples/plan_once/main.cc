#include <cstdio>

#include "tautline/planners/tether/plan.h"

int main() {
  tautline::Scene scene;
  scene.world.outline = {{0, 0}, {16, 0}, {16, 10}, {0, 10}};
  scene.world.obstacles = {
      {.name = "block", .polygon = tautline::PolygonWithHoles{{{4, 3}, {12, 3}, {12, 7}, {4, 7}}}}};
  scene.tether = {.base = {2, 5}, .length = 12.8, .laid = {{{2, 5}, {4, 7}, {12, 7}, {13, 6}}}};
  scene.goal = {13, 4};
  const auto result = tautline::Plan(scene);
  if (!result) return std::fprintf(stderr, "%s\n", ToString(result.error()).c_str()), 2;
  if (!result->motion) return std::printf("no motion: %s\n", result->explanation.c_str()), 3;
  for (const tautline::Point p : result->motion->path.points) std::printf("%g %g\n", p.x, p.y);
}
