// The picture of the homotopy classes between two points.
#ifndef TAUTLINE_DRAW_DRAW_CLASSES_H_
#define TAUTLINE_DRAW_DRAW_CLASSES_H_

#include <string>

#include "tautline/homotopy/classes.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// What the picture shows beside the ground.
struct ClassesPicture {
  Point from;      ///< Where all paths start, metres.
  Point to;        ///< Where they end, metres.
  ClassList list;  ///< Shortest first, as FindClasses returns them.
};

/// The picture, as SVG, of the classes between two points: the shortest numbered and listed with
/// length and word, some more as thin lines. `space` is the free space of the scene's world.
/// Deterministic.
std::string DrawClasses(const Scene& scene, const FreeSpace& space, const ClassesPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_CLASSES_H_
