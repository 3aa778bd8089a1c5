#include "tautline/planners/fleet/path_crossings.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/box_index.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

using PathPair = std::pair<std::int32_t, std::int32_t>;

/// The side of a traveller from `before` over `at` to `after` on which `q` lies, as seen from nearby `at`. Requires
/// that q is in the direction of neither.
Side SideOf(Point before, Point at, Point after, Point q) {
  const int turn = Orientation(before, at, after);
  const bool left_of_first = Orientation(before, at, q) > 0, left_of_second = Orientation(at, after, q) > 0;
  const bool left = turn > 0 ? left_of_first && left_of_second : left_of_first || left_of_second;
  return left ? Side::kLeft : Side::kRight;
}

/// A path with a vertex wherever the other one has one.
struct RefinedPath {
  std::vector<Point> points;
  std::vector<PathSpot> spots;

  bool has_before(std::size_t i) const { return i > 0; }
  bool has_after(std::size_t i) const { return i + 1 < points.size(); }
};

RefinedPath Refine(const RobotPath& path, const RobotPath& other) {
  RefinedPath refined;
  const auto& points = path.points;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto segment = static_cast<std::int32_t>(k);
    refined.points.push_back(points[k]);
    refined.spots.push_back({segment, true, path.along[k]});
    if (k + 1 == points.size()) break;
    const Point p = points[k], q = points[k + 1];
    std::vector<std::pair<double, Point>> between;
    for (const Point at : other.points) {
      if (at != p && at != q && OnSegment(p, q, at)) between.emplace_back(Dot(at - p, q - p), at);
    }
    std::sort(between.begin(), between.end());
    between.erase(std::unique(between.begin(), between.end()), between.end());
    for (const auto& [unused, at] : between) {
      refined.points.push_back(at);
      refined.spots.push_back({segment, false, path.along[k] + Distance(p, at)});
    }
  }
  return refined;
}

/// The stretches and points that two refined paths share, where they have vertices.
class SharedParts {
 public:
  SharedParts(PathPair pair, const RobotPath& a, const RobotPath& b, std::vector<PathContact>& contacts)
      : pair_(pair), a_(Refine(a, b)), b_(Refine(b, a)), contacts_(contacts) {}

  void Find() {
    for (std::size_t p = 0; p < a_.points.size(); ++p) {
      for (std::size_t q = 0; q < b_.points.size(); ++q) {
        if (!Match(p, q)) continue;
        const bool after_forward = Step(p, q, +1, +1), after_against = Step(p, q, +1, -1);
        if (Step(p, q, -1, -1) || Step(p, q, -1, +1)) continue;  // Not where a comes to it.
        Follow(p, q, after_forward ? 1 : after_against ? -1 : 0);
      }
    }
  }

 private:
  bool Match(std::size_t p, std::size_t q) const { return a_.points[p] == b_.points[q]; }

  /// Whether both are at one point after a step as well.
  bool Step(std::size_t p, std::size_t q, int dp, int dq) const {
    if ((dp < 0 && p == 0) || (dq < 0 && q == 0)) return false;
    p += static_cast<std::size_t>(dp);
    q += static_cast<std::size_t>(dq);
    return p < a_.points.size() && q < b_.points.size() && Match(p, q);
  }

  /// Adds the part that starts, for a, at (p, q); `dq` is the direction of b, or 0 for a point.
  void Follow(const std::size_t p, const std::size_t q, int dq) {
    std::size_t p_end = p, q_end = q;
    while (dq != 0 && Step(p_end, q_end, +1, dq)) {
      ++p_end;
      q_end += static_cast<std::size_t>(dq);
    }
    const std::size_t b_in = dq < 0 ? q_end : q, b_out = dq < 0 ? q : q_end;
    PathContact contact{.a = RobotId(pair_.first), .b = RobotId(pair_.second)};
    contact.exact = true;
    contact.against = dq < 0;
    contact.at = b_.points[b_in];
    contact.until = b_.points[b_out];
    contact.of_a = VisitOf(a_, p, p_end, b_, b_in, b_out, dq < 0);
    contact.of_b = VisitOf(b_, b_in, b_out, a_, p, p_end, dq < 0);
    contacts_.push_back(contact);
  }

  /// What `path` does from its vertex `in` to `out`, which the other one passes from `other_in` to `other_out`.
  static PathVisit VisitOf(const RefinedPath& path, std::size_t in, std::size_t out, const RefinedPath& other,
                           std::size_t other_in, std::size_t other_out, bool against) {
    PathVisit visit{.in = path.spots[in], .out = path.spots[out]};
    visit.starts = !path.has_before(in);
    visit.ends = !path.has_after(out);
    const std::size_t at_in = against ? other_out : other_in, at_out = against ? other_in : other_out;
    const auto side = [&](std::size_t at, Point q) {
      if (!other.has_before(at) || !other.has_after(at)) return Side::kNone;
      return SideOf(other.points[at - 1], other.points[at], other.points[at + 1], q);
    };
    if (!visit.starts) visit.from = side(at_in, path.points[in - 1]);
    if (!visit.ends) visit.to = side(at_out, path.points[out + 1]);
    return visit;
  }

  PathPair pair_;
  RefinedPath a_, b_;
  std::vector<PathContact>& contacts_;
};

/// Finds what segments of paths have in common.
class ContactFinder {
 public:
  explicit ContactFinder(const std::vector<RobotPath>& paths) : paths_(paths) {}

  /// Adds the segments of a path to those that are met.
  void Store(std::size_t path) {
    for (std::size_t k = 0; k + 1 < paths_[path].points.size(); ++k) {
      stored_.push_back({static_cast<std::int32_t>(path), static_cast<std::int32_t>(k)});
      segments_.emplace_back(paths_[path].points[k], paths_[path].points[k + 1]);
    }
  }

  /// Meets the stored segments with those of the `asked` paths; of pairs that are both stored, those with a < b alone.
  std::vector<PathContact> Meet(const std::vector<std::int32_t>& asked, bool ordered) {
    const BoxIndex index(segments_);
    std::vector<std::size_t> seen(segments_.size(), 0);
    std::size_t stamp = 0;
    for (const std::int32_t path : asked) {
      const Polyline& points = paths_[static_cast<std::size_t>(path)].points;
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        ++stamp;
        index.ForEachAlong(points[k], points[k + 1], 0, [&](std::size_t s) {
          if (seen[s] == stamp || stored_[s].path == path || (ordered && stored_[s].path < path)) return;
          seen[s] = stamp;
          MeetSegments({path, static_cast<std::int32_t>(k)}, stored_[s]);
        });
      }
    }
    for (const auto& [a, b] : touching_) SharedParts({a, b}, Path(a), Path(b), contacts_).Find();
    std::sort(contacts_.begin(), contacts_.end(), [](const PathContact& p, const PathContact& q) {
      return std::tie(p.a, p.b, p.of_a.in.segment, p.of_a.in.along, p.of_b.in.along) <
             std::tie(q.a, q.b, q.of_a.in.segment, q.of_a.in.along, q.of_b.in.along);
    });
    return std::move(contacts_);
  }

 private:
  struct Segment {
    std::int32_t path, k;
  };

  const RobotPath& Path(std::int32_t path) const { return paths_[static_cast<std::size_t>(path)]; }

  void MeetSegments(Segment s, Segment t) {
    const auto i = static_cast<std::size_t>(s.k), j = static_cast<std::size_t>(t.k);
    const Point a = Path(s.path).points[i], b = Path(s.path).points[i + 1];
    const Point c = Path(t.path).points[j], d = Path(t.path).points[j + 1];
    if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
        std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) {
      return;
    }
    const int at_a = Orientation(c, d, a), at_b = Orientation(c, d, b);
    if (at_a * at_b > 0) return;
    const int at_c = Orientation(a, b, c), at_d = Orientation(a, b, d);
    if (at_c * at_d > 0) return;
    if (at_a * at_b < 0 && at_c * at_d < 0) {
      AddCrossing(s, t);
    } else if (OnSegment(c, d, a) || OnSegment(c, d, b) || OnSegment(a, b, c) || OnSegment(a, b, d)) {
      touching_.emplace(s.path, t.path);
    }
  }

  void AddCrossing(Segment s, Segment t) {
    const RobotPath &p = Path(s.path), &q = Path(t.path);
    const auto i = static_cast<std::size_t>(s.k), j = static_cast<std::size_t>(t.k);
    const Point a = p.points[i], b = p.points[i + 1], c = q.points[j], d = q.points[j + 1];
    const double of_a = Cross(d - c, a - c), of_b = Cross(d - c, b - c);
    const double of_c = Cross(b - a, c - a), of_d = Cross(b - a, d - a);
    const double u = of_a == of_b ? 0.5 : std::clamp(of_a / (of_a - of_b), 0.0, 1.0);
    const double v = of_c == of_d ? 0.5 : std::clamp(of_c / (of_c - of_d), 0.0, 1.0);
    PathContact contact{.a = RobotId(s.path), .b = RobotId(t.path)};
    contact.at = contact.until = Lerp(a, b, u);
    contact.of_a.in = {s.k, false, p.along[i] + u * (p.along[i + 1] - p.along[i])};
    contact.of_b.in = {t.k, false, q.along[j] + v * (q.along[j + 1] - q.along[j])};
    contact.of_a.out = contact.of_a.in;
    contact.of_b.out = contact.of_b.in;
    const bool from_left = Orientation(a, b, c) > 0;
    contact.of_b.from = from_left ? Side::kLeft : Side::kRight;
    contact.of_b.to = Opposite(contact.of_b.from);
    contact.of_a.from = contact.of_b.to;
    contact.of_a.to = contact.of_b.from;
    contacts_.push_back(contact);
  }

  const std::vector<RobotPath>& paths_;
  std::vector<Segment> stored_;
  std::vector<BoxIndex::Segment> segments_;
  std::set<PathPair> touching_;
  std::vector<PathContact> contacts_;
};

}  // namespace

std::vector<PathContact> FindContacts(const std::vector<RobotPath>& paths) {
  ContactFinder finder(paths);
  std::vector<std::int32_t> asked;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    finder.Store(i);
    asked.push_back(static_cast<std::int32_t>(i));
  }
  return finder.Meet(asked, true);
}

std::vector<PathContact> FindContacts(const std::vector<RobotPath>& paths, const std::vector<RobotId>& chosen) {
  ContactFinder finder(paths);
  std::vector<bool> is_chosen(paths.size(), false);
  std::vector<std::int32_t> asked;
  for (const RobotId robot : chosen) {
    is_chosen[robot.index()] = true;
    asked.push_back(robot.value());
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (!is_chosen[i]) finder.Store(i);
  }
  return finder.Meet(asked, false);
}

int CompareSpots(const RobotPath& path, const SpotOnPath& p, const SpotOnPath& q) {
  if (p.spot.segment != q.spot.segment) return p.spot.segment < q.spot.segment ? -1 : 1;
  if (p.spot.at_point != q.spot.at_point) return p.spot.at_point ? -1 : 1;
  if (p.spot.at_point) return 0;
  const auto k = static_cast<std::size_t>(p.spot.segment);
  const Point a = path.points[k], b = path.points[k + 1];
  if (!p.exact && !q.exact) return CompareCrossings(a, b, p.c, p.d, q.c, q.d);
  if (p.exact && q.exact) {
    // Both lie on the segment exactly, so that one coordinate tells.
    const double of_p = a.x != b.x ? p.c.x : p.c.y, of_q = a.x != b.x ? q.c.x : q.c.y;
    if (of_p == of_q) return 0;
    return (of_p < of_q) == (a.x != b.x ? a.x < b.x : a.y < b.y) ? -1 : 1;
  }
  if (q.exact) return -CompareSpots(path, q, p);
  const int side = Orientation(q.c, q.d, p.c);
  return side == 0 ? 0 : side == Orientation(q.c, q.d, a) ? -1 : 1;
}

}  // namespace tautline
