// The picture of a reference path among the classes that it was chosen from.
#ifndef TAUTLINE_DRAW_DRAW_REFERENCE_H_
#define TAUTLINE_DRAW_DRAW_REFERENCE_H_

#include <optional>
#include <string>
#include <vector>

#include "tautline/planners/contact_free/select_reference.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// A path of another method in the class of the reference.
struct BaselinePath {
  std::string method;  ///< "dijkstra" or "voronoi".
  Polyline path;       ///< Metres.
};

/// What the picture shows beside the ground.
struct ReferencePicture {
  ReferenceSelection selection;           ///< By the exact engine.
  std::optional<ReferenceSelection> yen;  ///< As the paper finds it, where asked for.
  std::vector<BaselinePath> baselines;    ///< Where asked for.
};

/// The picture, as SVG: the listed classes numbered by length, the reference with its tether, the laid cable. `space`
/// is the ground of the robot's centre; its growth is hatched. Requires a scene with a tether and a goal.
/// Deterministic.
std::string DrawReference(const Scene& scene, const FreeSpace& space, const ReferencePicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_REFERENCE_H_
