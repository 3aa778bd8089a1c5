// list_classes MAP X,Y X,Y METRES: every way, up to homotopy and up to a length, from one point of a map to another,
// shortest first. MAP is a ROS map (.yaml), a MovingAI map (.map) or GeoJSON (.geojson). Each line is a class: the
// length of its shortest path, metres, and its word. The list is complete: what is not in it is longer.
//
// Exit status: 0 there are classes, 2 bad input, 3 there is none within the length.
#include <cstdio>
#include <string>
#include <utility>

#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/scene/map_file.h"

namespace {

int Complain(const std::string& what) {
  std::fprintf(stderr, "list_classes: %s\n", what.c_str());
  return 2;
}

bool ReadPoint(const char* text, tautline::Point& p) {
  return std::sscanf(text, "%lf,%lf", &p.x, &p.y) == 2 && IsFinite(p);
}

}  // namespace

int main(int argc, char** argv) {
  tautline::Point from, to;
  double most = 0;
  if (argc != 5 || !ReadPoint(argv[2], from) || !ReadPoint(argv[3], to) || std::sscanf(argv[4], "%lf", &most) != 1 ||
      !(most >= 0)) {
    return Complain("call it as `list_classes MAP X,Y X,Y METRES`");
  }
  auto map = tautline::ReadMapFile(argv[1]);
  if (!map) return Complain(ToString(map.error()));
  tautline::World world{.outline = std::move(map->outline), .obstacles = std::move(map->obstacles)};
  auto free_space = tautline::BuildFreeSpace(world);
  if (!free_space) return Complain(ToString(free_space.error()));

  // The costly part; any number of questions in the same map can follow.
  const tautline::TautSpace space(*std::move(free_space));
  if (!space.Locate(from) || !space.Locate(to)) return Complain("a point lies in an obstacle or outside of the map");
  const tautline::ClassList list = FindClasses(space, from, to, {.max_length = most});
  for (const tautline::TautPath& path : list.classes) {
    std::printf("%.4f  %s\n", path.length, ToString(path.word, space.rays().names()).c_str());
  }
  if (!list.complete) std::printf("there are more: the search stopped\n");
  return list.classes.empty() ? 3 : 0;
}
