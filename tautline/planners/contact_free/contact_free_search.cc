#include "tautline/planners/contact_free/contact_free_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

constexpr int kStepsPerCheck = 16;
/// Motions of different classes and beginnings that are handed out at most.
constexpr std::size_t kMostMotions = 24;
/// Primitives that a beginning has, at most.
constexpr int kBeginning = 4;

/// The same velocity for so many steps.
struct Primitive {
  Velocity velocity;
  int steps = 1;
};

/// Turns on the spot are half as long as the others.
std::vector<Primitive> MakePrimitives(const TetherEnvOptions& env, int steps) {
  std::vector<Primitive> primitives;
  for (const Velocity& velocity : BasicVelocities(env)) {
    primitives.push_back({velocity, velocity.speed_m_per_s == 0 ? std::max(1, steps / 2) : steps});
  }
  return primitives;
}

std::uint64_t Mix(std::uint64_t hash, std::int64_t value) {
  hash ^= static_cast<std::uint64_t>(value) + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
  hash *= 0xbf58476d1ce4e5b9ULL;
  return hash ^ (hash >> 29);
}

std::int64_t CellOf(double value, double cell) { return static_cast<std::int64_t>(std::floor(value / cell)); }

/// Words by number, so that equal ones are found fast.
class WordNumbers {
 public:
  int NumberOf(const Word& word) {
    const auto [found, is_new] = numbers_.try_emplace(word, static_cast<int>(words_.size()));
    if (is_new) words_.push_back(&found->first);
    return found->second;
  }
  const Word& word(int number) const { return *words_[static_cast<std::size_t>(number)]; }

 private:
  std::map<Word, int> numbers_;
  std::vector<const Word*> words_;
};

struct State {
  std::optional<TetherEnv> env;  ///< Until it is expanded.
  double cost = 0;               ///< So far.
  int contacts = 0;              ///< Steps so far after which something touched.
  std::uint64_t key = 0;
  int parent = -1;
  int word = 0;       ///< Of the robot's way from the base.
  Velocity velocity;  ///< That led here from the parent,
  int steps = 0;      ///< for so many steps.
};

struct Entry {
  double total;
  double left;
  int state;

  friend bool operator>(const Entry& a, const Entry& b) {
    return std::tie(a.total, a.left, a.state) > std::tie(b.total, b.left, b.state);
  }
};

class Search {
 public:
  Search(const SearchProblem& problem, const SearchGrain& grain)
      : problem_(problem), grain_(grain), primitives_(MakePrimitives(problem.env->options(), grain.primitive_steps)) {
    const TetherEnvOptions& env = problem.env->options();
    // No motion is cheaper a metre.
    per_metre_ = problem.costs.per_metre - env.reward.time / (env.speed_m_per_s * env.dt_s);
  }

  SearchOutcome Run() {
    State start{.env = *problem_.env};
    start.word = words_.NumberOf(problem_.rays->WordOf(problem_.env->task().laid));
    start.key = KeyOf(start);
    Push(std::move(start));
    SearchOutcome outcome;
    StopCheck stop(problem_.keep_going, kStepsPerCheck);
    try {
      int last = grain_.layers, first_found = -1;
      for (int layer = 0; layer < last && !open_.empty(); ++layer) {
        const std::vector<int> beam = TakeBeam();
        for (const int state : beam) {
          if (outcome.expansions >= problem_.budget) return Ended(SearchEnd::kBudget, outcome);
          stop.Step();
          ++outcome.expansions;
          Expand(state);
        }
        if (found_clean_ && first_found < 0) first_found = layer;
        if (first_found >= 0) last = std::min(last, first_found + grain_.patience);
      }
    } catch (const Stopped&) {
      return Ended(SearchEnd::kBudget, outcome);
    }
    return Ended(open_.empty() ? SearchEnd::kExhausted : SearchEnd::kBudget, outcome);
  }

 private:
  SearchOutcome Ended(SearchEnd end, SearchOutcome outcome) const {
    if (!goals_.empty()) return Found(outcome);
    outcome.end = end;
    return outcome;
  }

  SearchOutcome Found(SearchOutcome outcome) const {
    outcome.end = SearchEnd::kFound;
    outcome.cost = goal_cost_;
    std::vector<int> goals;
    for (const auto& [kind, state] : goals_) goals.push_back(state);
    std::sort(goals.begin(), goals.end(), [&](int a, int b) {
      return std::pair(states_[static_cast<std::size_t>(a)].cost, a) <
             std::pair(states_[static_cast<std::size_t>(b)].cost, b);
    });
    if (goals.size() > kMostMotions) goals.resize(kMostMotions);
    for (const int goal : goals) outcome.motions.push_back(MotionTo(goal));
    return outcome;
  }

  std::vector<Velocity> MotionTo(int goal) const {
    std::vector<Velocity> motion;
    for (int at = goal; at >= 0; at = states_[static_cast<std::size_t>(at)].parent) {
      const State& state = states_[static_cast<std::size_t>(at)];
      motion.insert(motion.end(), static_cast<std::size_t>(state.steps), state.velocity);
    }
    std::reverse(motion.begin(), motion.end());
    return motion;
  }

  /// What states may cost that are of interest yet.
  double Limit() const { return goal_cost_ + grain_.slack; }

  double Left(Point at) const {
    return per_metre_ * std::max(0.0, problem_.guide->LowerBound(at) - problem_.env->options().goal_radius_m);
  }

  void Push(State state) {
    const double left = Left(state.env->pose().at);
    if (state.cost + left >= Limit()) return;
    const auto [found, is_new] = best_.try_emplace(state.key, state.cost);
    if (!is_new) {
      if (found->second <= state.cost) return;
      found->second = state.cost;
    }
    open_.push_back({state.cost + left + Risk(state), left, static_cast<int>(states_.size())});
    states_.push_back(std::move(state));
  }

  /// What contacts the cable is likely to bring: it lies near obstacles.
  double Risk(const State& state) const {
    if (grain_.risk == 0) return 0;
    double risk = 0;
    const ContactMap& map = state.env->map();
    const auto nodes = state.env->cable().nodes();
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      const double clear = std::min(map.ClearAround(nodes[i]), map.ClearAround(0.5 * (nodes[i] + nodes[i + 1])));
      if (clear < grain_.risk_m) risk += 1 - clear / grain_.risk_m;
    }
    return grain_.risk * risk;
  }

  /// The most promising states, not too many of them in one place; the others are given up.
  std::vector<int> TakeBeam() {
    std::sort(open_.begin(), open_.end(), [](const Entry& a, const Entry& b) { return b > a; });
    std::vector<int> beam;
    std::vector<Entry> rest;
    std::unordered_map<std::uint64_t, int> crowd;
    const auto take = [&](const Entry& entry, int limit) {
      const State& state = states_[static_cast<std::size_t>(entry.state)];
      if (static_cast<int>(beam.size()) >= limit || ++crowd[CrowdOf(state)] > grain_.crowd) return false;
      beam.push_back(entry.state);
      return true;
    };
    for (const Entry& entry : open_) {
      State& state = states_[static_cast<std::size_t>(entry.state)];
      const bool live = state.cost <= best_.at(state.key) && state.cost + entry.left < Limit();
      if (!live) {
        state.env.reset();
      } else if (!take(entry, grain_.width)) {
        rest.push_back(entry);
      }
    }
    // What touches much, but comes near the goal: contacts may be without remedy, and a motion is wanted in any case.
    std::sort(rest.begin(), rest.end(), [](const Entry& a, const Entry& b) {
      return std::tie(a.left, a.total, a.state) < std::tie(b.left, b.total, b.state);
    });
    crowd.clear();
    for (const Entry& entry : rest) {
      if (!take(entry, grain_.width + grain_.width / 4)) states_[static_cast<std::size_t>(entry.state)].env.reset();
    }
    open_.clear();
    return beam;
  }

  std::uint64_t CrowdOf(const State& state) const {
    const RobotPose& pose = state.env->pose();
    std::uint64_t key = Mix(0, CellOf(pose.at.x, grain_.crowd_m));
    key = Mix(key, CellOf(pose.heading_rad, 2 * std::numbers::pi / grain_.crowd_headings));
    return Mix(Mix(key, CellOf(pose.at.y, grain_.crowd_m)), state.word);
  }

  void Expand(int at) {
    const TetherEnv env = *std::move(states_[static_cast<std::size_t>(at)].env);
    states_[static_cast<std::size_t>(at)].env.reset();
    for (const Primitive& primitive : primitives_) Try(at, env, primitive);
  }

  void Try(int from, const TetherEnv& env, const Primitive& primitive) {
    const State& parent = states_[static_cast<std::size_t>(from)];
    // No turn back on the spot.
    if (primitive.velocity.speed_m_per_s == 0 && parent.velocity.speed_m_per_s == 0 &&
        parent.velocity.turn_rad_per_s * primitive.velocity.turn_rad_per_s < 0) {
      return;
    }
    State state{.env = env, .parent = from, .word = parent.word, .velocity = primitive.velocity};
    MotionCosts costs;
    bool at_goal = false;
    for (int k = 0; k < primitive.steps && !at_goal; ++k) {
      EnvStep step = state.env->StepWith(primitive.velocity.speed_m_per_s, primitive.velocity.turn_rad_per_s);
      if (step.robot_obstacle || step.held || step.cut) return;
      step.cable_robot = step.cable_robot || CableIsNear(*state.env);
      AddStep(primitive.velocity, step, env.options(), costs);
      ++state.steps;
      at_goal = step.at_goal;
    }
    state.cost = parent.cost + costs.penalty + problem_.costs.per_metre * costs.length_m;
    state.contacts = parent.contacts + costs.cable_obstacle_steps + costs.cable_robot_steps;
    FollowWord(env.pose().at, state);
    if (costs.cable_obstacle_steps > 0 && !CableHasWord(state)) return;
    if (at_goal) {
      AddGoal(std::move(state));
      return;
    }
    state.key = KeyOf(state);
    Push(std::move(state));
  }

  void AddGoal(State state) {
    const std::pair kind(state.word, BeginningOf(state));
    const auto [found, is_new] = goals_.try_emplace(kind, static_cast<int>(states_.size()));
    if (!is_new && states_[static_cast<std::size_t>(found->second)].cost <= state.cost) return;
    found->second = static_cast<int>(states_.size());
    found_clean_ = found_clean_ || state.contacts == 0;
    goal_cost_ = std::min(goal_cost_, state.cost);
    states_.push_back(std::move(state));
  }

  /// The state that a few primitives had led to on the way: how the motion begins.
  std::uint64_t BeginningOf(const State& state) const {
    std::array<std::uint64_t, kBeginning> first{};
    int depth = 0;
    for (int at = state.parent; at >= 0; at = states_[static_cast<std::size_t>(at)].parent) {
      first[static_cast<std::size_t>(depth++ % kBeginning)] = states_[static_cast<std::size_t>(at)].key;
    }
    return first[static_cast<std::size_t>(depth % kBeginning)];
  }

  void FollowWord(Point from, State& state) {
    const std::array<Point, 2> way = {from, state.env->pose().at};
    const Word crossed = problem_.rays->WordOf(way);
    if (!crossed.empty()) state.word = words_.NumberOf(words_.word(state.word) * crossed);
  }

  /// Whether the cable has the class of the robot's way.
  bool CableHasWord(const State& state) const {
    const auto nodes = state.env->cable().nodes();
    Polyline cable(nodes.begin(), nodes.end());
    cable.push_back(state.env->pose().at);
    return problem_.rays->WordOf(cable) == words_.word(state.word);
  }

  /// As Eq. 9 of the environment, with the margin.
  bool CableIsNear(const TetherEnv& env) const {
    const double link = env.options().link_length_m, radius = env.options().robot_radius_m;
    const double near = radius + problem_.costs.cable_margin_m;
    const auto nodes = env.cable().nodes();
    // Nodes that the tail has about it are never far: a margin counts those two links away.
    const auto skipped = static_cast<std::size_t>(std::ceil(radius / link)) + 1;
    for (std::size_t i = 0; i + skipped < nodes.size(); ++i) {
      const Point off = nodes[i] - env.pose().at;
      if (Dot(off, off) <= near * near) return true;
    }
    return false;
  }

  std::uint64_t KeyOf(const State& state) const {
    const RobotPose& pose = state.env->pose();
    const double sector = 2 * std::numbers::pi / grain_.headings;
    std::uint64_t key = Mix(0, CellOf(pose.at.x, grain_.cell_m));
    key = Mix(key, CellOf(pose.at.y, grain_.cell_m));
    key = Mix(key,
              (static_cast<std::int64_t>(std::lround(pose.heading_rad / sector)) + grain_.headings) % grain_.headings);
    key = Mix(key, state.word);
    const auto nodes = state.env->cable().nodes();
    const int count = std::min(grain_.shape_nodes, static_cast<int>(nodes.size()) - 2);
    for (int k = 0; k < count; ++k) {
      const Point node = nodes[nodes.size() - 2 - static_cast<std::size_t>(k)];
      key = Mix(Mix(key, CellOf(node.x, grain_.shape_m)), CellOf(node.y, grain_.shape_m));
    }
    return key;
  }

  const SearchProblem& problem_;
  const SearchGrain& grain_;
  std::vector<Primitive> primitives_;
  double per_metre_ = 0;
  WordNumbers words_;
  std::vector<State> states_;
  std::unordered_map<std::uint64_t, double> best_;
  std::vector<Entry> open_;
  /// The cheapest state at the goal, by its word and how the motion begins.
  std::map<std::pair<int, std::uint64_t>, int> goals_;
  double goal_cost_ = std::numeric_limits<double>::infinity();
  bool found_clean_ = false;  ///< One of these without a contact.
};

}  // namespace

SearchOutcome SearchMotion(const SearchProblem& problem, const SearchGrain& grain) {
  TAUTLINE_CHECK(problem.env != nullptr && problem.guide != nullptr && problem.rays != nullptr);
  return Search(problem, grain).Run();
}

}  // namespace tautline
