#include "tautline/planners/contact_free/plan_contact_free.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tautline/homotopy/classes.h"
#include "tautline/planners/contact_free/refine_path.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// The cells in which distances to the goal are asked once, and of the grid of the map, metres.
constexpr double kGuideCell = 0.1, kMapCell = 0.1;
/// The space that gives distances grows by this share of the robot's radius: corners are rounded outwards by up to a
/// hundredth, and wherever the robot may stand must be inside.
constexpr double kGrowth = 0.98;
/// A motion takes at most so many times as long as the shortest way, and so many primitives more.
constexpr double kDetour = 2.2;
constexpr int kSpareLayers = 15;
/// So many motions of a search are refined: those that cost least when they are tracked as they are.
constexpr std::size_t kRefined = 3;
/// A motion that tracks its path is worth this many contacts more than one that is told every velocity.
constexpr double kWorthTracking = 1;
/// One search of several.
struct Pass {
  int width = 0;             ///< States that it follows.
  bool keeps_margin = true;  ///< Else contacts are all that counts: where the margin is not to be had.
  int headings = 8;          ///< Into which a crowded place is divided: more help to turn, fewer to keep away.
  bool is_last = false;      ///< It is to shorten what is found already.
};
/// Coarse to fine; the first that finds a motion without contacts is the last.
constexpr Pass kPasses[] = {{60},  {60, true, 1},   {60, false, 1}, {240},           {240, true, 1}, {240, false, 1},
                            {720}, {720, false, 1}, {2000},         {2000, false, 1}};

/// Where the first motion without contacts is longer than the shortest way by this factor, these searches follow.
constexpr double kLong = 1.3;
constexpr Pass kLastPasses[] = {{60, true, 1, true}};

/// A motion to the goal and the path that belongs to it.
struct Candidate {
  Polyline path;
  DrivenMotion motion;
  double cost = 0;

  /// What the contacts of the motion count, by the weights of the paper.
  double touching() const { return motion.costs.cable_obstacle_steps + 0.5 * motion.costs.cable_robot_steps; }
  /// Contacts come first.
  bool IsBetterThan(const Candidate& other) const {
    return std::pair(touching(), cost) < std::pair(other.touching(), other.cost);
  }
  int contacts() const { return motion.costs.cable_obstacle_steps + motion.costs.cable_robot_steps; }
};

/// For a part of the work that does not tell how far it is.
KeepGoing KeepGoingOf(const Watcher& watch, double share) {
  if (!watch) return {};
  return [watch, share] { return watch("search", share); };
}

std::string TextOf(Point p) { return "(" + ShortNumber(p.x) + ", " + ShortNumber(p.y) + ")"; }

double CostOf(const MotionCosts& costs, const SearchCosts& weights) {
  return costs.penalty + weights.per_metre * costs.length_m;
}

/// What all searches for one scene share.
class Planning {
 public:
  Planning(const Scene& scene, const ContactFreeOptions& options, TetherTask task, FreeSpace free, FreeSpace grown)
      : scene_(scene),
        options_(options),
        task_(std::move(task)),
        laid_(task_.laid),
        map_(free, kMapCell),
        space_(std::move(free)),
        room_(std::move(grown)) {
    result_.env = options_.env;
  }

  Expected<ContactFreeResult> Run() {
    if (!IsRefused()) {
      // A robot on its base looks where it will go.
      task_.waypoints = way_;
      auto env = TetherEnv::Create(map_, task_, options_.env);
      if (!env) return tl::unexpected(env.error());
      Search(*env);
    }
    return std::move(result_);
  }

 private:
  void Refuse(std::string reason, std::string explanation) {
    result_.reason = std::move(reason);
    result_.explanation = std::move(explanation);
  }

  /// Whether the question has no answer, for reasons that need no search.
  bool IsRefused() {
    const double radius = options_.env.robot_radius_m, length = scene_.tether->length;
    const std::string disc = "the disc of " + Metres(radius) + " around ";
    if (map_.DiscTouches(laid_.back(), radius)) {
      Refuse("start_blocked", disc + "the robot at " + TextOf(laid_.back()) + " touches an obstacle or a wall");
      return true;
    }
    const Point goal_at = *scene_.goal;
    goal_ = room_.Locate(goal_at);
    if (map_.DiscTouches(goal_at, radius) || !goal_) {
      Refuse("goal_blocked", disc + "the goal at " + TextOf(goal_at) + " touches an obstacle or a wall");
      return true;
    }
    if (const Shortened laid = Shorten(space_, laid_); laid.departure) {
      Refuse("laid_cable_blocked", "the laid cable runs into an obstacle or a wall at " + TextOf(laid.departure->at));
      return true;
    }
    // It ends at the robot's tail, a radius before its centre.
    if (Length(laid_) - radius > length * (1 + kLengthTolerance)) {
      Refuse("laid_cable_too_long", "the laid cable takes " + Metres(Length(laid_) - radius) +
                                        " as far as the robot's tail, and there are " + Metres(length) + " of it");
      return true;
    }
    guide_.emplace(room_, *goal_, kGuideCell);
    way_ = guide_->ShortestPath(laid_.back());
    if (way_.empty()) {
      Refuse("goal_unreachable",
             "no way is wide enough for " + disc + "the robot from " + TextOf(laid_.back()) + " to " + TextOf(goal_at));
      return true;
    }
    return IsTetherTooShort();
  }

  bool IsTetherTooShort() {
    const auto base = space_.Locate(laid_.front()), goal = space_.Locate(*scene_.goal);
    const auto shortest = base && goal ? FindShortestOnward(space_, Walk(*base), *goal) : std::nullopt;
    if (!shortest) return false;
    // The robot need not come nearer than this, and its tail is behind it.
    const double spared = options_.env.goal_radius_m + options_.env.robot_radius_m;
    if (shortest->length - spared <= scene_.tether->length * (1 + kLengthTolerance)) return false;
    Refuse("tether_too_short", "the shortest tether to the goal takes " + Metres(shortest->length) +
                                   ", and the cable has " + Metres(scene_.tether->length));
    return true;
  }

  void Search(const TetherEnv& env) {
    const double speed = env.options().speed_m_per_s;
    result_.shortest_m = std::max(0.0, Length(way_) - env.options().goal_radius_m);
    result_.bound =
        result_.shortest_m * (options_.costs.per_metre - env.options().reward.time / (speed * env.options().dt_s));
    PrepareMargin();
    for (const Pass& pass : kPasses) {
      if (result_.expansions >= options_.last_search || IsGoodEnough()) break;
      if (options_.watch && !options_.watch("search", Share())) break;
      SearchWith(env, pass);
    }
    if (IsGoodEnough()) ShortenBest(env);
    Choose();
    if (!found_) {
      result_.status = ContactFreeStatus::kBudgetExceeded;
      Refuse("budget_exceeded", "no motion was found among " + std::to_string(result_.expansions) +
                                    " states; one may exist: give a larger --budget");
      return;
    }
    result_.status = ContactFreeStatus::kSolved;
    Polyline way = laid_;
    for (const RobotPose& pose : result_.motion.poses) way.push_back(pose.at);
    result_.tether = Shorten(space_, way).path;
  }

  /// Of the states that may be expanded: so many are.
  double Share() const {
    const auto most = static_cast<double>(std::min(options_.last_search, options_.budget));
    return std::min(1.0, static_cast<double>(result_.expansions) / most);
  }

  /// A motion of tracking, which touches nothing.
  bool IsGoodEnough() const { return tracked_ && tracked_->contacts() == 0; }

  /// The tracked motion, unless driving without a path to track touches less.
  void Choose() {
    if (!tracked_ && !direct_) return;
    found_ = true;
    Candidate& best =
        tracked_ && !(direct_ && direct_->touching() + kWorthTracking < tracked_->touching()) ? *tracked_ : *direct_;
    result_.path = std::move(best.path);
    result_.motion = std::move(best.motion);
    result_.cost = best.cost;
  }

  /// One more search where the way is long, and a finer look at the best path.
  void ShortenBest(const TetherEnv& env) {
    for (const Pass& pass : kLastPasses) {
      if (tracked_->motion.costs.length_m > kLong * result_.shortest_m) SearchWith(env, pass);
    }
    Refine(env, *(wary_ ? &*wary_ : &env), tracked_->path, {0.4, 0.2, 0.1, 0.05}, 2);
  }

  void SearchWith(const TetherEnv& env, const Pass& pass) {
    const std::int64_t left = options_.budget - result_.expansions;
    const double margin_m = pass.keeps_margin ? options_.margin_m : 0;
    if (left <= 0 || (margin_m > 0 && !wary_)) return;
    const TetherEnv& driven_in = margin_m > 0 ? *wary_ : env;
    const SearchProblem problem{.env = &driven_in,
                                .guide = &*guide_,
                                .rays = &space_.rays(),
                                .costs = {options_.costs.per_metre, margin_m > 0 ? options_.costs.cable_margin_m : 0},
                                .budget = left,
                                .keep_going = KeepGoingOf(options_.watch, Share())};
    SearchGrain grain{.width = pass.width, .crowd = pass.headings == 1 ? 12 : 6, .crowd_headings = pass.headings};
    const double primitive_m = grain.primitive_steps * env.options().dt_s * env.options().speed_m_per_s;
    grain.layers = kSpareLayers + static_cast<int>(std::ceil(kDetour * Length(way_) / primitive_m));
    const SearchOutcome outcome = SearchMotion(problem, grain);
    result_.expansions += outcome.expansions;
    std::vector<std::pair<double, Polyline>> paths;
    for (const std::vector<Velocity>& motion : outcome.motions) {
      DrivenMotion driven = DriveMotion(env, motion);
      const Polyline path = driven.Path();
      const TrackResult track = TrackPath(driven_in, path);
      if (track.success()) paths.emplace_back(options_.costs.per_metre * track.driven_m - track.reward, path);
      Offer(std::move(driven), path, direct_);
    }
    std::stable_sort(paths.begin(), paths.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    if (paths.size() > kRefined) paths.resize(kRefined);
    for (const auto& [cost, path] : paths) {
      if (pass.is_last) {
        Refine(env, driven_in, path, {0.4, 0.2, 0.1, 0.05}, 3);
        continue;
      }
      Refine(env, driven_in, path, {0.4, 0.2}, 1);
      if (IsGoodEnough()) return;
    }
  }

  /// The environment with the margin, where the robot does not stand nearer than that to an obstacle.
  void PrepareMargin() {
    if (options_.margin_m <= 0) return;
    const auto space = BuildFreeSpace(scene_.world, {.clearance = scene_.world.clearance + options_.margin_m});
    if (!space) return;
    wary_map_.emplace(*space, kMapCell);
    if (auto created = TetherEnv::Create(*wary_map_, task_, options_.env)) wary_ = *std::move(created);
  }

  /// Bends a path where the margin counts, and offers what comes of it.
  void Refine(const TetherEnv& env, const TetherEnv& wary, const Polyline& path, std::vector<double> steps_m,
              int rounds) {
    const RefinedPath refined = RefinePath(wary, path,
                                           {.per_metre = options_.costs.per_metre,
                                            .steps_m = std::move(steps_m),
                                            .rounds = rounds,
                                            .keep_going = KeepGoingOf(options_.watch, Share())});
    if (!std::isfinite(refined.cost)) return;
    // Where nothing is grown, the robot does not shrink back from the margin.
    const TrackResult track = TrackPath(env, refined.path);
    Offer(DriveMotion(env, track.commands), refined.path, tracked_);
  }

  /// Keeps the motion if none is better.
  void Offer(DrivenMotion motion, Polyline path, std::optional<Candidate>& best) const {
    const double cost = CostOf(motion.costs, options_.costs);
    if (!motion.at_goal) return;
    Candidate candidate{std::move(path), std::move(motion), cost};
    if (!best || candidate.IsBetterThan(*best)) best = std::move(candidate);
  }

  const Scene& scene_;
  ContactFreeOptions options_;
  TetherTask task_;
  Polyline laid_;
  ContactMap map_;
  TautSpace space_;                     ///< For cables.
  TautSpace room_;                      ///< For the robot's centre.
  std::optional<ContactMap> wary_map_;  ///< Grown by the margin.
  std::optional<TetherEnv> wary_;
  std::optional<Place> goal_;
  std::optional<GoalGuide> guide_;
  Polyline way_;
  ContactFreeResult result_;
  std::optional<Candidate> tracked_;  ///< The best motion of a robot that tracks its path,
  std::optional<Candidate> direct_;   ///< and of one that is told every velocity.
  bool found_ = false;
};

}  // namespace

Expected<ContactFreeResult> PlanContactFree(const Scene& scene, const ContactFreeOptions& options) {
  auto task = TaskOf(scene);
  if (!task) return tl::unexpected(task.error());
  auto free = BuildFreeSpace(scene.world);
  if (!free) return tl::unexpected(free.error());
  ContactFreeOptions with = options;
  with.env = OptionsFor(scene, options.env);
  with.env.reward.use_reference = false;
  with.env.reward.goal = 0;
  const double radius = with.env.robot_radius_m;
  auto grown = BuildFreeSpace(scene.world, {.clearance = scene.world.clearance + kGrowth * radius});
  if (!grown) {
    return ContactFreeResult{.reason = "start_blocked",
                             .explanation = "the robot's disc of " + Metres(radius) + " fits nowhere",
                             .env = with.env};
  }
  return Planning(scene, with, *std::move(task), *std::move(free), *std::move(grown)).Run();
}

}  // namespace tautline
