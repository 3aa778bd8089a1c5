// A drive as samples over time.
#ifndef TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_TRACE_H_
#define TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_TRACE_H_

#include <vector>

#include "tautline/planners/grid_manifold/drive.h"

namespace tautline {

/// A moment of a drive.
struct DriveFrame {
  double t_s = 0;  ///< From the start.
  Point robot;     ///< Metres.
  Polyline cable;  ///< From base to robot, metres.
};

/// How a drive is sampled.
struct TraceOptions {
  double sample_s = 0.5;       ///< Between samples, at least; positive.
  double tolerance_m = 0.002;  ///< Nodes no farther than this from the line without them are left out.
};

/// Drives the way again and takes samples: the beginning, the first moment after each sample_s, the end. Throws
/// std::logic_error if the drive does not end as `result` says. O(simulation + samples * nodes).
std::vector<DriveFrame> TraceDrive(const GridManifold& manifold, const DriveState& start, const DriveResult& result,
                                   const RobotOptions& robot, const TraceOptions& options);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_GRID_MANIFOLD_DRIVE_TRACE_H_
