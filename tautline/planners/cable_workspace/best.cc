#include "tautline/planners/cable_workspace/best.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/cable_workspace/anchor_curves.h"
#include "tautline/planners/cable_workspace/boundary_fan.h"
#include "tautline/planners/cable_workspace/ray_tolls.h"
#include "tautline/planners/cable_workspace/side_classes.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

/// The shares of the slack up to which boundaries are found, round by round. The work grows exponentially with the
/// slack, so that the last round is most of it.
constexpr double kRounds[] = {0.5, 0.75, 1};

bool HoldsAll(const CableGround& ground, const WorkspaceBoundary& boundary, std::span<const Point> tasks) {
  const auto holds = [&](Point task) {
    const Winding winding = WindingNumber(boundary.ring, task);
    if (winding.on_boundary || winding.number != 0) return true;
    for (std::size_t i = 0; i < boundary.ring.size(); ++i) {
      const Point a = boundary.ring[i], b = boundary.ring[(i + 1) % boundary.ring.size()];
      if (DistanceToSegment(task, a, b) <= ground.space().tolerance()) return true;
    }
    return false;
  };
  return std::all_of(tasks.begin(), tasks.end(), holds);
}

/// Sorts a part by a number. Calls tie(first, last) for each run of numbers that agree but for rounding.
template <class It, class Number, class Tie>
void SortByNumber(It first, It last, Number number, Tie tie) {
  std::stable_sort(first, last, [&](const auto& a, const auto& b) { return number(a) < number(b); });
  while (first != last) {
    const double most = number(*first) + kLengthTolerance * std::fabs(number(*first));
    const auto end = std::find_if(first, last, [&](const auto& one) { return number(one) > most; });
    tie(first, end);
    first = end;
  }
}

/// Shorter words first.
bool WordsBefore(const WorkspaceBoundary& a, const WorkspaceBoundary& b) {
  for (std::size_t i = 0; i < a.sides.size(); ++i) {
    const Word &u = a.sides[i].path.word, &v = b.sides[i].path.word;
    if (u != v) return std::pair(u.size(), u) < std::pair(v.size(), v);
  }
  return false;
}

void SortBoundaries(std::vector<WorkspaceBoundary>& boundaries) {
  const auto by_words = [](auto first, auto last) { std::sort(first, last, WordsBefore); };
  const auto by_length = [&](auto first, auto last) {
    SortByNumber(
        first, last, [](const WorkspaceBoundary& b) { return b.length; }, by_words);
  };
  SortByNumber(
      boundaries.begin(), boundaries.end(), [](const WorkspaceBoundary& b) { return -b.area; }, by_length);
}

/// One search, with what it has spent.
class BoundarySearch {
 public:
  BoundarySearch(const CableGround& ground, const Anchors& anchors, const BestOptions& options)
      : ground_(ground),
        anchors_(anchors),
        options_(options),
        on_walls_(std::all_of(anchors.begin(), anchors.end(),
                              [&](const Socket& anchor) { return EndsOnBoundary(ground.space(), anchor.exit); })),
        curves_(ground),
        budget_(options.budget, options.keep_going) {}

  BoundaryList Run() {
    BoundaryList list;
    if (!AreConnected()) return {{}, true, options_.max_boundary, WorkspaceObstruction::kAnchorsUnconnected};
    const double most = options_.max_boundary * (1 + kLengthTolerance) - StubLength();
    const TollGraph graph(ground_.space(), anchors_);
    const RayTolls tolls = graph.Raise(most);
    const double least = std::accumulate(tolls.cheapest.begin(), tolls.cheapest.end(), 0.0);
    try {
      for (const double share : kRounds) {
        if (least > most) break;
        const double limit = least + share * (most - least);
        FindUpTo(limit, graph, tolls, list);
        list.complete_length = std::min(limit + StubLength(), options_.max_boundary);
      }
      list.complete = true;
      list.complete_length = options_.max_boundary;
    } catch (const Stopped&) {
    }
    SortBoundaries(list.boundaries);
    if (list.boundaries.empty()) list.obstruction = WorkspaceObstruction::kNoBoundary;
    return list;
  }

 private:
  /// Each anchor's stub is part of two sides.
  double StubLength() const {
    return std::accumulate(anchors_.begin(), anchors_.end(), 0.0,
                           [](double sum, const Socket& anchor) { return sum + 2 * anchor.stub_length; });
  }

  bool AreConnected() const {
    return std::all_of(anchors_.begin(), anchors_.end(), [&](const Socket& anchor) {
      return ground_.space().mesh().Connected(anchors_[0].exit, anchor.exit);
    });
  }

  void FindUpTo(double limit, const TollGraph& graph, const RayTolls& tolls, BoundaryList& list) {
    const double slack = limit - std::accumulate(tolls.cheapest.begin(), tolls.cheapest.end(), 0.0);
    std::vector<std::vector<CurveId>> sides;
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      // The way back along all other sides is at least as long as the side.
      sides.push_back(ListSide(i, graph, tolls,
                               {.max_cost = tolls.cheapest[i] + slack / 2,
                                .max_length = limit / 2,
                                .drop_crossing = on_walls_,
                                .budget = &budget_}));
    }
    BoundaryFan fan(anchors_, curves_, sides, {tolls.cheapest, limit, on_walls_, &budget_});
    fan.ForEach([&](std::span<const CurveId> found) { Close(found, list); });
  }

  /// The classes of a side, cheapest first, but those that cross themselves.
  std::vector<CurveId> ListSide(std::size_t i, const TollGraph& graph, const RayTolls& tolls,
                                SideClassOptions options) {
    std::vector<CurveId> side;
    options.drop_loops = LoopsCross(ground_.space(), anchors_[i].exit, anchors_[NextAnchor(i, anchors_.size())].exit);
    for (const TautPath& path : ListSideClasses(ground_.space(), anchors_, i, graph, tolls, options)) {
      const Walk walk = WalkBetween(ground_, anchors_[i], anchors_[NextAnchor(i, anchors_.size())], path);
      const CurveId curve = curves_.Add(walk, RefundOf(ground_.space(), tolls, path.points));
      if (!curves_.CrossesItself(curve)) side.push_back(curve);
    }
    std::stable_sort(side.begin(), side.end(), [&](CurveId a, CurveId b) { return curves_.cost(a) < curves_.cost(b); });
    return side;
  }

  /// Takes a boundary that was not found in an earlier round.
  void Close(std::span<const CurveId> sides, BoundaryList& list) {
    if (!found_.insert(std::vector<CurveId>(sides.begin(), sides.end())).second) return;
    std::vector<Walk> walks;
    std::vector<TautPath> paths;
    for (const CurveId side : sides) {
      walks.push_back(curves_.walk(side));
      auto known = paths_.find(side);
      if (known == paths_.end()) known = paths_.emplace(side, ground_.space().Pull(walks.back())).first;
      paths.push_back(known->second);
    }
    auto boundary = CloseBoundary(ground_, anchors_, std::move(walks), std::move(paths));
    if (!boundary) {
      // Chords and sides that end in the open cross nothing as far as the fan knows.
      TAUTLINE_CHECK(boundary.error().obstruction == WorkspaceObstruction::kNoArea || !on_walls_);
      return;
    }
    if (HoldsAll(ground_, *boundary, options_.tasks)) list.boundaries.push_back(*std::move(boundary));
  }

  const CableGround& ground_;
  const Anchors& anchors_;
  const BestOptions& options_;
  /// Chords between corners of a valid boundary cross neither it nor each other; but what ends in the open crosses
  /// nothing, so that sides there might cross a chord.
  bool on_walls_;
  AnchorCurves curves_;
  SearchBudget budget_;
  std::set<std::vector<CurveId>> found_;
  std::map<CurveId, TautPath> paths_;
};

}  // namespace

BoundaryList FindBoundaries(const CableGround& ground, const Anchors& anchors, const BestOptions& options) {
  TAUTLINE_CHECK(anchors.size() >= 2);
  return BoundarySearch(ground, anchors, options).Run();
}

}  // namespace tautline
