// The picture of a field: where to drive next from everywhere.
#ifndef TAUTLINE_DRAW_DRAW_FIELD_H_
#define TAUTLINE_DRAW_DRAW_FIELD_H_

#include <span>
#include <string>

#include "tautline/planners/tether/plan_field.h"
#include "tautline/scene/free_space.h"

namespace tautline {

/// What the picture of a field shows.
struct FieldPicture {
  const PlanResult& from_base;           ///< Why the field is empty, where it is.
  FieldGrid grid;                        ///< Of the samples.
  std::span<const FieldSample> samples;  ///< By row, column and class.
};

/// The picture, as SVG, of a field: at each point an arrow to where the robot drives next; the first class at a point
/// dark, further ones light. Where points lie too densely, arrows stand for only some of them. `space` is the free
/// space of the scene's world. Deterministic.
std::string DrawField(const Scene& scene, const FreeSpace& space, const FieldPicture& picture);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_FIELD_H_
