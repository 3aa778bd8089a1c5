// The two graphs of a fleet's plan, drawn: who passes before whom, and in which order events happen [Zhang2019, Sec.
// 4].
#ifndef TAUTLINE_DRAW_FLEET_GRAPHS_H_
#define TAUTLINE_DRAW_FLEET_GRAPHS_H_

#include <string>
#include <vector>

#include "tautline/draw/svg_writer.h"
#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// Draws the pair interaction graph into a frame of pixels: robots on a circle, an arrow from the robot that passes a
/// crossing first to the other, with the crossing's label; pair deadlocks as red double arrows. Robots on a detour are
/// ringed in red.
void DrawPairGraph(SvgWriter& svg, const Box& frame, const FleetGround& ground, const FleetPlan& plan);

/// The event graph of the straight paths, ready to be drawn: one chain of events for each robot, and an arrow from the
/// first passage of each crossing to the second. What lies on a circle, so that it cannot happen in any order, is red.
class EventGraphDrawing {
 public:
  /// Lays the events out in columns such that arrows lead to the right, as far as they can. O(events * crossings).
  explicit EventGraphDrawing(const FleetPlan& plan);

  /// How many columns it takes.
  std::size_t columns() const { return columns_; }
  /// How many rows it takes.
  std::size_t rows() const { return chains_.size(); }
  /// Whether some events wait for each other in a circle.
  bool has_circle() const;

  /// Draws it into a frame of pixels.
  void Draw(SvgWriter& svg, const Box& frame, const FleetGround& ground) const;

 private:
  /// A robot passes one or more crossings at one place.
  struct Event {
    std::size_t robot;
    double along;
    std::string label;
    std::size_t column = 0;
    bool in_circle = false;
    std::vector<std::size_t> later;  ///< Events that must not be earlier.
  };

  std::size_t AddEvent(std::size_t robot, double along, const std::string& label);
  void FindCircles();
  void PlaceColumns();
  bool OnOneCircle(std::size_t a, std::size_t b) const;

  std::vector<Event> events_;
  std::vector<std::vector<std::size_t>> chains_;  ///< By robot, in order along its path.
  std::vector<std::vector<bool>> reaches_;        ///< By two events.
  std::vector<std::pair<std::size_t, std::size_t>> orders_;
  std::size_t columns_ = 0;
};

}  // namespace tautline

#endif  // TAUTLINE_DRAW_FLEET_GRAPHS_H_
