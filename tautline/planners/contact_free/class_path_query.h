// A path in a given homotopy class: what the baselines are asked for.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_CLASS_PATH_QUERY_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_CLASS_PATH_QUERY_H_

#include <optional>

#include "tautline/homotopy/taut_ground.h"

namespace tautline {

/// From where to where, and in which class.
struct ClassPathQuery {
  Point from;  ///< Of the robot's centre, metres. May stand in a socket.
  Point to;    ///< In the free space.
  Word word;   ///< Of the path, reduced.
};

/// A query whose both ends lie in the free space.
struct OpenClassPathQuery {
  ClassPathQuery open;        ///< From the exit of the socket, with the word from there on.
  std::optional<Point> base;  ///< Where the path starts, if that is in a socket.

  /// A path that answers `open`, led on from the base.
  Polyline FromBase(Polyline path) const;
};

/// The query from where the robot is out of its socket, if it stands in one. Nothing where an end is blocked. Cost: as
/// FindSocket.
std::optional<OpenClassPathQuery> LeaveSocket(const TautGround& ground, const ClassPathQuery& query);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_CLASS_PATH_QUERY_H_
