#include "tautline/planners/cable_workspace/move.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// A moment of the grid that is nearer to an event than this share of the duration is left out beside it.
constexpr double kSameMoment = 1e-9;

Expected<void> CheckPositive(double value, const std::string& what) {
  if (std::isfinite(value) && value > 0) return {};
  return InvalidInput(what + " must be a positive number");
}

Polyline PointsOf(const TautCurve& curve) {
  Polyline points;
  for (const TautPoint& p : curve.points) points.push_back(p.point);
  return points;
}

/// Follows all cables along the path: by piece, by winch.
std::vector<std::vector<std::vector<CableSection>>> FollowPath(const WorkspaceRegion& region, const Walk& start_way,
                                                               const Polyline& path) {
  const TautSpace& space = region.ground().space();
  const std::size_t pieces = std::max<std::size_t>(path.size(), 2) - 1;
  std::vector<std::vector<std::vector<CableSection>>> sections(pieces);
  for (std::size_t i = 0; i < region.anchors().size(); ++i) {
    std::optional<Walk> walk = region.CableTo(i, start_way);
    Polyline before = PointsOf(PullTaut(space.mesh(), *walk));
    for (std::size_t k = 0; k < pieces; ++k) {
      if (path.size() > 1) TAUTLINE_CHECK(!space.Follow({&path[k + 1], 1}, walk));
      Polyline after = PointsOf(PullTaut(space.mesh(), *walk));
      sections[k].push_back(CableSections({before, after, region.anchors()[i].stub_length}));
      before = std::move(after);
    }
  }
  return sections;
}

double LimitOf(const MoveOptions& options, std::size_t anchor) {
  if (options.winch_limits.empty()) return std::numeric_limits<double>::infinity();
  return options.winch_limits.size() == 1 ? options.winch_limits[0] : options.winch_limits[anchor];
}

/// The greatest speed at which no winch exceeds its limit. Slopes grow along a section, so they are steepest at its
/// ends.
double CruiseSpeed(const MoveOptions& options, const std::vector<std::vector<CableSection>>& cables) {
  double cruise = options.speed;
  for (std::size_t i = 0; i < cables.size(); ++i) {
    double steepest = 0;
    for (const CableSection& section : cables[i]) {
      steepest =
          std::max({steepest, std::fabs(section.SlopeAt(section.begin)), std::fabs(section.SlopeAt(section.end))});
    }
    if (steepest * cruise > LimitOf(options, i)) cruise = LimitOf(options, i) / steepest;
  }
  return cruise;
}

void AddPieces(const Polyline& path, const MoveOptions& options,
               std::vector<std::vector<std::vector<CableSection>>> sections, Move& move) {
  double length = 0;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    const Point from = path[k], to = path[std::min(k + 1, path.size() - 1)];
    const SpeedProfile profile(Distance(from, to), CruiseSpeed(options, sections[k]), options.acceleration);
    move.pieces.push_back({.from = from,
                           .to = to,
                           .begin_m = length,
                           .begin_s = move.duration_s,
                           .profile = profile,
                           .cables = std::move(sections[k])});
    length += profile.length_m();
    move.duration_s += profile.duration_s();
  }
}

void AddSwitches(Move& move) {
  for (std::size_t i = 0; i < move.pieces[0].cables.size(); ++i) {
    Point corner = move.pieces[0].cables[i][0].corner;
    for (std::size_t k = 0; k < move.pieces.size(); ++k) {
      for (const CableSection& section : move.pieces[k].cables[i]) {
        if (section.corner == corner) continue;
        move.switches.push_back({.t_s = move.pieces[k].begin_s + move.pieces[k].profile.TimeAt(section.begin),
                                 .anchor = i,
                                 .from = corner,
                                 .to = section.corner,
                                 .piece = k,
                                 .distance_m = section.begin});
        corner = section.corner;
      }
    }
  }
  std::stable_sort(move.switches.begin(), move.switches.end(),
                   [](const CornerSwitch& a, const CornerSwitch& b) { return a.t_s < b.t_s; });
}

const CableSection& SectionAt(const std::vector<CableSection>& sections, double distance) {
  std::size_t i = sections.size() - 1;
  while (i > 0 && sections[i].begin > distance) --i;
  return sections[i];
}

/// A moment of which a sample is to be taken.
struct Moment {
  double t_s;
  std::size_t piece;
  double distance_m;
};

/// The moments at which something changes, by time.
std::vector<Moment> Events(const Move& move) {
  std::vector<Moment> events;
  for (std::size_t k = 0; k < move.pieces.size(); ++k) events.push_back({move.pieces[k].begin_s, k, 0});
  for (const CornerSwitch& s : move.switches) events.push_back({s.t_s, s.piece, s.distance_m});
  for (std::size_t k = 0; k < move.pieces.size(); ++k) {
    // A corner on the way itself: the cable's rate jumps, though its corner stays.
    for (const auto& sections : move.pieces[k].cables) {
      for (std::size_t i = 1; i < sections.size(); ++i) {
        if (sections[i].corner != sections[i - 1].corner) continue;
        events.push_back(
            {move.pieces[k].begin_s + move.pieces[k].profile.TimeAt(sections[i].begin), k, sections[i].begin});
      }
    }
  }
  events.push_back({move.duration_s, move.pieces.size() - 1, move.pieces.back().profile.length_m()});
  std::sort(events.begin(), events.end(), [](const Moment& a, const Moment& b) {
    return std::tie(a.t_s, a.piece, a.distance_m) < std::tie(b.t_s, b.piece, b.distance_m);
  });
  const auto same = [](const Moment& a, const Moment& b) { return a.t_s == b.t_s && a.piece == b.piece; };
  events.erase(std::unique(events.begin(), events.end(), same), events.end());
  return events;
}

MoveSample SampleOf(const Move& move, const Moment& moment) {
  MoveSample sample = SampleAt(move, moment.piece, moment.distance_m);
  sample.t_s = moment.t_s;
  return sample;
}

}  // namespace

Expected<void> CheckMoveOptions(const MoveOptions& options, std::size_t anchors) {
  if (auto checked = CheckPositive(options.speed, "the speed"); !checked) return checked;
  if (options.acceleration) {
    if (auto checked = CheckPositive(*options.acceleration, "the acceleration"); !checked) return checked;
  }
  for (const double limit : options.winch_limits) {
    if (auto checked = CheckPositive(limit, "the limit of a winch"); !checked) return checked;
  }
  const std::size_t given = options.winch_limits.size();
  if (given <= 1 || given == anchors) return {};
  return InvalidInput(std::to_string(given) + " limits for " + std::to_string(anchors) +
                      " winches: give one for all, or one for each in the order of the anchors");
}

tl::expected<Move, OutsideFault> PlanMove(const WorkspaceRegion& region, Point start, Point goal,
                                          const MoveOptions& options) {
  TAUTLINE_CHECK(CheckMoveOptions(options, region.anchors().size()));
  const auto outside = [&](WorkspaceObstruction obstruction, const std::string& what, Point at) {
    return tl::unexpected(OutsideFault{obstruction, {}, ExplainOutside(region.boundary(), what, at)});
  };
  const std::vector<Walk> start_ways = region.WaysTo(start), goal_ways = region.WaysTo(goal);
  if (start_ways.empty()) return outside(WorkspaceObstruction::kStartOutside, "the start", start);
  if (goal_ways.empty()) return outside(WorkspaceObstruction::kGoalOutside, "the goal", goal);
  RegionPath shortest = ShortestPath(region, start_ways, goal_ways);
  Move move{.path = std::move(shortest.path)};
  AddPieces(move.path.points, options, FollowPath(region, start_ways[shortest.from], move.path.points), move);
  AddSwitches(move);
  move.outside = FirstOutside(region, move.path.points);
  return move;
}

MoveSample SampleAt(const Move& move, std::size_t piece, double distance_m) {
  const MovePiece& at = move.pieces[piece];
  const double length = at.profile.length_m(), distance = std::clamp(distance_m, 0.0, length);
  MoveSample sample{.t_s = at.begin_s + at.profile.TimeAt(distance), .speed = at.profile.AtDistance(distance).speed};
  sample.robot = distance >= length ? at.to : Lerp(at.from, at.to, distance / length);
  for (const auto& sections : at.cables) {
    const CableSection& section = SectionAt(sections, distance);
    sample.lengths.push_back(section.LengthAt(distance));
    sample.rates.push_back(section.SlopeAt(distance) * sample.speed);
    sample.corners.push_back(section.corner);
  }
  return sample;
}

std::vector<Polyline> CablesAt(const Move& move, std::size_t piece, double distance_m) {
  const Point robot = SampleAt(move, piece, distance_m).robot;
  std::vector<Polyline> cables;
  for (const auto& sections : move.pieces[piece].cables) {
    cables.push_back(SectionAt(sections, distance_m).via);
    if (cables.back().back() != robot) cables.back().push_back(robot);
  }
  return cables;
}

std::vector<MoveSample> SampleMove(const Move& move, double dt_s) {
  TAUTLINE_CHECK(dt_s > 0);
  const std::vector<Moment> events = Events(move);
  std::vector<MoveSample> samples;
  std::size_t piece = 0;
  std::int64_t step = 0;
  for (const Moment& event : events) {
    for (; static_cast<double>(step) * dt_s < event.t_s + kSameMoment * move.duration_s; ++step) {
      const double t = static_cast<double>(step) * dt_s;
      const bool beside = t > event.t_s - kSameMoment * move.duration_s ||
                          (!samples.empty() && t < samples.back().t_s + kSameMoment * move.duration_s);
      if (beside) continue;
      while (piece + 1 < move.pieces.size() && move.pieces[piece + 1].begin_s <= t) ++piece;
      const MovePiece& at = move.pieces[piece];
      samples.push_back(SampleOf(move, {t, piece, at.profile.At(t - at.begin_s).distance}));
    }
    // The piece that begins replaces the end of the one before.
    if (!samples.empty() && samples.back().t_s == event.t_s) samples.pop_back();
    samples.push_back(SampleOf(move, event));
  }
  return samples;
}

}  // namespace tautline
