// The map of a picture: free ground, blocked ground and the clearance band between them.
#ifndef TAUTLINE_DRAW_GROUND_H_
#define TAUTLINE_DRAW_GROUND_H_

#include <string>
#include <vector>

#include "tautline/draw/legend.h"
#include "tautline/draw/svg_writer.h"
#include "tautline/draw/view.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// Where and how the ground is drawn.
struct GroundOptions {
  Box frame;                            ///< Of the map, pixels.
  std::vector<std::string> tints = {};  ///< Colours of the components, largest first; missing ones are white.
  bool outline_obstacles = false;       ///< Also draws the edges of obstacles that are merged.
};

/// Whether there is no world around: the scene has no outline, and nothing is blocked.
bool IsOpenPlane(const World& world);

/// Starts a document that defines the hatching of the ground.
SvgWriter StartPicture(const SvgWriter::Options& options);

/// Draws the ground: original obstacles and walls grey, what the clearance adds hatched, free
/// ground white; the open plane is all white.
void DrawGround(SvgWriter& svg, const View& view, const World& world, const FreeSpace& space,
                const GroundOptions& options);

/// The legend entries that explain it.
std::vector<LegendEntry> GroundLegend(const FreeSpace& space, int decimals);

/// How many vertices the boundary of the free space has.
std::size_t BoundarySize(const FreeSpace& space);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_GROUND_H_
