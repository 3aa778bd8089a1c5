#include "tautline/planners/fleet/event_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Where a robot passes a contact.
struct Spots {
  std::size_t in = 0, out = 0;  ///< Events of its chain.
};

/// The point of a contact where one of its robots comes to it, or leaves it.
SpotOnPath SpotAt(const std::vector<RobotPath>& paths, const PathContact& contact, bool of_a, bool out) {
  const PathVisit& visit = of_a ? contact.of_a : contact.of_b;
  SpotOnPath spot{.spot = out ? visit.out : visit.in, .exact = contact.exact};
  if (contact.exact) {
    spot.c = (of_a && contact.against) != out ? contact.until : contact.at;
    return spot;
  }
  const RobotPath& other = paths[(of_a ? contact.b : contact.a).index()];
  const auto segment = static_cast<std::size_t>((of_a ? contact.of_b : contact.of_a).in.segment);
  spot.c = other.points[segment];
  spot.d = other.points[segment + 1];
  return spot;
}

Point PointAlong(const RobotPath& path, double along) {
  const auto next = std::upper_bound(path.along.begin(), path.along.end(), along);
  if (next == path.along.end()) return path.points.back();
  const auto k = static_cast<std::size_t>(next - path.along.begin());
  return Lerp(path.points[k - 1], path.points[k], (along - path.along[k - 1]) / (path.along[k] - path.along[k - 1]));
}

/// The sine of the angle at which two paths cross; for a stretch, of the narrower one at its two ends.
double SineOfCrossing(const std::vector<RobotPath>& paths, const PathContact& contact) {
  const RobotPath &a = paths[contact.a.index()], &b = paths[contact.b.index()];
  const auto direction = [](const RobotPath& path, const PathSpot& spot, bool before) {
    auto k = static_cast<std::size_t>(spot.segment);
    if (spot.at_point && (before || k + 1 == path.points.size()) && k > 0) --k;
    const Point along = path.points[k + 1] - path.points[k];
    return (1 / Norm(along)) * along;
  };
  const auto sine = [](Point u, Point v) { return std::fabs(Cross(u, v)); };
  const PathSpot& b_first = contact.against ? contact.of_b.out : contact.of_b.in;
  const PathSpot& b_last = contact.against ? contact.of_b.in : contact.of_b.out;
  return std::min(sine(direction(a, contact.of_a.in, true), direction(b, b_first, !contact.against)),
                  sine(direction(a, contact.of_a.out, false), direction(b, b_last, contact.against)));
}

class GraphMaker {
 public:
  GraphMaker(const std::vector<RobotPath>& paths, std::span<const OrderedContact> orders,
             const EventGraphOptions& options)
      : paths_(paths),
        orders_(orders),
        options_(options),
        entries_(paths.size()),
        zones_(paths.size()),
        of_a_(orders.size()),
        of_b_(orders.size()),
        leave_(orders.size()),
        enter_(orders.size()) {}

  EventGraph Make() {
    for (std::size_t k = 0; k < orders_.size(); ++k) AddContact(k);
    for (std::size_t i = 0; i < paths_.size(); ++i) MakeChain(RobotId(i));
    for (std::size_t k = 0; k < orders_.size(); ++k) AddEdges(k);
    return std::move(graph_);
  }

 private:
  struct Entry {
    SpotOnPath place;
    std::size_t order;
    bool out;
  };
  struct Zone {
    double along;
    std::size_t order;
    bool leave;
  };

  void AddContact(std::size_t k) {
    const PathContact& contact = orders_[k].contact;
    for (const bool of_a : {true, false}) {
      auto& entries = entries_[(of_a ? contact.a : contact.b).index()];
      entries.push_back({SpotAt(paths_, contact, of_a, false), k, false});
      if (contact.exact) entries.push_back({SpotAt(paths_, contact, of_a, true), k, true});
    }
    const double gap = options_.gap ? options_.gap(contact.a, contact.b) : 0;
    if (gap <= 0) return;
    const double sine = SineOfCrossing(paths_, contact);
    const double reach = sine > 0 ? gap / sine : HUGE_VAL;
    const RobotId first = orders_[k].first(), second = orders_[k].second();
    const double end = paths_[first.index()].length();
    zones_[first.index()].push_back({std::min(end, orders_[k].of_first().out.along + reach), k, true});
    zones_[second.index()].push_back({std::max(0.0, orders_[k].of_second().in.along - reach), k, false});
    has_zone_.resize(orders_.size(), false);
    has_zone_[k] = true;
  }

  void MakeChain(RobotId robot) {
    const RobotPath& path = paths_[robot.index()];
    auto& entries = entries_[robot.index()];
    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      entries.push_back(
          {{{static_cast<std::int32_t>(i), true, path.along[i]}, true, path.points[i], {}}, kNone, false});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [&](const Entry& p, const Entry& q) { return CompareSpots(path, p.place, q.place) < 0; });
    auto& zones = zones_[robot.index()];
    std::stable_sort(zones.begin(), zones.end(), [](const Zone& p, const Zone& q) { return p.along < q.along; });
    std::vector<FleetEvent> chain;
    auto zone = zones.begin();
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const Entry& entry = entries[e];
      if (e == 0 || CompareSpots(path, entries[e - 1].place, entry.place) != 0) {
        for (; zone != zones.end() && zone->along < entry.place.spot.along; ++zone) AddZone(robot, *zone, chain);
        if (MayHaveToWaitFor(robot, std::span(entries).subspan(e))) AddWaitBefore(robot, entry, chain);
        AddEvent(entry, chain);
      }
      if (entry.order == kNone) {
        const bool is_end = entry.place.spot.segment + 1 == std::ssize(path.points);
        chain.back().kind = entry.place.spot.segment == 0                 ? FleetEventKind::kStart
                            : is_end                                      ? FleetEventKind::kTarget
                            : chain.back().kind == FleetEventKind::kStart ? FleetEventKind::kBend
                                                                          : chain.back().kind;
      } else {
        Note(robot, entry, chain);
      }
      for (; zone != zones.end() && zone->along == chain.back().along; ++zone) NoteZone(*zone, chain.size() - 1);
    }
    for (; zone != zones.end(); ++zone) NoteZone(*zone, chain.size() - 1);
    graph_.chains.push_back(std::move(chain));
    entries.clear();
    entries.shrink_to_fit();
  }

  void AddEvent(const Entry& entry, std::vector<FleetEvent>& chain) const {
    FleetEvent event;
    event.at = entry.place.exact ? entry.place.c : orders_[entry.order].contact.at;
    event.along = entry.place.spot.along;
    // Rounding must not turn the exact order around.
    if (!chain.empty()) event.along = std::max(event.along, chain.back().along);
    chain.push_back(event);
  }

  /// Whether these entries begin with the robot's target and another robot must pass that before. Whoever waits at a
  /// crossing stands on it, and whoever waits for its target must not stand there.
  bool MayHaveToWaitFor(RobotId robot, std::span<const Entry> entries) const {
    if (entries.front().place.spot.segment + 1 != std::ssize(paths_[robot.index()].points)) return false;
    return std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) {
      return entry.order < orders_.size() && orders_[entry.order].second() == robot;
    });
  }

  /// An event half way from the last one to the target.
  void AddWaitBefore(RobotId robot, const Entry& target, std::vector<FleetEvent>& chain) const {
    FleetEvent event;
    event.kind = FleetEventKind::kEnter;
    event.along = std::midpoint(chain.back().along, target.place.spot.along);
    event.at = PointAlong(paths_[robot.index()], event.along);
    if (event.along > chain.back().along) chain.push_back(event);
  }

  /// Tells a contact which event of a chain belongs to it.
  void Note(RobotId robot, const Entry& entry, std::vector<FleetEvent>& chain) {
    const OrderedContact& order = orders_[entry.order];
    Spots& spots = robot == order.contact.a ? of_a_[entry.order] : of_b_[entry.order];
    (entry.out ? spots.out : spots.in) = chain.size() - 1;
    if (!order.contact.exact) spots.out = spots.in;
    FleetEvent& event = chain.back();
    if (event.kind == FleetEventKind::kStart && chain.size() > 1) event.kind = FleetEventKind::kPassing;
    if (event.kind == FleetEventKind::kBend) event.kind = FleetEventKind::kPassing;
    if (!order.contact.exact || entry.out == PassesAtOut(order, robot)) event.passings.push_back(entry.order);
  }

  /// Whether a robot counts as passing a contact where it leaves it, rather than where it comes to it.
  static bool PassesAtOut(const OrderedContact& order, RobotId robot) {
    if (!order.is_touch()) return robot == order.first();
    const PathVisit& visit = robot == order.contact.a ? order.contact.of_a : order.contact.of_b;
    return visit.ends || !order.contact.against;
  }

  void AddZone(RobotId robot, const Zone& zone, std::vector<FleetEvent>& chain) {
    if (chain.back().along != zone.along) {
      FleetEvent event;
      event.kind = zone.leave ? FleetEventKind::kLeave : FleetEventKind::kEnter;
      event.at = PointAlong(paths_[robot.index()], zone.along);
      event.along = zone.along;
      chain.push_back(event);
    }
    NoteZone(zone, chain.size() - 1);
  }

  void NoteZone(const Zone& zone, std::size_t event) { (zone.leave ? leave_ : enter_)[zone.order] = event; }

  void AddEdge(RobotId first, std::size_t before, RobotId second, std::size_t after) {
    graph_.edges.push_back({{first, before}, {second, after}});
  }

  void AddEdges(std::size_t k) {
    const OrderedContact& order = orders_[k];
    const RobotId first = order.first(), second = order.second();
    const Spots p = order.a_first ? of_a_[k] : of_b_[k], q = order.a_first ? of_b_[k] : of_a_[k];
    const bool against = order.contact.against;
    if (order.is_touch()) {
      AddEdge(first, PassesAtOut(order, first) ? p.out : p.in, second, PassesAtOut(order, second) ? q.out : q.in);
    } else if (p.out - p.in == q.out - q.in) {
      for (std::size_t i = 0; i <= p.out - p.in; ++i) AddEdge(first, p.in + i, second, against ? q.out - i : q.in + i);
    } else {
      AddEdge(first, p.in, second, against ? q.out : q.in);
      AddEdge(first, p.out, second, against ? q.in : q.out);
    }
    if (!has_zone_.empty() && has_zone_[k]) AddEdge(first, leave_[k], second, enter_[k]);
  }

  const std::vector<RobotPath>& paths_;
  std::span<const OrderedContact> orders_;
  const EventGraphOptions& options_;
  std::vector<std::vector<Entry>> entries_;
  std::vector<std::vector<Zone>> zones_;
  std::vector<Spots> of_a_, of_b_;
  std::vector<std::size_t> leave_, enter_;
  std::vector<bool> has_zone_;
  EventGraph graph_;
};

/// Tarjan's strongly connected components [Tarjan1972], without recursion.
class PartFinder {
 public:
  PartFinder(const OrderGraph& graph, const std::vector<bool>& gone)
      : graph_(graph), gone_(gone), number_(graph.size(), 0), low_(graph.size(), 0), on_stack_(graph.size(), false) {}

  std::vector<std::vector<std::uint32_t>> Find() {
    for (std::uint32_t v = 0; v < graph_.size(); ++v) {
      if (number_[v] == 0 && !IsGone(v)) Explore(v);
    }
    std::sort(parts_.begin(), parts_.end());
    return std::move(parts_);
  }

 private:
  bool IsGone(std::uint32_t v) const { return !gone_.empty() && gone_[graph_.robot_of[v].index()]; }

  void Enter(std::uint32_t v) {
    number_[v] = low_[v] = ++count_;
    stack_.push_back(v);
    on_stack_[v] = true;
    trail_.emplace_back(v, 0);
  }

  void Explore(std::uint32_t root) {
    Enter(root);
    while (!trail_.empty()) {
      auto& [v, next] = trail_.back();
      if (next < graph_.after[v].size()) {
        const std::uint32_t w = graph_.after[v][next++];
        if (IsGone(w)) continue;
        if (number_[w] == 0) {
          Enter(w);
        } else if (on_stack_[w]) {
          low_[v] = std::min(low_[v], number_[w]);
        }
        continue;
      }
      const std::uint32_t done = v;
      trail_.pop_back();
      if (!trail_.empty()) low_[trail_.back().first] = std::min(low_[trail_.back().first], low_[done]);
      if (low_[done] == number_[done]) TakePart(done);
    }
  }

  void TakePart(std::uint32_t root) {
    std::vector<std::uint32_t> part;
    std::uint32_t v = 0;
    do {
      v = stack_.back();
      stack_.pop_back();
      on_stack_[v] = false;
      part.push_back(v);
    } while (v != root);
    if (part.size() < 2) return;
    std::sort(part.begin(), part.end());
    parts_.push_back(std::move(part));
  }

  const OrderGraph& graph_;
  const std::vector<bool>& gone_;
  std::vector<std::uint32_t> number_, low_;
  std::vector<bool> on_stack_;
  std::vector<std::uint32_t> stack_;
  std::vector<std::pair<std::uint32_t, std::size_t>> trail_;
  std::uint32_t count_ = 0;
  std::vector<std::vector<std::uint32_t>> parts_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> CyclicParts(const OrderGraph& graph, const std::vector<bool>& gone) {
  return PartFinder(graph, gone).Find();
}

std::optional<std::vector<std::uint32_t>> TopologicalOrder(const OrderGraph& graph) {
  std::vector<std::uint32_t> waits_for(graph.size(), 0);
  for (const auto& after : graph.after) {
    for (const std::uint32_t v : after) ++waits_for[v];
  }
  std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready;
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (waits_for[v] == 0) ready.push(v);
  }
  std::vector<std::uint32_t> order;
  while (!ready.empty()) {
    order.push_back(ready.top());
    ready.pop();
    for (const std::uint32_t v : graph.after[order.back()]) {
      if (--waits_for[v] == 0) ready.push(v);
    }
  }
  if (order.size() != graph.size()) return std::nullopt;
  return order;
}

std::vector<std::size_t> EventGraph::Offsets() const {
  std::vector<std::size_t> offsets;
  std::size_t count = 0;
  for (const auto& chain : chains) {
    offsets.push_back(count);
    count += chain.size();
  }
  return offsets;
}

OrderGraph EventGraph::Flat() const {
  const std::vector<std::size_t> offsets = Offsets();
  OrderGraph graph;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    for (std::size_t e = 0; e < chains[i].size(); ++e) {
      graph.robot_of.emplace_back(i);
      auto& after = graph.after.emplace_back();
      if (e + 1 < chains[i].size()) after.push_back(static_cast<std::uint32_t>(graph.robot_of.size()));
    }
  }
  for (const EventEdge& edge : edges) {
    graph.after[offsets[edge.before.first.index()] + edge.before.second].push_back(
        static_cast<std::uint32_t>(offsets[edge.after.first.index()] + edge.after.second));
  }
  return graph;
}

EventGraph MakeEventGraph(const std::vector<RobotPath>& paths, std::span<const OrderedContact> orders,
                          const EventGraphOptions& options) {
  return GraphMaker(paths, orders, options).Make();
}

}  // namespace tautline
