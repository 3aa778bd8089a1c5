#include "tautline/homotopy/class_oracle.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::uint64_t KeyOf(std::size_t node, int word) {
  return static_cast<std::uint64_t>(node) << 32 | static_cast<std::uint32_t>(word);
}

}  // namespace

int WordTable::Append(int word, int letter) {
  const Entry entry = entries_[static_cast<std::size_t>(word)];
  if (entry.letter == -letter) return entry.parent;
  const auto [child, is_new] = children_.try_emplace({word, letter}, static_cast<int>(entries_.size()));
  if (is_new) entries_.push_back({word, letter});
  return child->second;
}

Word WordTable::ToWord(int word) const {
  std::vector<int> letters;
  for (; word != 0; word = entries_[static_cast<std::size_t>(word)].parent) {
    letters.push_back(entries_[static_cast<std::size_t>(word)].letter);
  }
  Word result;
  for (auto it = letters.rbegin(); it != letters.rend(); ++it) {
    result.Append({ObstacleId(static_cast<std::int32_t>(std::abs(*it) - 1)), *it < 0});
  }
  return result;
}

ClassOracle::ClassOracle(std::span<const Ring> rings, std::span<const Point> representatives,
                         std::span<const Point> points)
    : sight_(rings, points),
      representatives_(representatives.begin(), representatives.end()),
      arcs_(sight_.nodes().size()) {
  const auto& nodes = sight_.nodes();
  for (std::size_t a = 0; a < nodes.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (!sight_.Sees(a, b)) continue;
      const Point p = nodes[a].point, q = nodes[b].point;
      arcs_[a].push_back({b, Distance(p, q), LettersOf(p, q)});
      arcs_[b].push_back({a, Distance(p, q), LettersOf(q, p)});
    }
  }
}

std::vector<int> ClassOracle::LettersOf(Point p, Point q) const {
  std::vector<std::pair<double, int>> crossed;  // By x, then by letter: the order for a traveller to the right.
  for (std::size_t k = 0; k < representatives_.size(); ++k) {
    const Point r = representatives_[k];
    const bool p_is_left = p.x < r.x, q_is_left = q.x < r.x;
    if (p_is_left == q_is_left) continue;
    const bool above = p_is_left ? Orientation(p, q, r) < 0 : Orientation(q, p, r) < 0;
    if (above) crossed.emplace_back(r.x, static_cast<int>(k) + 1);
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<int> letters;
  letters.reserve(crossed.size());
  for (const auto& [x, letter] : crossed) letters.push_back(p.x < q.x ? letter : -letter);
  if (q.x < p.x) std::reverse(letters.begin(), letters.end());
  return letters;
}

std::vector<std::size_t> ClassOracle::NeighboursOf(std::size_t node) const {
  std::vector<std::size_t> neighbours;
  for (const Arc& arc : arcs_[node]) neighbours.push_back(arc.to);
  return neighbours;
}

int ClassOracle::AppendPolyline(int word, std::span<const Point> polyline) {
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    for (const int letter : LettersOf(polyline[i - 1], polyline[i])) word = words_.Append(word, letter);
  }
  return word;
}

std::vector<double> ClassOracle::DistancesTo(std::span<const std::size_t> targets) const {
  std::vector<double> distance(arcs_.size(), kInfinity);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](std::size_t node, double length) {
    if (length >= distance[node]) return;
    distance[node] = length;
    queue.emplace(length, node);
  };
  for (const std::size_t target : targets) offer(target, 0);
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > distance[node]) continue;
    for (const Arc& arc : arcs_[node]) offer(arc.to, length + arc.length);
  }
  return distance;
}

bool ClassOracle::Run(const Search& search, const std::function<bool(const State&)>& visit) {
  // By length + remaining, which is consistent: the first visit of a state is the shortest.
  using Entry = std::tuple<double, double, std::size_t, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::unordered_map<std::uint64_t, double> best;
  const auto offer = [&](const State& state) {
    const double total = state.length + (search.remaining.empty() ? 0 : search.remaining[state.node]);
    if (!(total <= search.limit) || (search.allowed && !search.allowed(state))) return;
    const auto [found, is_new] = best.try_emplace(KeyOf(state.node, state.word), state.length);
    if (!is_new && found->second <= state.length) return;
    found->second = state.length;
    queue.emplace(total, state.length, state.node, state.word);
  };
  for (const std::size_t node : search.start) offer({node, search.word, 0});
  while (!queue.empty()) {
    if (best.size() > kMaxStates) return false;
    const auto [total, length, node, word] = queue.top();
    queue.pop();
    if (length > best[KeyOf(node, word)]) continue;
    if (!visit({node, word, length})) return true;
    for (const Arc& arc : arcs_[node]) {
      int next = word;
      for (const int letter : arc.letters) next = words_.Append(next, letter);
      offer({arc.to, next, length + arc.length});
    }
  }
  return true;
}

std::optional<std::vector<OracleClass>> ClassOracle::Classes(Point from, Point to, double max_length) {
  return ClassesBetween(sight_.NodesAt(from), sight_.NodesAt(to), max_length);
}

std::optional<std::vector<OracleClass>> ClassOracle::ClassesBetween(std::span<const std::size_t> from,
                                                                    std::span<const std::size_t> to,
                                                                    double max_length) {
  std::map<int, double> shortest;
  const auto visit = [&](const State& state) {
    if (std::find(to.begin(), to.end(), state.node) == to.end()) return true;
    const auto [found, is_new] = shortest.try_emplace(state.word, state.length);
    if (!is_new) found->second = std::min(found->second, state.length);
    return true;
  };
  const Search search{
      .start = {from.begin(), from.end()}, .word = 0, .remaining = DistancesTo(to), .limit = max_length, .allowed = {}};
  if (!Run(search, visit)) return std::nullopt;
  std::vector<OracleClass> classes;
  classes.reserve(shortest.size());
  for (const auto& [word, length] : shortest) classes.push_back({length, words_.ToWord(word)});
  std::sort(classes.begin(), classes.end(),
            [](const OracleClass& a, const OracleClass& b) { return a.length < b.length; });
  return classes;
}

double ClassOracle::LengthOf(std::size_t from, std::size_t to, int word, double at_most) {
  double length = kInfinity;
  // A little more, since sums of the same legs in another order may round differently.
  const Search search{.start = {from},
                      .word = 0,
                      .remaining = DistancesTo(std::vector{to}),
                      .limit = at_most * (1 + 1e-9),
                      .allowed = {}};
  Run(search, [&](const State& state) {
    if (state.node != to || state.word != word) return true;
    length = state.length;
    return false;
  });
  return length;
}

}  // namespace tautline
