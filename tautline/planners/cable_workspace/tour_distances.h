// What the shortest order of tasks is sought by: the distances between them.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_DISTANCES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_DISTANCES_H_

#include <cstddef>
#include <span>
#include <vector>

namespace tautline {

/// Symmetric distances between tasks, the start and the end of a tour, metres. The nodes are the tasks by position,
/// then the start, then the end, which may be one place.
class TourDistances {
 public:
  /// All zero.
  explicit TourDistances(std::size_t tasks) : tasks_(tasks), metres_((tasks + 2) * (tasks + 2), 0) {}

  std::size_t tasks() const { return tasks_; }      ///< How many.
  std::size_t start() const { return tasks_; }      ///< The node of the start.
  std::size_t end() const { return tasks_ + 1; }    ///< The node of the end.
  std::size_t nodes() const { return tasks_ + 2; }  ///< How many in all.

  /// Between two nodes.
  double operator()(std::size_t a, std::size_t b) const { return metres_[a * nodes() + b]; }
  /// Sets it in both directions.
  void Set(std::size_t a, std::size_t b, double metres) {
    metres_[a * nodes() + b] = metres;
    metres_[b * nodes() + a] = metres;
  }

 private:
  std::size_t tasks_;
  std::vector<double> metres_;
};

/// The length of the tour from the start over the tasks in an order to the end.
inline double TourLength(const TourDistances& distances, std::span<const std::size_t> order) {
  double length = 0;
  std::size_t at = distances.start();
  for (const std::size_t task : order) {
    length += distances(at, task);
    at = task;
  }
  return length + distances(at, distances.end());
}

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_TOUR_DISTANCES_H_
