#include "tautline/planners/contact_free/yen_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// A set of paths with a common beginning, by its shortest.
struct Branch {
  SimplePath path;
  std::size_t deviation = 0;       ///< The nodes up to this one are common to all of the set.
  std::vector<PathNodeId> banned;  ///< Where no path of the set goes on to from there.
  std::size_t found = 0;           ///< In which order it was found.

  friend bool operator>(const Branch& a, const Branch& b) {
    return std::tie(a.path.length, a.found) > std::tie(b.path.length, b.found);
  }
};

class YenSearch {
 public:
  YenSearch(const PathGraph& graph, const YenQuery& query)
      : graph_(graph),
        query_(query),
        remaining_(graph.DistancesTo(query.to)),
        length_(graph.size(), 0),
        before_(graph.size()),
        reached_(graph.size(), 0),
        closed_(graph.size(), 0),
        stop_(query.keep_going, kStepsPerCheck) {}

  std::vector<SimplePath> Run() {
    std::vector<SimplePath> paths;
    Offer({query_.from}, {});
    while (!queue_.empty() && static_cast<int>(paths.size()) < query_.count) {
      const Branch branch = queue_.top();
      queue_.pop();
      Split(branch);
      paths.push_back(branch.path);
    }
    return paths;
  }

 private:
  static constexpr int kStepsPerCheck = 64;

  struct Candidate {
    double total;
    double length;
    PathNodeId node;

    /// By total, then the one that is farther on: across a lattice many paths are equally long.
    friend bool operator>(const Candidate& a, const Candidate& b) {
      return std::tuple(a.total, -a.length, a.node) > std::tuple(b.total, -b.length, b.node);
    }
  };

  /// Parts what is left of a set without its shortest path into sets by where they leave it.
  void Split(const Branch& branch) {
    const std::vector<PathNodeId>& nodes = branch.path.nodes;
    for (std::size_t i = branch.deviation; i + 1 < nodes.size(); ++i) {
      std::vector<PathNodeId> banned;
      if (i == branch.deviation) banned = branch.banned;
      banned.push_back(nodes[i + 1]);
      Offer({nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1}, std::move(banned));
    }
  }

  /// Finds the shortest path of a set.
  void Offer(std::vector<PathNodeId> common, std::vector<PathNodeId> banned) {
    stop_.Step();
    ++round_;
    const std::size_t deviation = common.size() - 1;
    for (std::size_t i = 0; i < deviation; ++i) closed_[common[i].index()] = round_;
    const auto rest = ShortestFrom(common.back(), banned);
    if (!rest) return;
    common.insert(common.end(), rest->begin(), rest->end());
    SimplePath path{std::move(common), 0};
    for (std::size_t i = 1; i < path.nodes.size(); ++i) path.length += graph_.Length(path.nodes[i - 1], path.nodes[i]);
    queue_.push({std::move(path), deviation, std::move(banned), found_++});
  }

  /// The nodes after `from` on the shortest path to the end that avoids closed nodes.
  std::optional<std::vector<PathNodeId>> ShortestFrom(PathNodeId from, const std::vector<PathNodeId>& banned) {
    open_ = {};
    Reach(from, 0, PathNodeId());
    while (!open_.empty()) {
      const Candidate at = open_.top();
      open_.pop();
      if (closed_[at.node.index()] == round_) continue;
      closed_[at.node.index()] = round_;
      if (at.node == query_.to) return Trace(from);
      for (const PathNodeId next : graph_.Neighbours(at.node)) {
        if (at.node == from && std::find(banned.begin(), banned.end(), next) != banned.end()) continue;
        if (closed_[next.index()] == round_) continue;
        const double length = length_[at.node.index()] + graph_.Length(at.node, next);
        if (reached_[next.index()] != round_ || length < length_[next.index()]) Reach(next, length, at.node);
      }
    }
    return std::nullopt;
  }

  void Reach(PathNodeId node, double length, PathNodeId before) {
    if (!std::isfinite(remaining_[node.index()])) return;
    reached_[node.index()] = round_;
    length_[node.index()] = length;
    before_[node.index()] = before;
    open_.push({length + remaining_[node.index()], length, node});
  }

  std::vector<PathNodeId> Trace(PathNodeId from) const {
    std::vector<PathNodeId> nodes;
    for (PathNodeId at = query_.to; at != from; at = before_[at.index()]) nodes.push_back(at);
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  const PathGraph& graph_;
  const YenQuery& query_;
  std::vector<double> remaining_;
  std::vector<double> length_;
  std::vector<PathNodeId> before_;
  /// The round of the search that reached, or closed, a node: nothing has to be cleared in between.
  std::vector<std::uint64_t> reached_, closed_;
  std::uint64_t round_ = 0;
  std::size_t found_ = 0;
  StopCheck stop_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open_;
  std::priority_queue<Branch, std::vector<Branch>, std::greater<>> queue_;
};

}  // namespace

std::vector<SimplePath> YenPaths(const PathGraph& graph, const YenQuery& query) {
  TAUTLINE_CHECK(query.from != query.to);
  return YenSearch(graph, query).Run();
}

}  // namespace tautline
