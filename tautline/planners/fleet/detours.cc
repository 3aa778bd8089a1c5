#include "tautline/planners/fleet/detours.h"

#include <algorithm>
#include <map>
#include <set>

#include "tautline/planners/fleet/hitting_set.h"

namespace tautline {
namespace {

/// Looks for the least detours.
class DetourSearch {
 public:
  DetourSearch(const DetourProblem& problem, const DetourOptions& options)
      : problem_(problem), nodes_(options.nodes), rounds_(options.rounds), stop_(options.stop) {}

  Detours Run() {
    for (const PairDeadlock& pair : problem_.pair_deadlocks) AddSet({pair.a.value(), pair.b.value()});
    for (const auto& robots : problem_.entangled) {
      ItemSet set;
      for (const RobotId robot : robots) set.push_back(robot.value());
      AddSet(std::move(set));
    }
    given_ = sets_;
    HittingSet least;
    for (std::size_t round = 0; round < rounds_; ++round) {
      stop_.Step();
      least = LeastHittingSet(sets_, problem_.costs, nodes_);
      bound_ = std::max(bound_, least.bound);
      if (!AddCircles(Flags(least.chosen))) return Finish(least.chosen, least.optimal);
      if (nodes_ == 0) break;
    }
    return Finish(Greedy(Flags(least.chosen)), false);
  }

 private:
  std::vector<bool> Flags(const ItemSet& robots) const {
    std::vector<bool> flags(problem_.costs.size(), false);
    for (const std::int32_t robot : robots) flags[static_cast<std::size_t>(robot)] = true;
    return flags;
  }

  void AddSet(ItemSet set) {
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    if (known_.insert(set).second) sets_.push_back(std::move(set));
  }

  /// Finds disjoint circles until none is left without the robots `gone` and theirs; whether there was one.
  bool AddCircles(std::vector<bool> gone) {
    bool found = false;
    for (;;) {
      const auto parts = CyclicParts(problem_.graph, gone);
      if (parts.empty()) return found;
      found = true;
      for (const auto& part : parts) {
        const ItemSet circle = ShortCircle(part);
        for (const std::int32_t robot : circle) gone[static_cast<std::size_t>(robot)] = true;
        AddSet(circle);
      }
    }
  }

  /// The robots of a short circle within a strongly connected part: the shortest one through some of its vertices.
  ItemSet ShortCircle(const std::vector<std::uint32_t>& part) {
    constexpr std::size_t kStarts = 16;
    const std::set<std::uint32_t> inside(part.begin(), part.end());
    const std::size_t step = std::max<std::size_t>(1, part.size() / kStarts);
    ItemSet best;
    for (std::size_t i = 0; i < part.size(); i += step) {
      ItemSet circle = CircleThrough(part[i], inside);
      if (best.empty() || circle.size() < best.size()) best = std::move(circle);
    }
    return best;
  }

  ItemSet CircleThrough(std::uint32_t start, const std::set<std::uint32_t>& inside) const {
    std::map<std::uint32_t, std::uint32_t> from;
    std::vector<std::uint32_t> queue{start};
    for (std::size_t i = 0; i < queue.size() && from.count(start) == 0; ++i) {
      for (const std::uint32_t next : problem_.graph.after[queue[i]]) {
        if (inside.count(next) != 0 && from.emplace(next, queue[i]).second) queue.push_back(next);
      }
    }
    ItemSet robots;
    std::uint32_t at = start;
    do {
      robots.push_back(problem_.graph.robot_of[at].value());
      at = from.at(at);
    } while (at != start);
    std::sort(robots.begin(), robots.end());
    robots.erase(std::unique(robots.begin(), robots.end()), robots.end());
    return robots;
  }

  /// Adds the busiest robot of each part that is left until none is, and takes back what turns out not to be needed.
  ItemSet Greedy(std::vector<bool> gone) {
    for (auto parts = CyclicParts(problem_.graph, gone); !parts.empty(); parts = CyclicParts(problem_.graph, gone)) {
      stop_.Step();
      for (const auto& part : parts) gone[static_cast<std::size_t>(Busiest(part))] = true;
    }
    ItemSet robots;
    for (std::size_t i = 0; i < gone.size(); ++i) {
      if (gone[i]) robots.push_back(static_cast<std::int32_t>(i));
    }
    constexpr std::size_t kMostThinning = 500;
    if (robots.size() > kMostThinning) return robots;
    ItemSet needed;
    for (const std::int32_t robot : robots) {
      stop_.Step();
      const auto i = static_cast<std::size_t>(robot);
      gone[i] = false;
      const bool given_hit = std::all_of(given_.begin(), given_.end(), [&](const ItemSet& set) {
        return std::any_of(set.begin(), set.end(), [&](std::int32_t r) { return gone[static_cast<std::size_t>(r)]; });
      });
      if (given_hit && CyclicParts(problem_.graph, gone).empty()) continue;
      gone[i] = true;
      needed.push_back(robot);
    }
    return needed;
  }

  /// The robot with the most edges to others within a part.
  std::int32_t Busiest(const std::vector<std::uint32_t>& part) const {
    const std::set<std::uint32_t> inside(part.begin(), part.end());
    std::map<std::int32_t, std::size_t> edges;
    for (const std::uint32_t v : part) {
      for (const std::uint32_t w : problem_.graph.after[v]) {
        const std::int32_t p = problem_.graph.robot_of[v].value(), q = problem_.graph.robot_of[w].value();
        if (inside.count(w) == 0 || p == q) continue;
        ++edges[p];
        ++edges[q];
      }
    }
    const auto busiest =
        std::max_element(edges.begin(), edges.end(), [](const auto& p, const auto& q) { return p.second < q.second; });
    return busiest->first;
  }

  Detours Finish(const ItemSet& chosen, bool optimal) const {
    Detours detours{.robots = {}, .optimal = optimal, .bound = optimal ? chosen.size() : bound_};
    for (const std::int32_t robot : chosen) detours.robots.emplace_back(robot);
    return detours;
  }

  const DetourProblem& problem_;
  std::size_t nodes_, rounds_;
  StopCheck stop_;
  std::vector<ItemSet> sets_, given_;
  std::set<ItemSet> known_;
  std::size_t bound_ = 0;
};

}  // namespace

Detours LeastDetours(const DetourProblem& problem, const DetourOptions& options) {
  return DetourSearch(problem, options).Run();
}

}  // namespace tautline
