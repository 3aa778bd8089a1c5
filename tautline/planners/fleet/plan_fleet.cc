#include "tautline/planners/fleet/plan_fleet.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/fleet/playback.h"
#include "tautline/planners/fleet/robot_paths.h"
#include "tautline/planners/fleet/schedule.h"
#include "tautline/planners/fleet/tracks.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

std::size_t IndexOf(FleetMode mode) { return static_cast<std::size_t>(mode); }

Passing PassingOf(const OrderedContact& order, std::size_t position) {
  const PathContact& contact = order.contact;
  Passing passing{.first = order.first(), .second = order.second(), .label = CrossingLabel(position)};
  passing.at = !order.a_first && contact.against ? contact.until : contact.at;
  passing.first_along = order.of_first().out.along;
  passing.second_along = order.of_second().in.along;
  if (!order.is_touch()) return passing;
  // The order is one at the target of the robot that ends here.
  const bool b_ends = contact.of_b.ends;
  passing.at = b_ends || !contact.against ? contact.until : contact.at;
  const auto along = [&](const PathVisit& visit) {
    return visit.ends || !contact.against ? visit.out.along : visit.in.along;
  };
  passing.first_along = along(order.of_first());
  passing.second_along = along(order.of_second());
  return passing;
}

/// Thrown where a motion that keeps all orders has robots meet, and caught where planning began.
struct RobotsMet {
  PlaybackCollision of;
};

/// Plans in the order of the stages of [Zhang2019, Fig. 8].
class Planner {
 public:
  Planner(const FleetGround& ground, const FleetLayout& layout, const FleetPlanOptions& options)
      : ground_(ground), layout_(layout), options_(options) {}

  tl::expected<FleetPlan, FleetPlanFault> Plan() {
    Tell("shortest paths", 0);
    straight_ = ShortestPaths(ground_, layout_);
    for (std::size_t i = 0; i < ground_.size(); ++i) cables_.push_back(CablePath(ground_, layout_, RobotId(i)));
    RefuseNearMisses();
    Tell("crossings", 0.2);
    const auto contacts = FindContacts(straight_);
    Tell("who passes first", 0.4);
    interactions_ = FindInteractions(ground_, layout_, straight_, contacts);
    if (!interactions_.faults.empty()) return tl::unexpected(FaultOf(interactions_.faults.front()));
    plan_.mode = options_.mode;
    plan_.pair_deadlocks = interactions_.deadlocks;
    for (std::size_t k = 0; k < interactions_.orders.size(); ++k) {
      plan_.passings.push_back(PassingOf(interactions_.orders[k], k));
    }
    Tell("deadlocks", 0.6);
    SummarizeConcurrent();
    SummarizeSequential();
    SummarizeBent();
    Tell("schedule", 0.8);
    if (auto fault = MakeMotion()) return tl::unexpected(*fault);
    return std::move(plan_);
  }

 private:
  /// Paths with the orders that robots on them must keep.
  struct Drive {
    std::vector<RobotPath> paths;
    std::vector<OrderedContact> orders;
    std::vector<std::size_t> names;  ///< Of the orders, as FleetEvent::passings has them.
  };

  /// Where something is off a path by no more than rounding, no playback could tell on which side it is passed.
  void RefuseNearMisses() const {
    std::vector<Route> routes;
    for (const auto* paths : {&straight_, &cables_}) {
      for (const RobotPath& path : *paths) routes.push_back(path.route);
    }
    const auto miss = FindNearMiss(ground_, routes);
    if (!miss) return;
    const RobotId robot(miss->route % ground_.size()), other = ground_.robot_at(miss->node);
    throw RobotsMet{{robot, other.valid() ? other : robot, ground_.point(miss->node)}};
  }

  void Tell(std::string_view stage, double share) const {
    if (options_.watch && !options_.watch(stage, share)) throw Stopped();
  }

  static FleetPlanFault FaultOf(const AssumptionFault& fault) {
    return {.robots = {fault.a, fault.b}, .at = fault.at, .start_inside = fault.start_inside};
  }

  std::vector<double> DetourCosts() const {
    std::vector<double> costs;
    for (std::size_t i = 0; i < straight_.size(); ++i) {
      costs.push_back(std::max(0.0, cables_[i].length() - straight_[i].length()));
    }
    return costs;
  }

  double TimeOf(const RobotPath& path, std::size_t robot) const {
    return path.length() / ground_.robots()[robot].speed;
  }

  TravelCost CostTogether(const std::vector<RobotPath>& paths) const {
    TravelCost cost;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      cost.time = std::max(cost.time, TimeOf(paths[i], i));
      cost.distance += paths[i].length();
    }
    return cost;
  }

  TravelCost CostInTurn(const std::vector<RobotPath>& paths) const {
    TravelCost cost = CostTogether(paths);
    cost.time = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) cost.time += TimeOf(paths[i], i);
    return cost;
  }

  ModeSummary Summarize(const Detours& detours) const {
    ModeSummary summary;
    summary.detours = detours.robots;
    summary.realizable = detours.robots.empty();
    summary.detours_optimal = detours.optimal;
    summary.detours_bound = detours.bound;
    return summary;
  }

  static void SetCost(TravelCost cost, ModeSummary& summary) {
    summary.travel_time = cost.time;
    summary.travel_distance = cost.distance;
  }

  /// The least detours with which the layout comes out when the orders of `graph` are kept.
  Detours FindDetours(const OrderGraph& graph) {
    for (;;) {
      Detours detours =
          LeastDetours({graph, interactions_.deadlocks, plan_.entangled, DetourCosts()}, options_.detours);
      std::vector<bool> is_straight(ground_.size(), true);
      for (const RobotId robot : detours.robots) is_straight[robot.index()] = false;
      if (!options_.play || IsKnownToComeOut(is_straight)) return detours;
      if (ComesOut(is_straight)) {
        comes_out_ = is_straight;
        return detours;
      }
      plan_.entangled.push_back(LeastEntangled(std::move(is_straight)));
    }
  }

  /// Whether a motion came out in which at least these robots drove straight: robots on a detour entangle nobody.
  bool IsKnownToComeOut(const std::vector<bool>& is_straight) const {
    if (comes_out_.empty()) return false;
    for (std::size_t i = 0; i < is_straight.size(); ++i) {
      if (is_straight[i] && !comes_out_[i]) return false;
    }
    return true;
  }

  /// Whether the layout comes out when some robots drive straight and the others along their cable lines. Requires that
  /// the orders of those that drive straight can be kept: which layout it is depends on the orders alone.
  bool ComesOut(const std::vector<bool>& is_straight) const {
    std::vector<RobotId> detours;
    for (std::size_t i = 0; i < is_straight.size(); ++i) {
      if (!is_straight[i]) detours.emplace_back(i);
    }
    const Drive drive = DriveWith(detours);
    const auto schedule = EarliestSchedule(ground_, drive.paths, GraphOf(drive, nullptr));
    TAUTLINE_CHECK(schedule.has_value());
    std::vector<Passing> passings;
    for (std::size_t k = 0; k < drive.orders.size(); ++k) passings.push_back(PassingOf(drive.orders[k], k));
    const auto played = Play(ground_, layout_, *schedule, passings, {.words_up_to = 0, .measured = 0});
    if (!played) throw RobotsMet{played.error()};
    return played->differing.empty();
  }

  /// Robots that do not make their part of the layout if they drive straight, none of which can be spared. Tries to
  /// spare ever smaller groups.
  std::vector<RobotId> LeastEntangled(std::vector<bool> is_straight) const {
    std::vector<RobotId> robots;
    for (std::size_t i = 0; i < is_straight.size(); ++i) {
      if (is_straight[i]) robots.emplace_back(i);
    }
    for (std::size_t group = (robots.size() + 1) / 2;; group = (group + 1) / 2) {
      for (std::size_t begin = 0; begin < robots.size();) {
        const std::size_t end = std::min(begin + group, robots.size());
        std::vector<bool> fewer = is_straight;
        for (std::size_t i = begin; i < end; ++i) fewer[robots[i].index()] = false;
        if (ComesOut(fewer)) {
          begin = end;
          continue;
        }
        is_straight = std::move(fewer);
        robots.erase(robots.begin() + static_cast<std::ptrdiff_t>(begin),
                     robots.begin() + static_cast<std::ptrdiff_t>(end));
      }
      if (group <= 1) break;
    }
    TAUTLINE_CHECK(!robots.empty());
    return robots;
  }

  void SummarizeConcurrent() {
    const EventGraph graph = MakeEventGraph(straight_, interactions_.orders);
    const OrderGraph flat = graph.Flat();
    for (const auto& part : CyclicParts(flat)) {
      auto& robots = plan_.network_deadlocks.emplace_back();
      for (const std::uint32_t v : part) robots.push_back(flat.robot_of[v]);
      robots.erase(std::unique(robots.begin(), robots.end()), robots.end());
    }
    const Detours detours = FindDetours(flat);
    ModeSummary& summary = plan_.modes[IndexOf(FleetMode::kStraightConcurrent)] = Summarize(detours);
    if (!summary.realizable) summary.without_detours = CostTogether(straight_);
    concurrent_ = DriveWith(summary.detours);
    auto schedule = EarliestSchedule(ground_, concurrent_.paths, GraphOf(concurrent_, Gap()));
    if (schedule) {
      SetCost(CostOf(*schedule), summary);
      plan_.schedule = *std::move(schedule);
      return;
    }
    const auto of_points = EarliestSchedule(ground_, concurrent_.paths, GraphOf(concurrent_, nullptr));
    TAUTLINE_CHECK(of_points.has_value());
    SetCost(CostOf(*of_points), summary);
  }

  OrderGraph PairGraph() const {
    OrderGraph graph;
    graph.after.resize(ground_.size());
    for (std::size_t i = 0; i < ground_.size(); ++i) graph.robot_of.emplace_back(i);
    for (const OrderedContact& order : interactions_.orders) {
      graph.after[order.first().index()].push_back(static_cast<std::uint32_t>(order.second().index()));
    }
    return graph;
  }

  void SummarizeSequential() {
    const Detours detours = FindDetours(PairGraph());
    ModeSummary& summary = plan_.modes[IndexOf(FleetMode::kStraightSequential)] = Summarize(detours);
    if (!summary.realizable) summary.without_detours = CostInTurn(straight_);
    std::vector<RobotPath> paths = straight_;
    for (const RobotId robot : detours.robots) paths[robot.index()] = cables_[robot.index()];
    SetCost(CostInTurn(paths), summary);
  }

  void SummarizeBent() {
    for (const FleetMode mode : {FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
      ModeSummary& summary = plan_.modes[IndexOf(mode)];
      summary.realizable = true;
      SetCost(mode == FleetMode::kBentConcurrent ? CostTogether(cables_) : CostInTurn(cables_), summary);
    }
  }

  /// Lets detours pass the targets that they lead straight over on the side that leaves them the cables there.
  void SettleSides(const std::vector<RobotId>& detours, std::vector<RobotPath>& paths) const {
    std::vector<std::pair<std::size_t, std::size_t>> open;  // Robot and step.
    for (const RobotId robot : detours) {
      const Route& route = paths[robot.index()].route;
      for (std::size_t k = 1; k + 1 < route.size(); ++k) {
        const bool is_target = ground_.kind(route[k].node) == FleetNodeKind::kTarget;
        if (is_target && route[k].side == Side::kNone) open.emplace_back(robot.index(), k);
      }
    }
    if (open.empty()) return;
    std::vector<Route> routes;
    for (const RobotPath& path : paths) routes.push_back(path.route);
    routes = WithSides(ground_, routes);
    for (const auto& [robot, step] : open) paths[robot].route[step].side = routes[robot][step].side;
  }

  /// Some robots along their cable lines, the others straight.
  Drive DriveWith(const std::vector<RobotId>& detours) const {
    Drive drive{straight_, {}, {}};
    std::vector<bool> is_detour(ground_.size(), false);
    for (const RobotId robot : detours) {
      is_detour[robot.index()] = true;
      drive.paths[robot.index()] = cables_[robot.index()];
    }
    SettleSides(detours, drive.paths);
    for (std::size_t k = 0; k < interactions_.orders.size(); ++k) {
      const OrderedContact& order = interactions_.orders[k];
      if (is_detour[order.contact.a.index()] || is_detour[order.contact.b.index()]) continue;
      drive.orders.push_back(order);
      drive.names.push_back(k);
    }
    const bool all_bent = detours.size() == ground_.size();
    if (detours.empty() || all_bent) return drive;
    std::size_t name = interactions_.orders.size();
    for (const PathContact& contact : FindContacts(drive.paths, detours)) {
      if (!StraightCrossesDetour(drive.paths, contact)) continue;
      drive.orders.push_back({contact, false});
      drive.names.push_back(name++);
    }
    return drive;
  }

  /// Whether the straight path b of a contact must be passed before the detour a comes there.
  static bool StraightCrossesDetour(const std::vector<RobotPath>& paths, const PathContact& contact) {
    if (contact.crosses() || contact.of_a.ends) return true;
    if (!contact.of_b.ends || contact.of_b.from == Side::kNone) return false;
    // The target of b is held on the inner side of a bend, or beside a straight piece, of a's cable line.
    const PathSpot& spot = contact.against ? contact.of_a.in : contact.of_a.out;
    const RouteStep& step = paths[contact.a.index()].route[static_cast<std::size_t>(spot.segment)];
    return spot.at_point && step.side != Side::kNone && step.side != contact.of_b.from;
  }

  std::function<double(RobotId, RobotId)> Gap() const {
    if (options_.gap) return [gap = *options_.gap](RobotId, RobotId) { return gap; };
    return [this](RobotId a, RobotId b) { return ground_.robot(a).radius + ground_.robot(b).radius; };
  }

  EventGraph GraphOf(const Drive& drive, std::function<double(RobotId, RobotId)> gap) const {
    EventGraph graph = MakeEventGraph(drive.paths, drive.orders, {.gap = std::move(gap)});
    for (auto& chain : graph.chains) {
      for (FleetEvent& event : chain) {
        for (std::size_t& passing : event.passings) passing = drive.names[passing];
      }
    }
    return graph;
  }

  /// The schedule of the mode; what is in the way, if anything.
  std::optional<FleetPlanFault> MakeMotion() {
    const ModeSummary& summary = plan_.modes[IndexOf(options_.mode)];
    plan_.detours = summary.detours;
    Drive drive = std::move(concurrent_);
    if (options_.mode == FleetMode::kStraightSequential) drive = DriveWith(summary.detours);
    if (options_.mode == FleetMode::kBentConcurrent || options_.mode == FleetMode::kBentSequential) {
      std::vector<RobotId> all;
      for (std::size_t i = 0; i < ground_.size(); ++i) all.emplace_back(i);
      drive = DriveWith(all);
    }
    const bool straight_at_once = options_.mode == FleetMode::kStraightConcurrent;
    if (straight_at_once && plan_.schedule.empty()) return GapFault(drive);
    EventGraph graph = GraphOf(drive, straight_at_once ? Gap() : nullptr);
    if (options_.mode == FleetMode::kBentConcurrent) plan_.schedule = *EarliestSchedule(ground_, drive.paths, graph);
    if (options_.mode == FleetMode::kBentSequential || options_.mode == FleetMode::kStraightSequential) {
      plan_.schedule = SequentialSchedule(ground_, drive.paths, graph, Sequence());
    }
    plan_.event_edges = std::move(graph.edges);
    for (std::size_t k = 0; k < drive.orders.size(); ++k) {
      if (drive.names[k] >= plan_.passings.size()) {
        plan_.detour_passings.push_back(PassingOf(drive.orders[k], drive.names[k]));
      }
    }
    if (options_.speeds) SlowDownInsteadOfWaiting(plan_.schedule);
    for (auto* passings : {&plan_.passings, &plan_.detour_passings}) {
      for (Passing& passing : *passings) {
        passing.distance = LeastDistance(plan_.schedule[passing.first.index()], plan_.schedule[passing.second.index()]);
      }
    }
    const TravelCost cost = CostOf(plan_.schedule);
    plan_.travel_time = cost.time;
    plan_.travel_distance = cost.distance;
    return std::nullopt;
  }

  /// One after the other: first those that drive straight, as the pair graph says, then the detours.
  std::vector<RobotId> Sequence() const {
    std::vector<RobotId> order;
    if (options_.mode == FleetMode::kBentSequential) {
      for (std::size_t i = 0; i < ground_.size(); ++i) order.emplace_back(i);
      return order;
    }
    std::vector<bool> is_detour(ground_.size(), false);
    for (const RobotId robot : plan_.detours) is_detour[robot.index()] = true;
    OrderGraph graph = PairGraph();
    for (std::size_t i = 0; i < graph.size(); ++i) {
      auto& after = graph.after[i];
      if (is_detour[i]) after.clear();
      after.erase(std::remove_if(after.begin(), after.end(), [&](std::uint32_t v) { return is_detour[v]; }),
                  after.end());
    }
    const auto sorted = TopologicalOrder(graph);
    TAUTLINE_CHECK(sorted.has_value());
    for (const bool detours : {false, true}) {
      for (const std::uint32_t v : *sorted) {
        if (is_detour[v] == detours) order.emplace_back(static_cast<std::size_t>(v));
      }
    }
    return order;
  }

  FleetPlanFault GapFault(const Drive& drive) const {
    FleetPlanFault fault{.obstruction = FleetPlanObstruction::kGapTooWide};
    const auto gap = Gap();
    for (const OrderedContact& order : drive.orders) {
      fault.gap = std::max(fault.gap, gap(order.first(), order.second()));
    }
    const auto circles = [&](double width) {
      const EventGraph graph = MakeEventGraph(drive.paths, drive.orders, {[width](RobotId, RobotId) { return width; }});
      return !TopologicalOrder(graph.Flat()).has_value();
    };
    // From the length of a path on, it is all in the gap.
    double low = 0, high = 0;
    for (const RobotPath& path : drive.paths) high = std::max(high, path.length());
    high = std::min(high, fault.gap);
    constexpr int kHalvings = 50;
    for (int i = 0; i < kHalvings && low < high; ++i) {
      const double middle = low + 0.5 * (high - low);
      (circles(middle) ? high : low) = middle;
    }
    fault.largest_gap = low;
    const OrderGraph flat = GraphOf(drive, gap).Flat();
    const auto parts = CyclicParts(flat);
    for (const std::uint32_t v : parts.front()) fault.robots.push_back(flat.robot_of[v]);
    std::sort(fault.robots.begin(), fault.robots.end());
    fault.robots.erase(std::unique(fault.robots.begin(), fault.robots.end()), fault.robots.end());
    return fault;
  }

  const FleetGround& ground_;
  const FleetLayout& layout_;
  const FleetPlanOptions& options_;
  std::vector<RobotPath> straight_, cables_;
  PairInteractions interactions_;
  Drive concurrent_;
  std::vector<bool> comes_out_;  ///< The robots that drove straight in a motion that was played and came out.
  FleetPlan plan_;
};

}  // namespace

std::string CrossingLabel(std::size_t position) {
  std::string label;
  for (std::size_t rest = position + 1; rest > 0; rest = (rest - 1) / 26) {
    label.insert(label.begin(), static_cast<char>('A' + (rest - 1) % 26));
  }
  return label;
}

std::string Explain(const FleetGround& ground, const FleetPlanFault& fault) {
  if (fault.obstruction == FleetPlanObstruction::kStopped) return "stopped before there was a plan";
  if (fault.obstruction == FleetPlanObstruction::kGapTooWide) {
    std::string names;
    for (const RobotId robot : fault.robots) names += (names.empty() ? "" : ", ") + ground.robot(robot).name;
    return "robots " + ShortNumber(fault.gap) + " m apart would wait for each other in a circle (" + names +
           "): they can stay up to " + ShortNumber(fault.largest_gap) + " m apart, or drive in another mode";
  }
  const std::string a = ground.robot(fault.robots[0]).name, b = ground.robot(fault.robots[1]).name;
  if (fault.obstruction == FleetPlanObstruction::kRobotsMeet) {
    return (a == b ? a + " would graze the corner at " : a + " and " + b + " would meet at ") + ToText(fault.at) +
           ": something is all but on a path or cable line there; move it clear, or exactly onto it";
  }
  if (fault.start_inside) {
    return "the start of " + b + " at " + ToText(fault.at) + " is on the path of " + a +
           " or between that path and its cable line: lead that cable line past the other side of it";
  }
  return "the paths of " + a + " and " + b + " cross at " + ShortText(fault.at) +
         ", and not exactly one of their targets is between the path and the cable line of the other"
         ": lead one of the cable lines around the target of the other";
}

tl::expected<FleetPlan, FleetPlanFault> PlanFleet(const FleetGround& ground, const FleetLayout& layout,
                                                  const FleetPlanOptions& options) {
  try {
    return Planner(ground, layout, options).Plan();
  } catch (const Stopped&) {
    return tl::unexpected(FleetPlanFault{.obstruction = FleetPlanObstruction::kStopped});
  } catch (const RobotsMet& met) {
    return tl::unexpected(FleetPlanFault{
        .obstruction = FleetPlanObstruction::kRobotsMeet, .robots = {met.of.a, met.of.b}, .at = met.of.at});
  }
}

}  // namespace tautline
