#include "tautline/planners/fleet/choose_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tautline/base/check.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/path_orders.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/robot_paths.h"
#include "tautline/planners/fleet/tracks.h"

namespace tautline {
namespace {

/// Two travel times that differ by less than this share are the same: they are sums of the same parts.
constexpr double kSameTime = 1e-9;

/// Two total lengths that differ by less than this share are the same.
constexpr double kSameLength = 1e-9;

/// A shortest cable line, alone in the world; nothing where there is none.
std::optional<Route> ShortestRoute(const FleetGround& ground, RobotId robot) {
  const Point start = ground.robot(robot).start, target = ground.robot(robot).target;
  if (ground.space() == nullptr) return Route{{ground.start(robot)}, {ground.target(robot)}};
  if (!ground.space()->Locate(start) || !ground.space()->Locate(target)) return std::nullopt;
  const ClassList found = FindClasses(*ground.space(), start, target, {.max_length = {}, .max_count = 1});
  if (found.classes.empty()) return std::nullopt;
  auto route = ReadRoute(ground, robot, found.classes.front().points);
  return route ? std::optional(*std::move(route)) : std::nullopt;
}

/// How good orders are: fewer faults, then less time, then less cable.
struct Value {
  std::size_t faults = std::numeric_limits<std::size_t>::max();
  double time = 0;
  double length = 0;

  bool BetterThan(const Value& other) const {
    if (faults != other.faults) return faults < other.faults;
    if (std::fabs(time - other.time) > kSameTime * other.time) return time < other.time;
    return length < other.length * (1 - kSameLength);
  }
};

class LayoutSearch {
 public:
  LayoutSearch(const FleetGround& ground, const ChooseOptions& options, const FleetLayout& shortest)
      : ground_(ground), options_(options), paths_(ground, ShortestPaths(ground, shortest)) {}

  ChosenLayout Run() {
    for (const FleetRobot& robot : ground_.robots()) {
      if (robot.tether) measured_ = PlaybackOptions().measured;
    }
    result_.crossings = paths_.crossings().size();
    try {
      Search();
    } catch (const Stopped&) {
      result_.optimal = false;
    }
    if (best_.faults == 0) {
      result_.status = ChooseStatus::kSolved;
      result_.travel_time = best_.time;
      result_.length = best_.length;
    } else {
      Explain();
    }
    return std::move(result_);
  }

 private:
  void Search() {
    best_orders_ = paths_.FirstCome();
    Try(best_orders_);
    const double limit = best_.faults == 0 ? best_.time * (1 + kSameTime) : std::numeric_limits<double>::infinity();
    if (ListOrders(limit)) {
      PlayListed();
    } else {
      TurnOrders();
    }
  }

  void Report() {
    const double share = std::min(1.0, static_cast<double>(result_.played) / static_cast<double>(goal_));
    if (options_.watch && !options_.watch("choosing a layout", share)) throw Stopped();
  }

  /// Plays these orders and keeps them where they are the best so far. Returns whether they are.
  bool Try(const PassingOrders& orders) {
    if (result_.played >= options_.budget) throw Stopped();
    Report();
    const auto time = paths_.TravelTime(orders);
    if (!time) return false;
    ++result_.played;
    FleetLayout layout;
    const Value value = Play(orders, *time, layout);
    if (!value.BetterThan(best_)) return false;
    best_ = value;
    best_orders_ = orders;
    if (value.faults == 0) result_.layout = std::move(layout);
    return true;
  }

  /// Whether the planner would refuse the motion to a layout, since something stands off a way by no more than
  /// rounding.
  bool IsNearMiss(const FleetLayout& layout) const {
    std::vector<Route> routes;
    for (const RobotPath& path : paths_.paths()) routes.push_back(path.route);
    routes.insert(routes.end(), layout.begin(), layout.end());
    return FindNearMiss(ground_, routes).has_value();
  }

  Value Play(const PassingOrders& orders, double time, FleetLayout& layout) {
    constexpr std::size_t kUnplayable = std::numeric_limits<std::size_t>::max() - 1;
    const auto [schedule, passings] = paths_.Schedule(orders);
    const auto playback = tautline::Play(ground_, {}, schedule, passings, {.words_up_to = 0, .measured = measured_});
    if (!playback || !playback->broken.empty()) return {kUnplayable, time, 0};
    Value value{0, time, 0};
    layout = playback->final_routes;
    for (std::size_t i = 0; i < layout.size(); ++i) {
      value.length += LengthOf(ground_, layout[i]);
      const auto& tether = ground_.robots()[i].tether;
      value.faults += tether && playback->longest[i].length > *tether;
    }
    const LayoutFaults faults = CheckLayout(ground_, layout);
    value.faults += faults.crossings.size() + faults.self_loops.size() + faults.starts_enclosed.size();
    if (value.faults == 0 && IsNearMiss(layout)) {
      value.faults = 1;
      near_miss_ = true;
    }
    return value;
  }

  /// Lists all orders that are not later than the limit; false when they are more than the budget.
  bool ListOrders(double limit) {
    preferred_ = best_orders_;
    PassingOrders orders(paths_.crossings().size(), PassingOrder::kOpen);
    for (std::size_t k = 0; k < orders.size(); ++k) {
      if (paths_.crossings()[k].is_given) orders[k] = PassingOrder::kA;
    }
    steps_ = 0;
    return List(0, orders, limit);
  }

  bool List(std::size_t from, PassingOrders& orders, double limit) {
    const auto time = paths_.TravelTime(orders);
    if (!time || *time > limit) return true;
    if (++steps_ > 4 * options_.budget) return false;
    while (from < orders.size() && orders[from] != PassingOrder::kOpen) ++from;
    if (from == orders.size()) {
      listed_.emplace_back(*time, orders);
      return static_cast<std::int64_t>(listed_.size()) < options_.budget;
    }
    for (const bool as_preferred : {true, false}) {
      orders[from] = as_preferred == (preferred_[from] == PassingOrder::kA) ? PassingOrder::kA : PassingOrder::kB;
      if (!List(from + 1, orders, limit)) return false;
    }
    orders[from] = PassingOrder::kOpen;
    return true;
  }

  /// In the order of their travel times, until the best layout is known.
  void PlayListed() {
    std::stable_sort(listed_.begin(), listed_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    goal_ = static_cast<std::int64_t>(listed_.size());
    for (const auto& [time, orders] : listed_) {
      if (best_.faults == 0 && time > best_.time * (1 + kSameTime)) break;
      if (orders != preferred_) Try(orders);
    }
    result_.optimal = best_.faults == 0;
    proved_ = true;
  }

  void Turn(PassingOrders& orders, std::size_t k) const {
    if (paths_.crossings()[k].is_given) return;
    orders[k] = orders[k] == PassingOrder::kA ? PassingOrder::kB : PassingOrder::kA;
  }

  /// Turns single orders, then pairs of orders of one robot, until nothing helps.
  void TurnOrders() {
    goal_ = options_.budget;
    for (bool better = true; better;) {
      better = false;
      for (std::size_t k = 0; k < best_orders_.size(); ++k) better = TryTurned(k, k) || better;
      for (std::size_t k = 0; !better && k < best_orders_.size(); ++k) {
        for (std::size_t l = k + 1; l < best_orders_.size(); ++l) {
          if (ShareRobot(k, l)) better = TryTurned(k, l) || better;
        }
      }
    }
  }

  bool ShareRobot(std::size_t k, std::size_t l) const {
    const PathCrossing &p = paths_.crossings()[k], &q = paths_.crossings()[l];
    return p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b;
  }

  bool TryTurned(std::size_t k, std::size_t l) {
    PassingOrders orders = best_orders_;
    Turn(orders, k);
    if (l != k) Turn(orders, l);
    if (orders == best_orders_) return false;
    const auto time = paths_.TravelTime(orders);
    if (!time || (best_.faults == 0 && *time > best_.time * (1 + kSameTime))) return false;
    return Try(orders);
  }

  void Explain() {
    result_.layout.clear();
    const std::string crossings = std::to_string(result_.crossings) + " crossings of the shortest paths";
    if (proved_) {
      result_.status = ChooseStatus::kInfeasible;
      result_.explanation =
          "whoever passes first at the " + crossings +
          ", no layout comes out that is free of faults and within the tethers: give cable lines, and "
          "robots may take detours";
    } else {
      result_.explanation = "none of " + std::to_string(result_.played) + " orders of passing at the " + crossings +
                            " makes a layout that is free of faults and within the tethers: raise the budget";
    }
    if (near_miss_) result_.explanation += "; or move clear what is all but on a path or cable line, which is a fault";
  }

  const FleetGround& ground_;
  const ChooseOptions& options_;
  PathOrders paths_;
  ChosenLayout result_;
  Value best_;
  PassingOrders best_orders_, preferred_;
  std::vector<std::pair<double, PassingOrders>> listed_;
  std::int64_t steps_ = 0;
  std::int64_t goal_ = 1;
  std::size_t measured_ = 0;  ///< On the way, for the sake of tethers.
  bool proved_ = false;
  bool near_miss_ = false;  ///< Whether a layout would have done but for IsNearMiss.
};

}  // namespace

ChosenLayout ChooseLayout(const FleetGround& ground, const ChooseOptions& options) {
  FleetLayout shortest;
  for (std::size_t i = 0; i < ground.size(); ++i) {
    auto route = ShortestRoute(ground, RobotId(i));
    if (!route) {
      return {.status = ChooseStatus::kInfeasible,
              .explanation = ground.robots()[i].name +
                             " cannot reach its target: one of both is not in the free space, "
                             "or walls part them"};
    }
    shortest.push_back(*std::move(route));
  }
  return LayoutSearch(ground, options, shortest).Run();
}

}  // namespace tautline
