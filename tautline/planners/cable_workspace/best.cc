#include "tautline/planners/cable_workspace/best.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/classes.h"
#include "tautline/planners/cable_workspace/anchor_curves.h"
#include "tautline/planners/cable_workspace/boundary_fan.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

/// The shortest way from each anchor to the next one, metres; nothing when two are not connected.
std::optional<std::vector<double>> ShortestSides(const CableGround& ground, const Anchors& anchors) {
  std::vector<double> shortest;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    Walk start(anchors[i].exit);
    start.rooted = true;
    const auto path = FindShortestOnward(ground.space(), start, anchors[NextAnchor(i, anchors.size())].exit);
    if (!path) return std::nullopt;
    shortest.push_back(path->length);
  }
  return shortest;
}

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
    const double most = number(*first) + kLengthTolerance * std::abs(number(*first));
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
      : ground_(ground), anchors_(anchors), options_(options), curves_(ground) {}

  BoundaryList Run() {
    BoundaryList list;
    const auto shortest = ShortestSides(ground_, anchors_);
    if (!shortest) return {{}, true, WorkspaceObstruction::kAnchorsUnconnected};
    SearchBudget budget(options_.budget, options_.keep_going);
    try {
      if (ListSides(*shortest, budget)) {
        BoundaryFan fan(ground_, curves_, sides_, {*shortest, limit_, ChordsCanCross(), &budget});
        fan.ForEach([&](std::span<const CurveId> sides) { Close(sides, list); });
      }
      list.complete = !incomplete_;
    } catch (const Stopped&) {
    }
    SortBoundaries(list.boundaries);
    if (list.boundaries.empty()) list.obstruction = WorkspaceObstruction::kNoBoundary;
    return list;
  }

 private:
  /// Chords between corners of a valid boundary cross neither it nor each other; but what ends in the open crosses
  /// nothing, so that sides there might cross a chord.
  bool ChordsCanCross() const {
    return std::all_of(anchors_.begin(), anchors_.end(),
                       [&](const Socket& anchor) { return EndsOnBoundary(ground_.space(), anchor.exit); });
  }

  /// All classes of all sides that may be part of a boundary. False when there is none for some side.
  bool ListSides(const std::vector<double>& shortest, SearchBudget& budget) {
    const double all = std::accumulate(shortest.begin(), shortest.end(), 0.0);
    limit_ = options_.max_boundary;
    for (const Socket& anchor : anchors_) limit_ -= 2 * anchor.stub_length;
    limit_ += kLengthTolerance * options_.max_boundary;
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      // The way back along all other sides is at least as long as the side.
      const double longest = std::min(limit_ - (all - shortest[i]), limit_ / 2);
      if (longest < 0) return false;
      if (!ListSide(i, longest, budget)) return false;
    }
    return true;
  }

  bool ListSide(std::size_t i, double longest, SearchBudget& budget) {
    const Socket &from = anchors_[i], &to = anchors_[NextAnchor(i, anchors_.size())];
    Walk start(from.exit);
    start.rooted = true;
    const ClassList list = FindClassesOnward(
        ground_.space(), start, to.exit,
        {.max_length = longest, .max_count = {}, .budget = budget.left(), .keep_going = options_.keep_going});
    if (!list.complete) incomplete_ = true;
    std::vector<CurveId> side;
    for (const TautPath& path : list.classes) {
      budget.Spend();
      const CurveId curve = curves_.Add(WalkBetween(ground_, from, to, path));
      if (!curves_.CrossesItself(curve)) side.push_back(curve);
    }
    std::stable_sort(side.begin(), side.end(),
                     [&](CurveId a, CurveId b) { return curves_.length(a) < curves_.length(b); });
    sides_.push_back(std::move(side));
    return !sides_.back().empty();
  }

  void Close(std::span<const CurveId> sides, BoundaryList& list) {
    std::vector<Walk> walks;
    for (const CurveId side : sides) walks.push_back(curves_.walk(side));
    auto boundary = CloseBoundary(ground_, anchors_, std::move(walks));
    if (!boundary) {
      TAUTLINE_CHECK(boundary.error().obstruction == WorkspaceObstruction::kNoArea);
      return;
    }
    if (HoldsAll(ground_, *boundary, options_.tasks)) list.boundaries.push_back(*std::move(boundary));
  }

  const CableGround& ground_;
  const Anchors& anchors_;
  const BestOptions& options_;
  AnchorCurves curves_;
  std::vector<std::vector<CurveId>> sides_;
  double limit_ = 0;
  bool incomplete_ = false;
};

}  // namespace

BoundaryList FindBoundaries(const CableGround& ground, const Anchors& anchors, const BestOptions& options) {
  TAUTLINE_CHECK(anchors.size() >= 2);
  return BoundarySearch(ground, anchors, options).Run();
}

}  // namespace tautline
