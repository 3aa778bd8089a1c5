// The picture of a tour over tasks inside a workspace.
#ifndef TAUTLINE_DRAW_DRAW_TOUR_H_
#define TAUTLINE_DRAW_DRAW_TOUR_H_

#include <string>

#include "tautline/planners/cable_workspace/tour.h"
#include "tautline/scene/free_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// What the picture of a tour shows.
struct TourPicture {
  const Anchors& anchors;                        ///< Of all cables.
  const WorkspaceBoundary& boundary;             ///< Of the workspace.
  const TourStops& stops;                        ///< As asked for.
  const tl::expected<Tour, OutsideFault>& tour;  ///< Or why there is none.
};

/// The workspace with the path of the tour and the tasks, numbered in the order in which they are visited. Without a
/// tour, what is outside. Deterministic.
std::string DrawTour(const Scene& scene, const FreeSpace& space, const TourPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_TOUR_H_
