#include "bench/peers/h_augmented_graph.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A queue's entry: the guessed length of the whole way, and a state or a node.
using Entry = std::pair<double, std::int32_t>;
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

std::vector<std::int32_t> LettersBetween(const TautSpace& space, Point a, Point b) {
  const Word word = space.rays().WordOf(Polyline{a, b});
  std::vector<std::int32_t> letters;
  for (const Letter letter : word.letters()) letters.push_back(LetterNumber(letter));
  return letters;
}

}  // namespace

/// One search over states. Node numbers: the corners, then the start, then the goal.
struct HAugmentedGraph::Search {
  const Terminal& from;
  std::vector<std::int32_t> arc_to_goal;  ///< By corner: which of `goal`'s arcs leads back to it, or -1.
  const Terminal& goal;
  std::optional<Arc> direct;
  std::function<double(std::int32_t node)> rest;
  std::function<bool(std::int32_t node, std::int32_t word)> allowed;
  double max_length;
  StateTable& states;
  WordTrie& words;
  Queue queue;

  std::int32_t start_node() const { return static_cast<std::int32_t>(arc_to_goal.size()); }
  std::int32_t goal_node() const { return start_node() + 1; }

  void Offer(std::int32_t node, std::int32_t word, double length, std::int32_t parent) {
    const double total = length + rest(node);
    if (!(total <= max_length) || !allowed(node, word)) return;
    const std::int32_t id = states.Obtain(node, word);
    PeerState& state = states[id];
    if (state.length <= length) return;
    state.length = length;
    state.parent = parent;
    queue.emplace(total, id);
  }

  void OfferAlong(const Arc& arc, std::int32_t node, std::int32_t id, bool backwards) {
    std::int32_t word = states[id].word;
    if (backwards) {
      for (auto it = arc.letters.rbegin(); it != arc.letters.rend(); ++it) word = words.Append(word, -*it);
    } else {
      for (const std::int32_t letter : arc.letters) word = words.Append(word, letter);
    }
    Offer(node, word, states[id].length + arc.length, id);
  }

  /// The next state to settle, or nothing.
  std::optional<std::int32_t> Pop() {
    while (!queue.empty()) {
      const std::int32_t id = queue.top().second;
      queue.pop();
      if (std::exchange(states[id].settled, true)) continue;
      return id;
    }
    return std::nullopt;
  }
};

namespace {

std::vector<std::int32_t> ArcsByCorner(const HAugmentedGraph::Terminal& terminal, std::size_t corners) {
  std::vector<std::int32_t> arc(corners, -1);
  for (std::size_t i = 0; i < terminal.arcs.size(); ++i) {
    arc[static_cast<std::size_t>(terminal.arcs[i].to)] = static_cast<std::int32_t>(i);
  }
  return arc;
}

}  // namespace

HAugmentedGraph::HAugmentedGraph(const TautSpace& space, SightLines lines) : space_(&space), lines_(lines) {
  if (lines == SightLines::kAll) {
    for (const FreeComponent& component : space.free_space().components) {
      nodes_.insert(nodes_.end(), component.outer.points.begin(), component.outer.points.end());
      for (const BoundaryRing& hole : component.holes) {
        nodes_.insert(nodes_.end(), hole.points.begin(), hole.points.end());
      }
    }
  } else {
    for (const Corner& corner : space.corners().all()) nodes_.push_back(corner.point);
  }
  arcs_.resize(nodes_.size());
  if (lines == SightLines::kAll) AddAll();
  if (lines == SightLines::kTangent) AddTangents();
  if (lines == SightLines::kBitangents) AddBitangents();
}

void HAugmentedGraph::AddAll() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (const Arc& arc : Connect(nodes_[i]).arcs) {
      if (static_cast<std::size_t>(arc.to) != i) arcs_[i].push_back(arc);
    }
  }
}

void HAugmentedGraph::AddTangents() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Corner& corner = space_->corners()[CornerId(static_cast<std::int32_t>(i))];
    for (const Sighting& seen : SeeFromPoint(space_->mesh(), space_->corners(), {corner.point, corner.first})) {
      const auto j = seen.corner.index();
      if (j == i) continue;
      const Point from = corner.point, to = nodes_[j];
      arcs_[i].push_back({static_cast<std::int32_t>(j), Distance(from, to), LettersBetween(*space_, from, to)});
      // A line that is tangent at both ends is seen from both.
      if (corner.TangentFrom(to) != Side::kNone) continue;
      arcs_[j].push_back({static_cast<std::int32_t>(i), Distance(from, to), LettersBetween(*space_, to, from)});
    }
  }
}

void HAugmentedGraph::AddBitangents() {
  for (const TautEdge& edge : space_->graph().edges()) {
    const Point a = space_->corners()[edge.from].point, b = space_->corners()[edge.to].point;
    arcs_[edge.from.index()].push_back(
        {static_cast<std::int32_t>(edge.to.index()), Distance(a, b), LettersBetween(*space_, a, b)});
  }
}

HAugmentedGraph::Terminal HAugmentedGraph::Connect(Point p) const {
  const auto place = space_->Locate(p);
  TAUTLINE_CHECK(place);
  Terminal terminal{*place, {}};
  const auto add = [&](std::size_t node) {
    terminal.arcs.push_back({static_cast<std::int32_t>(node), Distance(place->point, nodes_[node]),
                             LettersBetween(*space_, place->point, nodes_[node])});
  };
  if (lines_ == SightLines::kAll) {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      Walk walk(*place);
      if (!WalkStraight(space_->mesh(), nodes_[node], walk)) add(node);
    }
  } else {
    for (const Sighting& seen : SeeFromPoint(space_->mesh(), space_->corners(), *place)) add(seen.corner.index());
  }
  return terminal;
}

std::optional<HAugmentedGraph::Arc> HAugmentedGraph::Direct(const Terminal& from, const Terminal& to,
                                                            std::int32_t node) const {
  Walk walk(from.place);
  if (WalkStraight(space_->mesh(), to.place.point, walk)) return std::nullopt;
  return Arc{node, Distance(from.place.point, to.place.point),
             LettersBetween(*space_, from.place.point, to.place.point)};
}

/// The distance to a terminal from every corner, without words; then from anywhere else, zero.
std::vector<double> HAugmentedGraph::PlainDistances(const Terminal& to) const {
  std::vector<double> distance(arcs_.size(), kInfinity);
  Queue queue;
  const auto offer = [&](const Arc& arc, double length) {
    double& least = distance[static_cast<std::size_t>(arc.to)];
    if (length + arc.length >= least) return;
    least = length + arc.length;
    queue.emplace(least, arc.to);
  };
  for (const Arc& arc : to.arcs) offer(arc, 0);
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > distance[static_cast<std::size_t>(node)]) continue;
    for (const Arc& arc : arcs_[static_cast<std::size_t>(node)]) offer(arc, length);
  }
  return distance;
}

void HAugmentedGraph::Expand(Search& search, std::int32_t id) const {
  const std::int32_t node = search.states[id].node;
  if (node == search.goal_node()) return;
  if (node == search.start_node()) {
    if (search.direct) search.OfferAlong(*search.direct, search.goal_node(), id, false);
    for (const Arc& arc : search.from.arcs) search.OfferAlong(arc, arc.to, id, false);
    return;
  }
  for (const Arc& arc : arcs_[static_cast<std::size_t>(node)]) search.OfferAlong(arc, arc.to, id, false);
  const std::int32_t last = search.arc_to_goal[static_cast<std::size_t>(node)];
  if (last < 0) return;
  search.OfferAlong(search.goal.arcs[static_cast<std::size_t>(last)], search.goal_node(), id, true);
}

PeerClassList HAugmentedGraph::FindClasses(const Terminal& from, const Terminal& to, const PeerOptions& options) const {
  const auto corners = static_cast<std::int32_t>(arcs_.size());
  const Point goal = to.place.point;
  const auto point = [&](std::int32_t node) {
    return node < corners ? nodes_[static_cast<std::size_t>(node)] : node == corners ? from.place.point : goal;
  };
  std::vector<double> distance;
  if (options.guess == Guess::kExact) distance = PlainDistances(to);
  const auto rest = [&](std::int32_t node) {
    if (options.guess == Guess::kStraight) return Distance(point(node), goal);
    return distance.empty() || node >= corners ? 0 : distance[static_cast<std::size_t>(node)];
  };
  StateTable states;
  WordTrie words;
  Search search{from,
                ArcsByCorner(to, arcs_.size()),
                to,
                Direct(from, to, corners + 1),
                rest,
                [](std::int32_t, std::int32_t) { return true; },
                options.max_length,
                states,
                words,
                {}};
  PeerClassList list;
  search.Offer(search.start_node(), 0, 0, -1);
  while (list.classes.size() < options.max_count) {
    list.gave_up = states.size() > options.max_states;
    const auto id = list.gave_up ? std::nullopt : search.Pop();
    if (!id) break;
    if (states[*id].node == search.goal_node()) {
      PeerClass& found = list.classes.emplace_back(states[*id].length);
      for (std::int32_t at = *id; at >= 0; at = states[at].parent) found.points.push_back(point(states[at].node));
      std::reverse(found.points.begin(), found.points.end());
    }
    Expand(search, *id);
  }
  list.states = states.size();
  return list;
}

HAugmentedGraph::Cover HAugmentedGraph::MakeCover(const Terminal& base, const Terminal& goal,
                                                  const PeerOptions& options) const {
  Cover cover{base, goal, {}, {}, options.max_length, false};
  Search search{base,
                ArcsByCorner(goal, arcs_.size()),
                goal,
                Direct(base, goal, static_cast<std::int32_t>(arcs_.size()) + 1),
                [](std::int32_t) { return 0.0; },
                [](std::int32_t, std::int32_t) { return true; },
                options.max_length,
                cover.states,
                cover.words,
                {}};
  search.Offer(search.start_node(), 0, 0, -1);
  while (const auto id = search.Pop()) {
    cover.gave_up = cover.states.size() > options.max_states;
    if (cover.gave_up) break;
    Expand(search, *id);
  }
  return cover;
}

PeerMotion HAugmentedGraph::Plan(Cover& cover, const Start& start, const PeerOptions& options) const {
  const auto corners = static_cast<std::int32_t>(arcs_.size());
  const Point goal = cover.goal.place.point;
  const auto rest = [&](std::int32_t node) {
    if (node > corners) return 0.0;
    return Distance(node < corners ? nodes_[static_cast<std::size_t>(node)] : start.robot.place.point, goal);
  };
  // The robot's own node is in no cover; that the laid cable fits is given.
  const auto allowed = [&](std::int32_t node, std::int32_t word) {
    return node == corners || cover.states.Find(node, word) >= 0;
  };
  StateTable states;
  Search search{start.robot, ArcsByCorner(cover.goal, arcs_.size()),
                cover.goal,  Direct(start.robot, cover.goal, corners + 1),
                rest,        allowed,
                kInfinity,   states,
                cover.words, {}};
  PeerMotion motion;
  search.Offer(search.start_node(), cover.words.Append(0, start.laid), 0, -1);
  while (const auto id = search.Pop()) {
    motion.gave_up = states.size() > options.max_states;
    if (motion.gave_up) break;
    if (states[*id].node == search.goal_node()) {
      motion.length = states[*id].length;
      break;
    }
    Expand(search, *id);
  }
  motion.states = states.size();
  return motion;
}

}  // namespace tautline
