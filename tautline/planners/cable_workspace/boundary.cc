#include "tautline/planners/cable_workspace/boundary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/word_path.h"
#include "tautline/planners/cable_workspace/explain_workspace.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

/// The sides one after the other, with the stubs of the anchors between.
Ring RingOf(const Anchors& anchors, const std::vector<BoundarySide>& sides) {
  Ring ring;
  const auto add = [&ring](Point p) {
    if (ring.empty() || ring.back() != p) ring.push_back(p);
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (anchors[i].stub_length > 0) add(anchors[i].base);
    for (const Point p : sides[i].path.points) add(p);
  }
  if (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  return ring;
}

/// Whether segments cross by more than the rounding of ends beside slanted walls.
bool CrossClearly(Point a, Point b, Point c, Point d, double tolerance) {
  const double least = std::min(
      {DistanceToSegment(a, c, d), DistanceToSegment(b, c, d), DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)});
  return least > tolerance && CrossProperly(a, b, c, d);
}

bool CurvesCross(const Polyline& a, const Polyline& b, double tolerance) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      if (CrossClearly(a[i], a[i + 1], b[k], b[k + 1], tolerance)) return true;
    }
  }
  return false;
}

/// The first pair of sides that cross, or a side that crosses itself. What ends in the open crosses nothing by its
/// class; its segments may.
std::vector<std::size_t> FindCrossing(const TautSpace& space, const std::vector<Walk>& walks,
                                      const std::vector<TautPath>& paths) {
  std::vector<bool> is_open;
  is_open.reserve(walks.size());
  for (const Walk& walk : walks) {
    is_open.push_back(!EndsOnBoundary(space, {walk.from, walk.sleeve.front()}) ||
                      !EndsOnBoundary(space, {walk.at, walk.sleeve.back()}));
  }
  std::vector<WalkSpots> spots;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    spots.emplace_back(space, walks[i]);
    if (CablesCross(spots[i], spots[i])) return {i};
    for (std::size_t k = 0; k < i; ++k) {
      if (CablesCross(spots[k], spots[i])) return {k, i};
    }
    for (std::size_t k = 0; k <= i; ++k) {
      if (!is_open[i] && !is_open[k]) continue;
      if (!CurvesCross(paths[k].points, paths[i].points, space.tolerance())) continue;
      return k == i ? std::vector{i} : std::vector{k, i};
    }
  }
  return {};
}

bool IsClosed(const CableGround& ground, const std::vector<Walk>& walks) {
  Walk loop = walks[0];
  for (std::size_t i = 1; i < walks.size(); ++i) loop = Joined(ground.space().mesh(), loop, walks[i]);
  TAUTLINE_CHECK(TurnInto(ground.space().mesh(), walks[0].sleeve.front(), loop));
  return loop.sleeve.size() == 1;
}

/// Whether two walks end in one sector: where blocked ground touches, cables from both sides end at one point and do
/// not meet.
bool CanMeet(const FreeMesh& mesh, const Walk& first, const Walk& second) {
  Walk turned(Place{second.at, second.sleeve.back()});
  return TurnInto(mesh, first.sleeve.back(), turned);
}

}  // namespace

tl::expected<WorkspaceBoundary, BoundaryFault> CloseBoundary(const CableGround& ground, const Anchors& anchors,
                                                             std::vector<Walk> walks, std::vector<TautPath> paths) {
  TAUTLINE_CHECK(walks.size() == anchors.size() && walks.size() >= 2);
  for (std::size_t i = paths.size(); i < walks.size(); ++i) paths.push_back(ground.space().Pull(walks[i]));
  const auto fault = [&](WorkspaceObstruction obstruction, std::vector<std::size_t> sides) {
    BoundaryFault found{.obstruction = obstruction, .sides = std::move(sides), .at = {}, .explanation = ""};
    found.explanation = ExplainBoundary(ground, anchors, found);
    found.curves = std::move(paths);
    return tl::unexpected(std::move(found));
  };
  if (!IsClosed(ground, walks)) return fault(WorkspaceObstruction::kNotClosed, {});
  if (auto crossing = FindCrossing(ground.space(), walks, paths); !crossing.empty()) {
    return fault(WorkspaceObstruction::kCrossesItself, std::move(crossing));
  }
  WorkspaceBoundary boundary;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    boundary.length += paths[i].length + 2 * anchors[i].stub_length;
    boundary.sides.push_back({paths[i], std::move(walks[i])});
  }
  boundary.ring = RingOf(anchors, boundary.sides);
  boundary.area = std::fabs(SignedArea(boundary.ring));
  // Anchors in a line beside a slanted wall are off it by rounding.
  if (!(boundary.area > ground.space().tolerance() * boundary.length)) return fault(WorkspaceObstruction::kNoArea, {});
  return boundary;
}

tl::expected<std::vector<Walk>, BoundaryFault> FollowCables(const CableGround& ground, const Anchors& anchors,
                                                            std::span<const Polyline> laid) {
  TAUTLINE_CHECK(laid.size() == anchors.size());
  const auto fault = [&](WorkspaceObstruction obstruction, std::size_t anchor, Point at) {
    BoundaryFault found{.obstruction = obstruction, .sides = {anchor}, .at = at, .explanation = ""};
    found.explanation = ExplainBoundary(ground, anchors, found);
    return tl::unexpected(std::move(found));
  };
  const auto robot = ground.space().Locate(laid[0].front());
  if (!robot) return fault(WorkspaceObstruction::kRobotBlocked, 0, laid[0].front());
  std::vector<Walk> cables;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    Walk root(anchors[i].exit);
    root.rooted = true;
    std::optional<Walk> walk = root;
    Polyline to_robot(laid[i].rbegin(), laid[i].rend());
    // Cables may start within rounding of one point; they have one end.
    to_robot.back() = robot->point;
    // A cable whose robot is at the anchor may be that point alone.
    const auto departure = ground.space().Follow(std::span(to_robot).subspan(to_robot.size() > 1 ? 1 : 0), walk);
    if (departure) return fault(WorkspaceObstruction::kLaidCableBlocked, i, departure->at);
    cables.push_back(*std::move(walk));
    if (!CanMeet(ground.space().mesh(), cables.front(), cables.back())) {
      return fault(WorkspaceObstruction::kLaidCableBlocked, i, robot->point);
    }
  }
  return cables;
}

tl::expected<WorkspaceBoundary, BoundaryFault> BoundaryOfCables(const CableGround& ground, const Anchors& anchors,
                                                                std::span<const Polyline> laid) {
  const auto cables = FollowCables(ground, anchors, laid);
  if (!cables) return tl::unexpected(cables.error());
  std::vector<Walk> walks;
  for (std::size_t i = 0; i < cables->size(); ++i) {
    const Walk& next = (*cables)[NextAnchor(i, cables->size())];
    walks.push_back(Joined(ground.space().mesh(), (*cables)[i], Reversed(next)));
    TAUTLINE_CHECK(TurnInto(ground.space().mesh(), anchors[NextAnchor(i, cables->size())].exit.triangle, walks[i]));
  }
  return CloseBoundary(ground, anchors, std::move(walks));
}

tl::expected<WorkspaceBoundary, BoundaryFault> BoundaryOfWords(const CableGround& ground, const Anchors& anchors,
                                                               std::span<const Word> words) {
  TAUTLINE_CHECK(words.size() == anchors.size());
  std::vector<Walk> walks;
  std::vector<TautPath> paths;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Socket &from = anchors[i], &to = anchors[NextAnchor(i, anchors.size())];
    const bool connected = ground.space().mesh().Connected(from.exit, to.exit);
    const auto path = connected ? FindWordPath(ground.space(), from.exit, to.exit, words[i]) : std::nullopt;
    if (!path) {
      BoundaryFault found{
          .obstruction = connected ? WorkspaceObstruction::kNoSuchClass : WorkspaceObstruction::kAnchorsUnconnected,
          .sides = {i},
          .at = {},
          .explanation = ""};
      found.explanation = ExplainBoundary(ground, anchors, found);
      found.curves = std::move(paths);
      return tl::unexpected(std::move(found));
    }
    walks.push_back(WalkBetween(ground, from, to, *path));
    paths.push_back(*path);
  }
  return CloseBoundary(ground, anchors, std::move(walks), std::move(paths));
}

std::vector<ObstacleId> TouchedIslands(const CableGround& ground, const WorkspaceBoundary& boundary) {
  std::vector<std::pair<Point, ObstacleId>> owners;
  for (const FreeComponent& component : ground.space().free_space().components) {
    for (const BoundaryRing& hole : component.holes) {
      for (const Point p : hole.points) owners.emplace_back(p, hole.obstacle);
    }
  }
  std::sort(owners.begin(), owners.end());
  std::vector<ObstacleId> touched;
  for (const BoundarySide& side : boundary.sides) {
    for (std::size_t i = 1; i + 1 < side.path.points.size(); ++i) {
      const Point bend = side.path.points[i];
      auto owner = std::lower_bound(owners.begin(), owners.end(), std::pair(bend, ObstacleId()));
      for (; owner != owners.end() && owner->first == bend; ++owner) {
        const bool known = std::find(touched.begin(), touched.end(), owner->second) != touched.end();
        if (owner->second.valid() && !known) touched.push_back(owner->second);
      }
    }
  }
  return touched;
}

std::vector<LongestCable> LongestCables(const CableGround& ground, const Anchors& anchors,
                                        const WorkspaceBoundary& boundary) {
  const std::size_t n = anchors.size();
  std::vector<LongestCable> longest(n);
  for (std::size_t i = 0; i < n; ++i) {
    Walk walk = boundary.sides[i].walk;
    for (std::size_t k = NextAnchor(i, n); k != i; k = NextAnchor(k, n)) {
      TautPath path = ground.space().Pull(walk);
      const double length = anchors[i].stub_length + path.length;
      if (length > longest[i].length) longest[i] = {length, k, std::move(path)};
      walk = Joined(ground.space().mesh(), walk, boundary.sides[k].walk);
    }
  }
  return longest;
}

}  // namespace tautline
