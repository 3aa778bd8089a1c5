#include "tautline/planners/cable_workspace/tour_search.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr std::size_t kNeighbours = 10;      // Nearest nodes that moves put a node beside.
constexpr std::size_t kLongestMoved = 3;     // Tasks that move together.
constexpr std::size_t kLongestSwapped = 30;  // Tasks in each part that a perturbation exchanges.
constexpr double kGain = 1e-10;              // Shares of the tour that rounding could feign are no gain.

/// A tour from start to end under improvement.
class Search {
 public:
  Search(const TourDistances& distances, const std::vector<std::size_t>& order)
      : distances_(distances), position_(distances.nodes()), queued_(distances.nodes(), false) {
    nodes_.push_back(distances.start());
    nodes_.insert(nodes_.end(), order.begin(), order.end());
    nodes_.push_back(distances.end());
    length_ = TourLength(distances, order);
    least_gain_ = kGain * length_;
    Renumber(0, nodes_.size());
    FindNeighbours();
    for (const std::size_t node : nodes_) Enqueue(node);
    Settle();
  }

  double length() const { return length_; }
  std::vector<std::size_t> Order() const { return {nodes_.begin() + 1, nodes_.end() - 1}; }

  /// One round: perturbs, settles, and takes it all back if that made the tour longer.
  void Perturb(Rng& rng) {
    const std::vector<std::size_t> before = nodes_;
    const double length = length_;
    SwapParts(rng);
    Settle();
    if (length_ <= length) return;
    nodes_ = before;
    length_ = length;
    Renumber(0, nodes_.size());
  }

 private:
  double D(std::size_t a, std::size_t b) const { return distances_(a, b); }

  /// The sum along the tour, which increments would drift from.
  void Measure() {
    length_ = 0;
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) length_ += D(nodes_[i], nodes_[i + 1]);
  }

  void Renumber(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) position_[nodes_[i]] = i;
  }

  void FindNeighbours() {
    neighbours_.resize(nodes_.size());
    for (std::size_t a = 0; a < neighbours_.size(); ++a) {
      for (std::size_t b = 0; b < neighbours_.size(); ++b) {
        if (b != a) neighbours_[a].push_back(b);
      }
      const std::size_t count = std::min(kNeighbours, neighbours_[a].size());
      std::partial_sort(neighbours_[a].begin(), neighbours_[a].begin() + static_cast<std::ptrdiff_t>(count),
                        neighbours_[a].end(),
                        [&](std::size_t b, std::size_t c) { return std::pair(D(a, b), b) < std::pair(D(a, c), c); });
      neighbours_[a].resize(count);
    }
  }

  void Enqueue(std::size_t node) {
    if (queued_[node]) return;
    queued_[node] = true;
    queue_.push_back(node);
  }

  /// Both nodes of the edge after a position, which is new.
  void EnqueueEdge(std::size_t position) {
    Enqueue(nodes_[position]);
    Enqueue(nodes_[position + 1]);
  }

  /// Improves about the queued nodes until nothing helps.
  void Settle() {
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const std::size_t node = queue_[i];
      queued_[node] = false;
      if (TurnAround(node) || MovePart(node)) Enqueue(node);
    }
    queue_.clear();
    Measure();
  }

  /// Exchanges the edges (a, next of a) and (c, next of c) for (a, c) and the other two, or the same with the nodes
  /// before: the part between is turned around.
  bool TurnAround(std::size_t a) {
    const std::size_t last = nodes_.size() - 1, at = position_[a];
    for (const bool next : {true, false}) {
      if (at == (next ? last : 0)) continue;
      const std::size_t b = nodes_[next ? at + 1 : at - 1];
      for (const std::size_t c : neighbours_[a]) {
        if (D(a, c) >= D(a, b)) break;
        const std::size_t to = position_[c];
        if (to == (next ? last : 0)) continue;
        const std::size_t d = nodes_[next ? to + 1 : to - 1];
        if (D(a, c) + D(b, d) >= D(a, b) + D(c, d) - least_gain_) continue;
        const std::size_t low = std::min(at, to), high = std::max(at, to);
        Reverse(next ? low + 1 : low, next ? high : high - 1);
        return true;
      }
    }
    return false;
  }

  void Reverse(std::size_t first, std::size_t last) {
    std::reverse(nodes_.begin() + static_cast<std::ptrdiff_t>(first),
                 nodes_.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    Renumber(first, last + 1);
    EnqueueEdge(first - 1);
    EnqueueEdge(last);
  }

  /// Moves a part with `a` at one end to beside one of its neighbours, either way around.
  bool MovePart(std::size_t a) {
    for (std::size_t size = 1; size <= kLongestMoved; ++size) {
      for (const bool a_first : {true, false}) {
        if (!a_first && (size == 1 || position_[a] + 1 < size)) continue;
        const std::size_t first = a_first ? position_[a] : position_[a] + 1 - size, last = first + size - 1;
        if (first == 0 || last + 1 >= nodes_.size()) continue;
        if (MovePart(a, first, last)) return true;
      }
    }
    return false;
  }

  bool MovePart(std::size_t a, std::size_t first, std::size_t last) {
    const std::size_t other = nodes_[first] == a ? nodes_[last] : nodes_[first];
    const std::size_t before = nodes_[first - 1], after = nodes_[last + 1];
    const double freed = D(before, nodes_[first]) + D(nodes_[last], after) - D(before, after);
    for (const std::size_t c : neighbours_[a]) {
      if (D(a, c) >= freed) break;
      const std::size_t at = position_[c];
      if (at >= first && at <= last) continue;
      for (const bool behind : {true, false}) {
        if (at == (behind ? nodes_.size() - 1 : 0)) continue;
        const std::size_t between = behind ? at + 1 : at - 1;
        if (between >= first && between <= last) continue;
        const std::size_t e = nodes_[between];
        if (D(a, c) + D(other, e) - D(c, e) >= freed - least_gain_) continue;
        // The part goes between c and e, `a` beside c.
        const bool turned = behind == (nodes_[last] == a && first != last);
        Insert(first, last, std::min(at, between), turned);
        return true;
      }
    }
    return false;
  }

  /// Puts the part from first to last behind the node at `to`, which is outside of it.
  void Insert(std::size_t first, std::size_t last, std::size_t to, bool turned) {
    const auto at = [this](std::size_t i) { return nodes_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (turned) std::reverse(at(first), at(last + 1));
    const std::size_t size = last - first + 1;
    if (to < first) {
      std::rotate(at(to + 1), at(first), at(last + 1));
      Renumber(to + 1, last + 1);
      EnqueueEdge(to), EnqueueEdge(to + size), EnqueueEdge(last);
    } else {
      std::rotate(at(first), at(last + 1), at(to + 1));
      Renumber(first, to + 1);
      EnqueueEdge(first - 1), EnqueueEdge(to - size), EnqueueEdge(to);
    }
  }

  /// Exchanges two neighbouring parts without turning them: a change of three edges that the moves cannot undo alone.
  void SwapParts(Rng& rng) {
    const std::size_t tasks = nodes_.size() - 2, longest = std::min(kLongestSwapped, tasks / 2);
    const auto random = [&rng](std::size_t high) {
      return static_cast<std::size_t>(rng.UniformInt(1, static_cast<int>(high)));
    };
    const std::size_t first = random(longest), second = random(longest), begin = random(tasks - first - second + 1);
    const std::size_t middle = begin + first, end = middle + second;
    const auto at = [this](std::size_t i) { return nodes_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::rotate(at(begin), at(middle), at(end));
    Renumber(begin, end);
    for (const std::size_t edge : {begin - 1, begin + second - 1, end - 1}) EnqueueEdge(edge);
  }

  const TourDistances& distances_;
  std::vector<std::size_t> nodes_;     ///< Start, tasks, end.
  std::vector<std::size_t> position_;  ///< By node.
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<std::size_t> queue_;
  std::vector<bool> queued_;
  double length_ = 0;
  double least_gain_ = 0;
};

}  // namespace

std::vector<std::size_t> NearestNeighbourTour(const TourDistances& distances) {
  std::vector<std::size_t> order, left(distances.tasks());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::size_t at = distances.start();
  while (!left.empty()) {
    const auto next = std::min_element(
        left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return distances(at, a) < distances(at, b); });
    at = *next;
    order.push_back(at);
    left.erase(next);
  }
  return order;
}

std::vector<std::size_t> ImproveTour(const TourDistances& distances, std::vector<std::size_t> order,
                                     const TourSearchOptions& options, Rng& rng) {
  TAUTLINE_CHECK(order.size() == distances.tasks());
  if (order.size() < 2) return order;
  Search search(distances, order);
  for (std::int64_t round = 0; round < options.rounds && search.length() > options.good_enough; ++round) {
    if (options.keep_going && !options.keep_going()) break;
    search.Perturb(rng);
  }
  return search.Order();
}

}  // namespace tautline
