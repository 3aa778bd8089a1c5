// Worlds from bytes, on a coarse lattice so that shapes touch, overlap and line up more often than not.
#ifndef FUZZ_LATTICE_WORLD_H_
#define FUZZ_LATTICE_WORLD_H_

#include <string>
#include <utility>
#include <vector>

#include "fuzz/byte_source.h"
#include "tautline/scene/scene.h"

namespace tautline::fuzz {

/// A lattice of 16 x 16 points somewhere in the plane, and the bytes that choose among them.
class Lattice {
 public:
  /// `spacing` and `origin` in metres.
  Lattice(ByteSource& bytes, double spacing, Point origin) : bytes_(bytes), spacing_(spacing), origin_(origin) {}

  /// The place of a point that need not have whole coordinates.
  Point At(double x, double y) const { return origin_ + spacing_ * Point{x, y}; }

  /// A lattice point, by one byte.
  Point Node() {
    const int byte = bytes_.Byte();
    return At(byte % 16, byte / 16);
  }

  /// A point on the lattice of twice as many lines, by two bytes.
  Point HalfNode() {
    const int x = bytes_.Int(0, 30), y = bytes_.Int(0, 30);
    return At(0.5 * x, 0.5 * y);
  }

  double spacing() const { return spacing_; }
  ByteSource& bytes() { return bytes_; }

 private:
  ByteSource& bytes_;
  double spacing_;
  Point origin_;
};

/// A rectangle, or a polygon that may be anything: crossed, without area, with points that repeat.
inline Ring AnyRing(Lattice& lattice) {
  const int corners = lattice.bytes().Int(0, 7);
  if (corners < 3) {
    const int low = lattice.bytes().Byte(), size = lattice.bytes().Byte();
    const double x = low % 16, y = low / 16, right = x + 1 + size % 4, top = y + 1 + size / 16 % 4;
    return {lattice.At(x, y), lattice.At(right, y), lattice.At(right, top), lattice.At(x, top)};
  }
  Ring ring;
  for (int i = 0; i < corners; ++i) ring.push_back(lattice.Node());
  return ring;
}

inline Obstacle AnyObstacle(Lattice& lattice, std::string name) {
  Obstacle obstacle;
  obstacle.name = std::move(name);
  const int kind = lattice.bytes().Int(0, 7);
  if (kind == 0) {
    const Point centre = lattice.HalfNode();
    obstacle.circle = Circle{centre, lattice.spacing() * 0.5 * lattice.bytes().Int(1, 8)};
    return obstacle;
  }
  obstacle.polygon = PolygonWithHoles{AnyRing(lattice), {}};
  if (kind == 1) obstacle.polygon->holes.push_back(AnyRing(lattice));  // Refused unless it lies inside.
  return obstacle;
}

/// The whole lattice or a polygon in it, with up to ten obstacles.
inline World AnyWorld(Lattice& lattice) {
  World world;
  const bool plain = lattice.bytes().Int(0, 3) > 0;
  world.outline =
      plain ? Ring{lattice.At(0, 0), lattice.At(15, 0), lattice.At(15, 15), lattice.At(0, 15)} : AnyRing(lattice);
  const int count = lattice.bytes().Int(0, 10);
  for (int i = 1; i <= count; ++i) world.obstacles.push_back(AnyObstacle(lattice, "o" + std::to_string(i)));
  return world;
}

}  // namespace tautline::fuzz

#endif  // FUZZ_LATTICE_WORLD_H_
