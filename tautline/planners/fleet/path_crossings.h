// Where paths meet, exactly.
#ifndef TAUTLINE_PLANNERS_FLEET_PATH_CROSSINGS_H_
#define TAUTLINE_PLANNERS_FLEET_PATH_CROSSINGS_H_

#include <cstdint>
#include <vector>

#include "tautline/planners/fleet/fleet_plan.h"

namespace tautline {

/// A place on a path.
struct PathSpot {
  std::int32_t segment = 0;  ///< By its first point; at the end of the path, the last point.
  bool at_point = false;     ///< Whether it is exactly that point.
  double along = 0;          ///< How far along the path, metres, rounded.
};

/// What a path does at a part that it shares with another one.
struct PathVisit {
  PathSpot in;              ///< Where it comes to the part.
  PathSpot out;             ///< Where it leaves it.
  Side from = Side::kNone;  ///< The side of the other path from which it comes; kNone where one of both starts or ends.
  Side to = Side::kNone;    ///< Likewise, to which it leaves.
  bool starts = false;      ///< Whether it starts in the part.
  bool ends = false;        ///< Whether it ends in it.
};

/// A connected part that two paths have in common: a point, or a stretch.
struct PathContact {
  RobotId a;           ///< Whose path.
  RobotId b;           ///< Whose other path.
  Point at;            ///< Where b comes to it, metres.
  Point until;         ///< Where b leaves it; `at` unless it is a stretch.
  bool exact = false;  ///< Whether `at` and `until` are exact; otherwise two segments cross there, in their interiors.
  bool against = false;  ///< Whether b runs along the stretch the other way.
  PathVisit of_a;        ///< What the path of a does there.
  PathVisit of_b;        ///< What the path of b does there.

  /// Whether the paths part to the other side than they came from.
  bool crosses() const { return of_b.from != Side::kNone && of_b.to != Side::kNone && of_b.from != of_b.to; }
};

/// All parts that two different paths have in common, for paths by RobotId; ordered by a, b, and the way along a; a <
/// b. A shared stretch is one part. Expected time: that of the pairs of segments with common cells of a BoxIndex, and,
/// for each pair of paths that touch, the product of their lengths; memory: linear in the number of parts.
std::vector<PathContact> FindContacts(const std::vector<RobotPath>& paths);

/// As FindContacts, of the `chosen` paths, as a, with all that are not chosen, as b.
std::vector<PathContact> FindContacts(const std::vector<RobotPath>& paths, const std::vector<RobotId>& chosen);

/// A place to be put in order with others of one path.
struct SpotOnPath {
  PathSpot spot;       ///< Where.
  bool exact = false;  ///< Whether it is at `c`; otherwise where the segment from c to d crosses.
  Point c;             ///< Metres.
  Point d;             ///< Metres.
};

/// The order of two places along a path: -1, 0 for one and the same, or +1. Exact.
int CompareSpots(const RobotPath& path, const SpotOnPath& p, const SpotOnPath& q);

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PATH_CROSSINGS_H_
