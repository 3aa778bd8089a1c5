// The best next heading from everywhere: a plan for each point of a grid, for a controller.
#ifndef TAUTLINE_PLANNERS_TETHER_PLAN_FIELD_H_
#define TAUTLINE_PLANNERS_TETHER_PLAN_FIELD_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/base/stop.h"
#include "tautline/planners/tether/tether_planner.h"

namespace tautline {

/// How fine the field is, and when it stops.
struct PlanFieldOptions {
  std::optional<double> resolution = {};  ///< Metres between points of the grid; default: DefaultResolution.
  std::int64_t classes = 1;               ///< At each point, the so many classes with the shortest tethers.
  std::int64_t budget = 5'000'000;        ///< Of each search, as in PlanOptions.
  KeepGoing keep_going = {};              ///< Asked now and then; after a no the rows are incomplete.
  Watcher watch = {};                     ///< Told of the share of rows by PlanField::All; may stop it.
};

/// What a robot does at one point whose tether lies in one class.
struct FieldSample {
  int column = 0;                     ///< Of the grid.
  int row = 0;                        ///< Of the grid.
  Point at;                           ///< Where the robot stands, metres.
  TautPath tether;                    ///< How its tether lies, taut, base first.
  std::optional<double> heading_rad;  ///< Where it drives next, from the x axis counter-clockwise; nothing at the goal.
  double length = 0;                  ///< Of its whole way to the goal, metres.
};

/// One row of the grid.
struct FieldRow {
  std::vector<FieldSample> samples;  ///< By column, and at each point by the length of the tether.
  bool complete = true;              ///< No budget ran out and nobody said stop.
};

/// The points of the field: the centres of square cells that cover the world.
struct FieldGrid {
  Point low;              ///< The lower left corner of the first cell, metres.
  double resolution = 0;  ///< The side of a cell, metres.
  int columns = 0;        ///< Cells in x.
  int rows = 0;           ///< Cells in y.

  /// The centre of a cell.
  Point At(int column, int row) const { return low + resolution * Point{column + 0.5, row + 0.5}; }
};

/// Two digits, such that the longer side of the box has about 100 points.
double DefaultResolution(const Box& box);

/// The plans from all points of a grid to one goal. The goal is prepared once; a row is computed at a time, so that a
/// caller can use as many threads as it likes. Immutable; valid as long as the planner. A sample is what Plan answers
/// for a robot that stands there with its cable laid along the taut curve of the class.
class PlanField {
 public:
  /// Prepares goal and base. Only base and length of the tether count. Errors: a resolution that is not positive and
  /// finite, or so fine that the grid has more than four million points. O(e log e) for e edges of the visibility
  /// graph.
  [[nodiscard]] static Expected<PlanField> Prepare(const TetherPlanner& planner, const Tether& tether, Point goal,
                                                   const PlanFieldOptions& options = {});

  /// The plan of a robot at the base: where it has none, there is none from anywhere, for the same reason.
  const PlanResult& from_base() const { return from_base_; }

  /// Where the points are.
  const FieldGrid& grid() const { return grid_; }

  /// The samples of a row that the tether can reach. Classes of more than the first cost a search each point; the rest
  /// O(degree) per corner of tether and path, and a search where the tether forbids the shortest way.
  FieldRow Row(int row) const;

  /// All rows, one after the other, as one. Incomplete when the watcher said stop.
  FieldRow All() const;

 private:
  PlanField(const TetherPlanner& planner, const Tether& tether, Point goal, const PlanFieldOptions& options);

  std::vector<TautPath> TethersTo(Place place) const;
  std::optional<TautPath> ShortestTetherTo(Place place) const;
  void AddSamples(int column, int row, FieldRow& samples) const;

  const TetherPlanner* planner_;
  Tether tether_;  ///< Without a laid cable.
  PlanFieldOptions options_;
  FieldGrid grid_;
  PlanResult from_base_;
  PreparedGoal goal_;
  std::optional<Socket> socket_;
  /// The distances from the base to everywhere. Nothing where it stands on a vertex at which blocked ground touches:
  /// there the way out matters, and each point is searched for on its own.
  std::unique_ptr<const GoalField> to_base_;
};

/// The direction of a path's first step, radians counter-clockwise from the x axis; nothing where it does not move.
std::optional<double> FirstHeading(const Polyline& path);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_TETHER_PLAN_FIELD_H_
