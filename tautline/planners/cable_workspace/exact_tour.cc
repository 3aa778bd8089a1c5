#include "tautline/planners/cable_workspace/exact_tour.h"

#include <algorithm>
#include <limits>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Sums of the same distances in another order differ by less than this share of the tour.
constexpr double kSummedOtherwise = 1e-12;

/// The length that is still to come, by the set of tasks that are done and the last of them.
class ToCome {
 public:
  explicit ToCome(const TourDistances& distances)
      : distances_(distances), tasks_(distances.tasks()), metres_(tasks_ << tasks_, 0) {
    const std::size_t all = (std::size_t{1} << tasks_) - 1;
    for (std::size_t last = 0; last < tasks_; ++last) metres_[Index(all, last)] = distances_(last, distances_.end());
    for (std::size_t done = all; done-- > 1;) {
      for (std::size_t last = 0; last < tasks_; ++last) {
        if (done >> last & 1) metres_[Index(done, last)] = Least(done, last);
      }
    }
  }

  /// After a set of tasks, from a node on.
  double Least(std::size_t done, std::size_t from) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t next = 0; next < tasks_; ++next) {
      if (!(done >> next & 1)) least = std::min(least, Over(done, from, next));
    }
    return least;
  }

  /// When `next` comes next.
  double Over(std::size_t done, std::size_t from, std::size_t next) const {
    return distances_(from, next) + metres_[Index(done | std::size_t{1} << next, next)];
  }

 private:
  std::size_t Index(std::size_t done, std::size_t last) const { return done * tasks_ + last; }

  const TourDistances& distances_;
  std::size_t tasks_;
  std::vector<double> metres_;
};

}  // namespace

std::vector<std::size_t> FindExactTour(const TourDistances& distances) {
  const std::size_t tasks = distances.tasks();
  TAUTLINE_CHECK(tasks <= kMostExactTasks);
  std::vector<std::size_t> order;
  if (tasks == 0) return order;
  const ToCome to_come(distances);
  const double slack = kSummedOtherwise * to_come.Least(0, distances.start());
  std::size_t done = 0, at = distances.start();
  while (order.size() < tasks) {
    const double least = to_come.Least(done, at);
    for (std::size_t next = 0; next < tasks; ++next) {
      if ((done >> next & 1) || to_come.Over(done, at, next) > least + slack) continue;
      order.push_back(next);
      break;
    }
    at = order.back();
    done |= std::size_t{1} << at;
  }
  return order;
}

}  // namespace tautline
