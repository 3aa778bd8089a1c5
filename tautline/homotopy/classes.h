// The homotopy classes between two points, shortest first.
#ifndef TAUTLINE_HOMOTOPY_CLASSES_H_
#define TAUTLINE_HOMOTOPY_CLASSES_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "tautline/homotopy/goal_field.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/homotopy/taut_space.h"

namespace tautline {

/// Where the list of classes ends.
struct ClassOptions {
  std::optional<double> max_length;       ///< Metres; only classes whose taut path is no longer.
  std::optional<std::int64_t> max_count;  ///< Only the so many shortest.
  std::int64_t budget = 1'000'000;        ///< Expanded search states after which the list ends incomplete.
  KeepGoing keep_going = {};              ///< Asked now and then; at a no the list ends as at the budget's end.
};

/// The classes that were found, and whether they are all.
struct ClassList {
  std::vector<TautPath> classes;  ///< Shortest first; equal lengths by word.
  bool complete = false;          ///< No class up to max_length is missing.
  /// The search stopped at its budget; longer classes may be missing.
  bool budget_exceeded = false;
};

/// Enumerates taut walks from `from` to `to`, each the one shortest path of its class, in order of length. Finite and
/// complete when max_length is given and the budget suffices. Empty and complete when the points lie in different
/// components. Requires both points in the free space of `space`. One backward Dijkstra over the directed edges of
/// the reduced visibility graph, then O(log) per state; every expanded state leads to a listed class. Where an end lies
/// on a vertex at which obstacles touch, one word may stand for several classes.
ClassList FindClasses(const TautSpace& space, Point from, Point to, const ClassOptions& options = {});

/// The same for paths that go on from where a walk stands: on a vertex where blocked ground touches they leave within
/// the sector that the walk came in by, and there may be none.
ClassList FindClassesOnward(const TautSpace& space, const Walk& walk, Place to, const ClassOptions& options = {});

/// The shortest of those paths, whatever its length and however many classes tie: nothing when the walk and the place
/// are not connected. Looks at the part of the visibility graph between the two.
std::optional<TautPath> FindShortestOnward(const TautSpace& space, const Walk& walk, Place to);

/// The same to the goal of a field that serves other searches, too. Grows the field as far as it must, then O(degree)
/// per corner of the path.
std::optional<Polyline> FindShortestOnward(const TautSpace& space, const Walk& walk, const GoalDistances& field);

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_CLASSES_H_
