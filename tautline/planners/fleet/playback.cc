#include "tautline/planners/fleet/playback.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/moving.h"
#include "tautline/homotopy/rays.h"
#include "tautline/homotopy/string_loop.h"
#include "tautline/homotopy/taut_strings.h"
#include "tautline/planners/fleet/passing_order.h"
#include "tautline/planners/fleet/track_crossings.h"
#include "tautline/planners/fleet/tracks.h"

namespace tautline {
namespace {

/// Shares of the size of the fleet's ground. Rounding is far below the first.
constexpr double kSamePlace = 1e-11;
constexpr double kAtEvent = 1e-9;
/// How far a robot keeps off a crossing while pictures are taken and cables measured.
constexpr double kOffCrossing = 1e-7;
/// Share of the travel time by which moments are one.
constexpr double kSameMoment = 1e-9;
/// The second witness: a robot on its base stands this far beside it, and loops keep that far off their line.
constexpr double kBesideBase = 1e-12, kLoopGap = 1e-11, kLeastLoopGap = 4e-14;
/// A robot whose target is a corner stops at this share of its last stretch before it.
constexpr double kBeforeCorner = 1e-7;
/// The watcher is asked once in so many steps.
constexpr std::size_t kStepsPerLook = 256;

/// A place of a polyline by the lengths that belong to its points.
Point PlaceAt(const Track& track, double along) {
  const auto next = std::upper_bound(track.along.begin(), track.along.end(), along);
  if (next == track.along.begin()) return track.points.front();
  if (next == track.along.end()) return track.points.back();
  const auto k = static_cast<std::size_t>(next - track.along.begin()) - 1;
  return Lerp(track.points[k], track.points[k + 1], (along - track.along[k]) / (track.along[k + 1] - track.along[k]));
}

/// The pins of a fleet: the bases, the corners that are at no base, and the robots.
struct FleetPins {
  explicit FleetPins(const FleetGround& ground) : robots(ground.size()) {
    std::map<Point, FleetNodeId> taken;
    const auto add = [&](FleetNodeId node) {
      points.push_back(ground.point(node));
      nodes.push_back(node);
    };
    for (std::size_t i = 0; i < robots; ++i) taken.try_emplace(ground.point(ground.start(RobotId(i))), i);
    for (std::size_t i = 0; i < robots; ++i) add(ground.start(RobotId(i)));
    std::map<Point, std::size_t> target_of;
    for (std::size_t i = 0; i < robots; ++i) target_of.try_emplace(ground.point(ground.target(RobotId(i))), i);
    at_corner.assign(robots, false);
    for (std::size_t k = 2 * robots; k < ground.node_count(); ++k) {
      const Point p = ground.point(FleetNodeId(k));
      if (!taken.try_emplace(p, k).second) continue;
      const auto target = target_of.find(p);
      add(target == target_of.end() ? FleetNodeId(k) : ground.target(RobotId(target->second)));
      if (target != target_of.end()) at_corner[target->second] = true;
    }
    first_robot = points.size();
    for (std::size_t i = 0; i < robots; ++i) {
      points.push_back(points[i]);
      nodes.push_back(ground.target(RobotId(i)));
    }
  }
  PinId robot(RobotId id) const { return PinId(first_robot + id.index()); }

  std::size_t robots, first_robot = 0;
  std::vector<Point> points;
  std::vector<FleetNodeId> nodes;  ///< By PinId: that of the target for a robot, and for a corner that is one.
  std::vector<bool> at_corner;     ///< By RobotId: whether its target is at a corner.
};

/// Whether p may lie in the closed triangle abc; never no where it does. Exact.
bool MayBeWithin(Point a, Point b, Point c, Point p) {
  const int ab = Orientation(a, b, p), bc = Orientation(b, c, p), ca = Orientation(c, a, p);
  return std::min({ab, bc, ca}) >= 0 || std::max({ab, bc, ca}) <= 0;
}

/// Whether two closed segments meet. Exact.
bool Meet(Point a, Point b, Point c, Point d) {
  return CrossProperly(a, b, c, d) || OnSegment(a, b, c) || OnSegment(a, b, d) || OnSegment(c, d, a) ||
         OnSegment(c, d, b);
}

/// The second witness: the words of loops around the cables, carried by the motion. Where something is so near to a
/// base or to a cable line that standing beside the base, or keeping a gap, would decide, it is lost and says nothing.
class Witness {
 public:
  Witness(const FleetPins& pins, double size) : pins_(pins), size_(size), waits_(pins.robots, true) {
    std::vector<Point> punctures = pins.points;
    // The direction is one that nothing else has.
    const Point beside = kBesideBase * size * Point{0.797, 0.604};
    for (std::size_t k = pins.first_robot; k < punctures.size(); ++k) punctures[k] = punctures[k] + beside;
    for (std::size_t i = 0; i < pins.robots; ++i) {
      for (std::size_t k = 0; k < pins.first_robot; ++k) {
        lost_ = lost_ || (k != i && Distance(pins.points[i], pins.points[k]) < 2 * kBesideBase * size);
      }
    }
    names_.reserve(punctures.size());
    for (std::size_t k = 0; k < punctures.size(); ++k) names_.push_back("p" + std::to_string(k));
    const Rays rays(punctures, names_);
    for (std::size_t i = 0; i < pins.robots; ++i) {
      const Polyline line{punctures[i], punctures[pins.first_robot + i]};
      words_.push_back(rays.WordOf(LoopAround(line, std::vector<Side>(2), 0.1 * kBesideBase * size)));
    }
    const Box box = BoundingBox(punctures);
    // Loops need no end; one that no ray comes to.
    moving_.emplace(std::move(punctures), std::vector<Point>{box.low - Point{size, size}});
  }

  void Move(PinId pin, Point to) {
    lost_ = lost_ || IsTooNear(pin.index(), to) || !moving_->Move(ObstacleId(pin.index()), to).has_value();
    waits_[pin.index() - pins_.first_robot] = false;
  }

  /// Whether the cables that may be compared are of the classes of their cable lines.
  std::optional<bool> Compare(const FleetGround& ground, const FleetLayout& layout) const {
    if (lost_) return std::nullopt;
    const Rays rays(moving_->punctures(), names_);
    const std::vector<Polyline> lines = SideBySide(ground, layout);
    bool agree = true;
    for (std::size_t i = 0; i < layout.size(); ++i) {
      const Route& route = layout[i];
      // A cable line straight over an end of another may be on either side of it: it names no word.
      if (std::any_of(route.begin() + 1, route.end() - 1, [](const RouteStep& s) { return s.side == Side::kNone; })) {
        continue;
      }
      const auto carried = moving_->Carry(words_[i], 0, 0);
      if (!carried) return std::nullopt;
      const auto gap = GapAround(i, lines[i]);
      if (!gap) return std::nullopt;
      const Word meant = rays.WordOf(LoopAround(lines[i], std::vector<Side>(lines[i].size()), *gap));
      agree = agree && RingWord(meant) == RingWord(*carried);
    }
    return agree;
  }

 private:
  /// Whether a robot's way, or that of one that waits, would lead past something on another side if the one that waits
  /// stood on its base rather than beside it.
  bool IsTooNear(std::size_t moved, Point to) const {
    const auto places = moving_->punctures();
    for (std::size_t i = 0; i < pins_.robots; ++i) {
      const std::size_t robot = pins_.first_robot + i;
      if (!waits_[i]) continue;
      if (robot != moved && Meet(places[moved], to, places[i], places[robot])) return true;
      for (std::size_t k = 0; robot == moved && k < places.size(); ++k) {
        if (k != i && k != robot && MayBeWithin(places[i], places[robot], to, places[k])) return true;
      }
    }
    return false;
  }

  /// How far the loop around a cable line may keep off it without holding anything else; nothing where rounding would
  /// decide.
  std::optional<double> GapAround(std::size_t cable, const Polyline& line) const {
    const auto places = moving_->punctures();
    double gap = kLoopGap * size_;
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (std::size_t s = 1; s < line.size(); ++s) {
        const bool is_end = (k == cable && s == 1) || (k == pins_.first_robot + cable && s + 1 == line.size());
        if (!is_end) gap = std::min(gap, 0.25 * DistanceToSegment(places[k], line[s - 1], line[s]));
      }
    }
    return gap >= kLeastLoopGap * size_ ? std::optional(gap) : std::nullopt;
  }

  const FleetPins& pins_;
  double size_;
  std::vector<std::string> names_;
  std::vector<Word> words_;
  std::optional<MovingPunctures> moving_;
  std::vector<bool> waits_;  ///< By RobotId: whether it stands beside its base.
  bool lost_ = false;
};

/// Where robots come to, and what they go around.
std::vector<Point> NodesOf(const FleetGround& ground) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < ground.node_count(); ++i) points.push_back(ground.point(FleetNodeId(i)));
  return points;
}

/// The robots on their tracks, and their cables.
class Stage {
 public:
  Stage(const FleetGround& ground, const std::vector<RobotSchedule>& schedule, bool with_words)
      : ground_(ground),
        schedule_(schedule),
        pins_(ground),
        size_(SizeOfGround(ground)),
        strings_(pins_.points, NodesOf(ground)) {
    for (std::size_t i = 0; i < ground.size(); ++i) strings_.Tie(PinId(i), pins_.robot(RobotId(i)));
    std::vector<Route> routes;
    for (const RobotSchedule& robot : schedule) routes.push_back(robot.path.route);
    lines_ = SideBySide(ground, routes);
    tracks_.reserve(lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      Polyline& line = lines_[i];
      if (pins_.at_corner[i]) line.back() = Lerp(line.back(), line[line.size() - 2], kBeforeCorner);
      tracks_.push_back({line, schedule[i].path.along});
      travel_time_ = std::max(travel_time_, schedule[i].events.back().arrival);
    }
    along_.assign(ground.size(), 0);
    if (with_words) witness_.emplace(pins_, size_);
  }

  const std::vector<Track>& tracks() const { return tracks_; }
  double travel_time() const { return travel_time_; }
  Closeness closeness() const {
    return {.moment = kSameMoment * travel_time_, .place = kSamePlace * size_, .event = kAtEvent * size_};
  }
  double off_crossing() const { return kOffCrossing * size_; }
  double along(RobotId robot) const { return along_[robot.index()]; }
  const std::optional<Witness>& witness() const { return witness_; }

  /// Leads a robot along its track, forwards or back, at a time.
  std::optional<PlaybackCollision> Lead(RobotId robot, double to, double t) {
    double& at = along_[robot.index()];
    const Track& track = tracks_[robot.index()];
    const double from = at;
    if (from == to) return std::nullopt;
    at = to;
    const std::size_t count = track.along.size();
    for (std::size_t step = 0; step < count; ++step) {
      const std::size_t k = from < to ? step : count - 1 - step;
      if (track.along[k] <= std::min(from, to) || track.along[k] >= std::max(from, to)) continue;
      if (auto collision = Move(robot, track.points[k], t)) return collision;
    }
    return Move(robot, PlaceAt(track, to), t);
  }

  void Measure(double t, std::vector<LongestTether>& longest) const {
    for (std::size_t i = 0; i < longest.size(); ++i) {
      const double length = strings_.length(StringId(i));
      if (length > longest[i].length) longest[i] = {length, t};
    }
  }

  PlaybackFrame Frame(double t) const {
    PlaybackFrame frame{t, {}, {}};
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      frame.robots.push_back(strings_.point(pins_.robot(RobotId(i))));
      frame.cables.push_back(strings_.points(StringId(i)));
    }
    return frame;
  }

  /// A cable as a route; pins that it touches without a bend included.
  Route RouteOf(RobotId robot) const {
    Route route;
    for (const StringBend& bend : strings_.bends(StringId(robot.index()))) {
      const RouteStep step{pins_.nodes[bend.pin.index()], bend.side};
      // A robot beside a corner is at its target.
      if (!route.empty() && route.back().node == step.node) {
        if (step.side == Side::kNone) route.back() = step;
        continue;
      }
      route.push_back(step);
    }
    return route;
  }

 private:
  std::optional<PlaybackCollision> Move(RobotId robot, Point to, double t) {
    const PinId pin = pins_.robot(robot);
    if (const auto moved = strings_.Move(pin, to); !moved) {
      const RobotId met = ground_.robot_at(pins_.nodes[moved.error().met.index()]);
      return PlaybackCollision{robot, met.valid() ? met : robot, strings_.point(moved.error().met), t};
    }
    if (witness_) witness_->Move(pin, to);
    return std::nullopt;
  }

  const FleetGround& ground_;
  const std::vector<RobotSchedule>& schedule_;
  FleetPins pins_;
  double size_;
  TautStrings strings_;
  std::vector<Polyline> lines_;
  std::vector<Track> tracks_;
  std::vector<double> along_;  ///< By RobotId: where it is, metres.
  double travel_time_ = 0;
  std::optional<Witness> witness_;
};

/// The moments at which cables are measured: those at which some robot starts, stops, turns or goes on. In between all
/// robots move straight and with constant speed. Then a taut length is convex in time: it is so while the pins that
/// hold the cable stay, being a sum of distances between points that move uniformly; and where it meets a pin or loses
/// one, its rate does not jump, since it is straight there. So it is longest at one of these moments.
std::vector<double> MomentsOf(const std::vector<RobotSchedule>& schedule, double close, std::size_t measured) {
  std::vector<double> moments;
  for (const RobotSchedule& robot : schedule) {
    for (const FleetEvent& event : robot.events) {
      moments.push_back(event.arrival);
      moments.push_back(event.departure);
    }
  }
  std::sort(moments.begin(), moments.end());
  moments.erase(std::unique(moments.begin(), moments.end(), [close](double a, double b) { return b - a <= close; }),
                moments.end());
  const std::size_t most = std::max<std::size_t>(measured / schedule.size(), 2);
  if (moments.size() <= most) return moments;
  std::vector<double> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(moments[k * (moments.size() - 1) / (most - 1)]);
  return some;
}

/// Leads all robots past all their meetings, in order. Between two of its meetings a robot may be anywhere: its track
/// meets no other there, so that what is led in another order than in time comes to the same classes.
class Player {
 public:
  Player(Stage& stage, const std::vector<RobotSchedule>& schedule, std::vector<Meeting> meetings)
      : stage_(stage),
        schedule_(schedule),
        meetings_(std::move(meetings)),
        ahead_(schedule.size()),

        done_(schedule.size(), 0) {
    for (const Meeting& meeting : meetings_) ahead_[meeting.robot.index()].push_back(&meeting);
  }

  /// Leads robots past the meetings before a time.
  std::optional<PlaybackCollision> PassUntil(double t, const Watcher& watch) {
    for (; next_ < meetings_.size() && meetings_[next_].t < t; ++next_) {
      if (watch && next_ % kStepsPerLook == 0 &&
          !watch("playing", static_cast<double>(next_) / static_cast<double>(meetings_.size()))) {
        throw Stopped();
      }
      const Meeting& meeting = meetings_[next_];
      const std::size_t r = meeting.robot.index();
      ++done_[r];
      const double end = stage_.tracks()[r].along.back();
      const double to = done_[r] < ahead_[r].size() ? 0.5 * (meeting.last + ahead_[r][done_[r]]->along) : end;
      if (auto collision = stage_.Lead(meeting.robot, to, meeting.t)) return collision;
    }
    return std::nullopt;
  }

  /// Leads every robot to where it is at a time, a hair's breadth off the meetings that it has passed and has not.
  std::optional<PlaybackCollision> Place(double t) {
    for (std::size_t r = 0; r < schedule_.size(); ++r) {
      const bool has_next = done_[r] < ahead_[r].size();
      const double end = stage_.tracks()[r].along.back();
      const double low = done_[r] > 0 ? ahead_[r][done_[r] - 1]->last : 0;
      const double high = has_next ? ahead_[r][done_[r]]->along : end;
      const double off = std::min(stage_.off_crossing(), (high - low) / 3);
      double to = std::clamp(AlongAt(schedule_[r], t), low, high);
      if (done_[r] > 0 && low < end) to = std::max(to, low + off);
      if (has_next) to = std::min(to, high - off);
      if (auto collision = stage_.Lead(RobotId(r), to, t)) return collision;
    }
    return std::nullopt;
  }

 private:
  Stage& stage_;
  const std::vector<RobotSchedule>& schedule_;
  std::vector<Meeting> meetings_;
  std::vector<std::vector<const Meeting*>> ahead_;  ///< By RobotId, in order.
  std::vector<std::size_t> done_;                   ///< By RobotId: how many of its meetings it has passed.
  std::size_t next_ = 0;
};

/// The bends of a cable; where it turns straight back, too.
Route HeldBends(const FleetGround& ground, const Route& route) {
  Route bends;
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (i > 0 && i + 1 < route.size()) {
      const Point before = ground.point(route[i - 1].node), at = ground.point(route[i].node);
      const Point after = ground.point(route[i + 1].node);
      if (Orientation(before, at, after) == 0 && Dot(at - before, after - at) > 0) continue;
    }
    bends.push_back(route[i]);
  }
  return bends;
}

std::vector<BrokenOrder> FindBroken(const std::vector<RobotSchedule>& schedule, const std::vector<Passing>& passings,
                                    const Closeness& close) {
  std::vector<BrokenOrder> broken;
  for (const Passing& order : passings) {
    const double first = PassingTime(schedule[order.first.index()], order.first_along, close);
    const double second = PassingTime(schedule[order.second.index()], order.second_along, close);
    if (first > second + close.moment) broken.push_back({order.first, order.second, order.at});
  }
  return broken;
}

/// Plays from beginning to end.
class Performance {
 public:
  Performance(Stage& stage, Player& player, const PlaybackOptions& options)
      : stage_(stage), player_(player), options_(options) {}

  std::optional<PlaybackCollision> Run(const std::vector<RobotSchedule>& schedule, Playback& playback) {
    const double close = stage_.closeness().moment, end = stage_.travel_time();
    std::vector<std::pair<double, bool>> moments;  // And whether a picture is taken.
    for (const double t : MomentsOf(schedule, close, options_.measured)) moments.emplace_back(t, false);
    for (int k = 0; k + 1 < options_.frames; ++k) {
      moments.emplace_back(end * k / (options_.frames - 1), true);
    }
    std::sort(moments.begin(), moments.end());
    playback.longest.resize(schedule.size());
    for (const auto& [t, is_frame] : moments) {
      if (auto collision = player_.PassUntil(t - close, options_.watch)) return collision;
      if (auto collision = player_.Place(t)) return collision;
      stage_.Measure(t, playback.longest);
      if (is_frame) playback.frames.push_back(stage_.Frame(t));
    }
    if (auto collision = player_.PassUntil(2 * end + 1, options_.watch)) return collision;
    if (auto collision = player_.Place(end)) return collision;
    stage_.Measure(end, playback.longest);
    if (options_.frames > 0) playback.frames.push_back(stage_.Frame(end));
    return std::nullopt;
  }

 private:
  Stage& stage_;
  Player& player_;
  const PlaybackOptions& options_;
};

}  // namespace

tl::expected<Playback, PlaybackCollision> Play(const FleetGround& ground, const FleetLayout& layout,
                                               const std::vector<RobotSchedule>& schedule,
                                               const std::vector<Passing>& passings, const PlaybackOptions& options) {
  TAUTLINE_CHECK(schedule.size() == ground.size() && (layout.empty() || layout.size() == ground.size()));
  Stage stage(ground, schedule, !layout.empty() && ground.size() <= options.words_up_to);
  auto meetings = SortMeetings(stage.tracks(), schedule, passings, stage.closeness());
  if (!meetings) return tl::unexpected(meetings.error());
  Player player(stage, schedule, *std::move(meetings));
  Playback playback;
  playback.broken = FindBroken(schedule, passings, stage.closeness());
  if (auto collision = Performance(stage, player, options).Run(schedule, playback)) return tl::unexpected(*collision);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    playback.final_routes.emplace_back(stage.RouteOf(RobotId(i)));
    if (layout.empty()) continue;
    if (HeldBends(ground, playback.final_routes[i]) != HeldBends(ground, layout[i])) {
      playback.differing.emplace_back(i);
    }
  }
  if (stage.witness()) playback.words_agree = stage.witness()->Compare(ground, layout);
  return playback;
}

}  // namespace tautline
