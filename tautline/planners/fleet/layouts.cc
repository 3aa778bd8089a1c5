#include "tautline/planners/fleet/layouts.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "tautline/planners/fleet/route_crossing.h"
#include "tautline/planners/fleet/route_search.h"

namespace tautline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// The sums of lengths in bounds and in totals are rounded differently; bounds are lowered by this share.
constexpr double kRounding = 1e-12;
/// The first round looks at lines that are longer than the shortest by up to this share of the mean straight way, and
/// each later round at twice as much: few rounds suffice, and the last one costs about as much as all before.
constexpr double kFirstSlack = 0.25;

/// One bit for each cable line of a robot.
using Bits = std::vector<std::uint64_t>;

void Add(Bits& bits, std::size_t k) { bits[k / 64] |= std::uint64_t{1} << (k % 64); }

/// Calls visit(k) for each bit in order until it returns false.
template <class Visit>
void ForEachBit(const Bits& bits, Visit visit) {
  for (std::size_t word = 0; word < bits.size(); ++word) {
    for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1) {
      if (!visit(64 * word + static_cast<std::size_t>(__builtin_ctzll(rest)))) return;
    }
  }
}

/// Counts the steps of all parts of a search, and asks whether to go on.
class Budget {
 public:
  Budget(std::int64_t steps, const Watcher& watch) : all_(steps), left_(steps), watch_(watch) {}

  std::int64_t left() const { return stopped_ ? 0 : left_; }

  /// False when the budget is spent or the caller says stop.
  bool Spend(std::int64_t steps = 1) {
    constexpr std::int64_t kStepsPerQuestion = 4096;
    left_ -= steps;
    if ((since_ += steps) >= kStepsPerQuestion) {
      since_ = 0;
      const double spent = 1 - static_cast<double>(left_) / static_cast<double>(all_);
      if (watch_ && !watch_("share of the budget", std::min(spent, 1.0))) stopped_ = true;
    }
    return left() > 0;
  }

 private:
  std::int64_t all_;
  std::int64_t left_;
  std::int64_t since_ = 0;
  bool stopped_ = false;
  const Watcher& watch_;
};

/// Which cable lines of two robots go together; grows with the lists of lines.
class Compatibility {
 public:
  explicit Compatibility(const FleetGround& ground) : ground_(ground), rows_(ground.size() * ground.size()) {}

  /// Compares what was not compared yet; false when the budget ran out.
  bool Extend(const std::vector<RouteSearch>& searches, Budget& budget) {
    for (std::size_t i = 0; i < searches.size(); ++i) {
      for (std::size_t j = i + 1; j < searches.size(); ++j) {
        if (!ExtendPair(searches[i].candidates(), searches[j].candidates(), i, j, budget)) return false;
      }
    }
    return true;
  }

  /// The lines of robot j that go with line `a` of robot i < j.
  const Bits& Row(std::size_t i, std::size_t a, std::size_t j) const { return Pair(i, j).bits[a]; }

 private:
  struct Rows {
    std::vector<Bits> bits;  ///< By line of the first robot.
    std::size_t compared = 0;
  };

  Rows& Pair(std::size_t i, std::size_t j) { return rows_[i * ground_.size() + j]; }
  const Rows& Pair(std::size_t i, std::size_t j) const { return rows_[i * ground_.size() + j]; }

  bool ExtendPair(const std::vector<CandidateRoute>& of_i, const std::vector<CandidateRoute>& of_j, std::size_t i,
                  std::size_t j, Budget& budget) {
    Rows& rows = Pair(i, j);
    const std::size_t old_i = rows.bits.size(), old_j = rows.compared;
    rows.bits.resize(of_i.size());
    rows.compared = of_j.size();
    for (std::size_t a = 0; a < of_i.size(); ++a) {
      rows.bits[a].resize((of_j.size() + 63) / 64);
      for (std::size_t b = a < old_i ? old_j : 0; b < of_j.size(); ++b) {
        if (!RoutesCross(ground_, of_i[a].route, of_j[b].route)) Add(rows.bits[a], b);
        if (!budget.Spend()) return false;
      }
    }
    return true;
  }

  const FleetGround& ground_;
  std::vector<Rows> rows_;
};

/// Puts layouts together from lines that go together.
class Combination {
 public:
  /// A layout by the lines of the robots; shorter ones first.
  using Choice = std::pair<double, std::vector<std::uint32_t>>;

  Combination(const std::vector<RouteSearch>& searches, const Compatibility& compatible, Budget& budget)
      : searches_(searches), compatible_(compatible), budget_(budget), chosen_(searches.size()) {}

  /// The `most` shortest layouts with totals up to `cap`; false when the budget ran out.
  bool FindShortest(double cap, std::size_t most) {
    cap_ = cap;
    most_ = most;
    return Choose(0, 0, AllAllowed());
  }

  /// How many layouts there are with totals up to `cap`; nothing when the budget ran out.
  std::optional<std::uint64_t> Count(double cap) {
    cap_ = cap;
    most_ = 0;
    count_ = 0;
    if (!Choose(0, 0, AllAllowed())) return std::nullopt;
    return count_;
  }

  /// What was found, the shortest first.
  std::vector<Choice> Take() {
    std::vector<Choice> choices;
    for (; !best_.empty(); best_.pop()) choices.push_back(best_.top());
    std::reverse(choices.begin(), choices.end());
    return choices;
  }

 private:
  double LengthOf(std::size_t robot, std::size_t line) const { return searches_[robot].candidates()[line].length; }

  std::vector<Bits> AllAllowed() const {
    std::vector<Bits> allowed;
    for (const RouteSearch& search : searches_) {
      allowed.emplace_back((search.candidates().size() + 63) / 64);
      for (std::size_t k = 0; k < search.candidates().size(); ++k) Add(allowed.back(), k);
    }
    return allowed;
  }

  /// The least that the robots from `first` on still need, or infinity when one of them has no line left.
  double LeastRest(std::size_t first, const std::vector<Bits>& allowed) const {
    double least = 0;
    for (std::size_t j = first; j < allowed.size(); ++j) {
      double shortest = kInfinity;
      // Lines are sorted by length, so the first one that is left is the shortest.
      ForEachBit(allowed[j], [&](std::size_t k) {
        shortest = LengthOf(j, k);
        return false;
      });
      least += shortest;
    }
    return least;
  }

  bool TooLong(double least) const {
    const double lowered = least * (1 - kRounding);
    if (least == kInfinity || lowered > cap_) return true;
    return most_ > 0 && best_.size() == most_ && lowered > best_.top().first;
  }

  bool Choose(std::size_t robot, double length, const std::vector<Bits>& allowed) {
    if (robot == searches_.size()) {
      Finish(length);
      return true;
    }
    const double rest = LeastRest(robot + 1, allowed);
    bool within_budget = true;
    const auto cost = static_cast<std::int64_t>(allowed.size() - robot);
    ForEachBit(allowed[robot], [&](std::size_t line) {
      const double with_line = length + LengthOf(robot, line);
      if (TooLong(with_line + rest)) return false;
      within_budget = budget_.Spend(cost) && ChooseRest(robot, line, with_line, allowed);
      return within_budget;
    });
    return within_budget;
  }

  bool ChooseRest(std::size_t robot, std::size_t line, double length, std::vector<Bits> allowed) {
    chosen_[robot] = static_cast<std::uint32_t>(line);
    for (std::size_t j = robot + 1; j < allowed.size(); ++j) {
      const Bits& row = compatible_.Row(robot, line, j);
      for (std::size_t word = 0; word < row.size(); ++word) allowed[j][word] &= row[word];
    }
    if (TooLong(length + LeastRest(robot + 1, allowed))) return true;
    return Choose(robot + 1, length, allowed);
  }

  void Finish(double total) {
    if (total > cap_) return;
    ++count_;
    if (most_ == 0) return;
    Choice choice{total, chosen_};
    if (best_.size() == most_) {
      if (!(choice < best_.top())) return;
      best_.pop();
    }
    best_.push(std::move(choice));
  }

  const std::vector<RouteSearch>& searches_;
  const Compatibility& compatible_;
  Budget& budget_;
  std::vector<std::uint32_t> chosen_;
  std::priority_queue<Choice> best_;  ///< The longest on top.
  double cap_ = kInfinity;
  std::size_t most_ = 0;
  std::uint64_t count_ = 0;
};

/// The rounds of the search, each with longer lines than the one before.
class LayoutsSearch {
 public:
  LayoutsSearch(const FleetGround& ground, const LayoutsOptions& options)
      : ground_(ground),
        options_(options),
        sight_(ground),
        compatible_(ground),
        budget_(options.budget, options.watch) {
    for (std::size_t i = 0; i < ground.size(); ++i) {
      straight_ += Distance(ground.robots()[i].start, ground.robots()[i].target);
    }
    for (std::size_t i = 0; i < ground.size(); ++i) {
      searches_.emplace_back(ground, sight_, RobotId(i), LimitOf(RobotId(i)));
    }
  }

  LayoutsResult Run() {
    LayoutsResult result;
    result.budget_exceeded = !FindFirstLines(result) || (result.without_route.empty() && !RunRounds(result));
    result.complete = !result.budget_exceeded && !more_;
    if (result.complete) result.complete_below = kInfinity;
    for (const RouteSearch& search : searches_) result.routes += search.candidates().size();
    if (options_.count_all && !result.without_route.empty()) result.count = 0;
    return result;
  }

 private:
  double LimitOf(RobotId id) const {
    const FleetRobot& robot = ground_.robot(id);
    double limit = std::min(options_.max_length.value_or(kInfinity), robot.tether.value_or(kInfinity));
    if (options_.max_total) {
      const double others = straight_ - Distance(robot.start, robot.target);
      limit = std::min(limit, (*options_.max_total - others) * (1 + kRounding));
    }
    return limit;
  }

  /// The shortest line of each robot.
  bool FindFirstLines(LayoutsResult& result) {
    for (std::size_t i = 0; i < searches_.size(); ++i) {
      RouteSearch& search = searches_[i];
      while (search.candidates().empty() && search.next_bound() < kInfinity) {
        if (!budget_.Spend(search.Extend(search.next_bound(), std::min<std::int64_t>(budget_.left(), 1000)))) {
          return false;
        }
      }
      if (search.candidates().empty()) {
        result.without_route.emplace_back(i);
      } else {
        shortest_.push_back(search.candidates().front().length);
        least_ += shortest_.back();
      }
    }
    return true;
  }

  /// False when the budget ran out.
  bool RunRounds(LayoutsResult& result) {
    const double limit = options_.max_total.value_or(kInfinity);
    for (double slack = options_.count_all ? kInfinity : kFirstSlack * straight_ / static_cast<double>(ground_.size());;
         slack *= 2) {
      if (!ExtendLines(slack) || !compatible_.Extend(searches_, budget_)) return false;
      // A layout that is longer than the least total by no more than the slack has no line that is longer by more.
      const bool all = HasAll();
      const double cap = all ? limit : std::min(limit, (least_ + slack) * (1 - kRounding));
      Combination combination(searches_, compatible_, budget_);
      const bool finished = combination.FindShortest(cap, options_.max_count + 1);
      TakeBest(combination, finished, result);
      if (!finished) return false;
      result.complete_below = more_ ? result.layouts.back().total : cap;
      if (!more_ && !all && cap < limit) continue;
      if (options_.count_all) result.count = combination.Count(limit);
      return !options_.count_all || result.count.has_value();
    }
  }

  bool ExtendLines(double slack) {
    for (std::size_t i = 0; i < searches_.size(); ++i) {
      const double length = shortest_[i] + slack;
      while (searches_[i].next_bound() <= length && searches_[i].next_bound() < kInfinity) {
        if (!budget_.Spend(searches_[i].Extend(length, std::min<std::int64_t>(budget_.left(), 1000)))) return false;
      }
    }
    return true;
  }

  bool HasAll() const {
    return std::all_of(searches_.begin(), searches_.end(),
                       [](const RouteSearch& search) { return search.next_bound() == kInfinity; });
  }

  void TakeBest(Combination& combination, bool finished, LayoutsResult& result) {
    auto choices = combination.Take();
    // A round that was cut short may have found less than the one before.
    if (!finished && choices.size() < result.layouts.size()) return;
    more_ = choices.size() > options_.max_count;
    if (more_) choices.pop_back();
    result.layouts.clear();
    for (const auto& [total, lines] : choices) {
      FoundLayout layout{.total = total};
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const CandidateRoute& line = searches_[i].candidates()[lines[i]];
        layout.routes.push_back(line.route);
        layout.lengths.push_back(line.length);
      }
      result.layouts.push_back(std::move(layout));
    }
  }

  const FleetGround& ground_;
  const LayoutsOptions& options_;
  FleetSight sight_;
  Compatibility compatible_;
  Budget budget_;
  std::vector<RouteSearch> searches_;
  std::vector<double> shortest_;  ///< The shortest line of each robot, metres.
  double straight_ = 0;           ///< All straight ways, metres.
  double least_ = 0;              ///< All shortest lines, metres.
  bool more_ = false;             ///< Whether there are more layouts than were asked for.
};

}  // namespace

LayoutsResult FindLayouts(const FleetGround& ground, const LayoutsOptions& options) {
  return LayoutsSearch(ground, options).Run();
}

}  // namespace tautline
