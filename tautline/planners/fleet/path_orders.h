// Robots on fixed paths, and all the orders in which they can pass where these cross.
#ifndef TAUTLINE_PLANNERS_FLEET_PATH_ORDERS_H_
#define TAUTLINE_PLANNERS_FLEET_PATH_ORDERS_H_

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "tautline/planners/fleet/fleet_plan.h"
#include "tautline/planners/fleet/path_crossings.h"

namespace tautline {

/// Two paths cross, perhaps on a part that they share, or one ends on the other.
struct PathCrossing {
  RobotId a;  ///< The robot with the lower number, or the one that must pass first.
  RobotId b;  ///< The other one.
  std::array<double, 2>
      a_along;  ///< How far along its path a is at both ends of the shared part, in its order, metres.
  std::array<double, 2> b_along;  ///< How far b is at the same two ends.
  Point at;                       ///< The first of the two ends, metres.
  bool is_given = false;          ///< Whether a must pass first: the path of b ends here.
};

/// Who passes a crossing first.
enum class PassingOrder : signed char { kOpen, kA, kB };

/// One entry per crossing.
using PassingOrders = std::vector<PassingOrder>;

/// Paths, where they cross, and the earliest times for orders there.
class PathOrders {
 public:
  /// Paths by RobotId. As FindContacts.
  PathOrders(const FleetGround& ground, std::vector<RobotPath> paths);

  /// Where paths cross, by the two robots.
  const std::vector<PathCrossing>& crossings() const { return crossings_; }
  /// The paths, by RobotId.
  const std::vector<RobotPath>& paths() const { return paths_; }

  /// At each crossing, whoever comes there first when nobody waits. A circle only where paths share parts, or end on
  /// others. O(crossings).
  PassingOrders FirstCome() const;

  /// When the last robot arrives, if each drives on as early as the orders allow; nothing when robots wait for each
  /// other in a circle. Open orders allow anything. O(crossings). [Zhang2019, Sec. 4.6]
  std::optional<double> TravelTime(const PassingOrders& orders) const;

  /// The schedule with these times, and who passes first where. Requires that TravelTime has a value and no order is
  /// open. O(crossings log crossings).
  std::pair<std::vector<RobotSchedule>, std::vector<Passing>> Schedule(const PassingOrders& orders) const;

 private:
  /// A robot is at an end of a crossing, of several, at its start, or at its target.
  struct Event {
    RobotId robot;
    double along = 0;
    std::vector<std::pair<std::size_t, int>> ends;  ///< Crossing, and which end of it.
  };

  void AddContact(const PathContact& contact);
  void AddEvents();
  bool IsFirst(RobotId robot, std::size_t crossing, PassingOrder order) const;
  /// By event; empty when there is a circle.
  std::vector<double> Times(const PassingOrders& orders) const;

  std::vector<RobotPath> paths_;
  std::vector<double> speeds_;
  std::vector<PathCrossing> crossings_;
  std::vector<Event> events_;       ///< By robot, then along.
  std::vector<std::size_t> first_;  ///< The first event of each robot, and one past the last.
  std::vector<std::array<std::array<std::size_t, 2>, 2>> event_at_;  ///< By crossing, a or b, end.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_FLEET_PATH_ORDERS_H_
