#include "tautline/planners/contact_free/shortest_in_class.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tautline/homotopy/word_path.h"

namespace tautline {
namespace {

class ClassSearch {
 public:
  ClassSearch(const TautSpace& space, const PathGraph& graph, const ShortestInClassQuery& query)
      : space_(space), graph_(graph), query_(query) {}

  std::optional<Polyline> Run() {
    if (!Start()) return std::nullopt;
    while (!queue_.empty() && static_cast<std::int64_t>(states_.size()) <= query_.max_states) {
      const Candidate candidate = queue_.top();
      queue_.pop();
      State& state = states_[candidate.state];
      if (state.closed || candidate.length > state.length) continue;
      state.closed = true;
      if (state.node == query_.to && words_[state.word] == query_.word) return PathTo(candidate.state);
      Expand(candidate.state);
    }
    return std::nullopt;
  }

 private:
  /// A node reached in a class.
  struct State {
    PathNodeId node;
    std::size_t word;     ///< Of the path so far, a position in words_.
    double length;        ///< Of it, metres.
    std::size_t parent;   ///< The state before it; itself at the start.
    Walk rest;            ///< From the goal back to the node, in the class of what is left.
    double rest_length;   ///< Of that, pulled taut.
    bool closed = false;  ///< No shorter path to it will be found.
  };

  struct Candidate {
    double total;
    double length;
    std::size_t state;

    /// By total, then the one that is farther on, then the one found first.
    friend bool operator>(const Candidate& a, const Candidate& b) {
      return std::tuple(a.total, -a.length, a.state) > std::tuple(b.total, -b.length, b.state);
    }
  };

  bool Start() {
    const auto from = space_.Locate(graph_.point(query_.from)), to = space_.Locate(graph_.point(query_.to));
    if (!from || !to || !space_.mesh().Connected(*from, *to) || !HasAllLetters()) return false;
    const auto taut = FindWordPath(space_, *from, *to, query_.word);
    if (!taut) return false;
    const Polyline back(taut->points.rbegin(), taut->points.rend());
    std::optional<Walk> rest{Walk(*to)};
    if (space_.Follow(back, rest)) return false;
    limit_ = query_.stretch * taut->length + query_.slack_m;
    Reach(query_.from, Number(Word()), 0, 0, *std::move(rest));
    return true;
  }

  /// An obstacle that merged with a wall in this space has no letter.
  bool HasAllLetters() const {
    const auto letters = query_.word.letters();
    return std::all_of(letters.begin(), letters.end(),
                       [&](Letter letter) { return letter.obstacle.index() < space_.rays().names().size(); });
  }

  std::size_t Number(const Word& word) {
    const auto [entry, added] = numbers_.emplace(word, words_.size());
    if (added) words_.push_back(word);
    return entry->second;
  }

  static std::uint64_t KeyOf(PathNodeId node, std::size_t word) {
    return (static_cast<std::uint64_t>(word) << 32U) | static_cast<std::uint64_t>(node.index());
  }

  void Reach(PathNodeId node, std::size_t word, double length, std::size_t parent, Walk rest) {
    const double rest_length = PullTaut(space_.mesh(), rest).length;
    if (length + rest_length > limit_) return;
    at_.emplace(KeyOf(node, word), states_.size());
    queue_.push({length + rest_length, length, states_.size()});
    states_.push_back({node, word, length, parent, std::move(rest), rest_length});
  }

  void Expand(std::size_t position) {
    const PathNodeId node = states_[position].node;
    for (const PathNodeId next : graph_.Neighbours(node)) {
      const Point ends[] = {graph_.point(node), graph_.point(next)};
      const Word letters = space_.rays().WordOf(ends);
      const std::size_t before = states_[position].word;
      const std::size_t word = letters.empty() ? before : Number(words_[before] * letters);
      const double length = states_[position].length + Distance(ends[0], ends[1]);
      const auto known = at_.find(KeyOf(next, word));
      if (known == at_.end()) {
        Walk rest = states_[position].rest;
        // Only where blocked ground touches does the sector matter, and a segment may not be had from this one.
        if (WalkNearly(space_.mesh(), ends[1], space_.tolerance(), rest)) continue;
        Reach(next, word, length, position, std::move(rest));
        continue;
      }
      State& state = states_[known->second];
      if (length >= state.length) continue;
      // Rounding can make the bound inconsistent by as much; then a state is opened again.
      state.length = length;
      state.parent = position;
      state.closed = false;
      queue_.push({length + state.rest_length, length, known->second});
    }
  }

  Polyline PathTo(std::size_t position) const {
    Polyline points{graph_.point(states_[position].node)};
    while (states_[position].parent != position) {
      position = states_[position].parent;
      points.push_back(graph_.point(states_[position].node));
    }
    std::reverse(points.begin(), points.end());
    return points;
  }

  const TautSpace& space_;
  const PathGraph& graph_;
  const ShortestInClassQuery& query_;
  double limit_ = 0;
  std::vector<State> states_;
  std::unordered_map<std::uint64_t, std::size_t> at_;
  std::vector<Word> words_;
  std::map<Word, std::size_t> numbers_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
};

}  // namespace

std::optional<Polyline> ShortestInClass(const TautSpace& space, const PathGraph& graph,
                                        const ShortestInClassQuery& query) {
  return ClassSearch(space, graph, query).Run();
}

}  // namespace tautline
