#include "tautline/planners/grid_manifold/deadlocks.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/grid_manifold/tether_contacts.h"

namespace tautline {

/// The sides of one contact after the other, by Dijkstra from all vertices beside the contact at a time. Each of those
/// begins a part; parts that meet become one.
class DeadlockSearch {
 public:
  DeadlockSearch(const GridManifold& manifold, DeadlockAreas& areas)
      : manifold_(manifold),
        areas_(areas),
        step_(manifold.atlas().connectivity() == Connectivity::kEight ? 1 : 2),
        reach_(std::min(manifold.limit(), manifold.complete_up_to() - 1)),
        marks_(manifold.ground().grid().cells.size()),
        distance_(manifold.value_count(), kUnreached),
        part_(manifold.value_count()) {}

  void Examine(std::size_t contact) {
    const ManifoldVertex v = areas_.contacts_[contact].vertex;
    rest_ = reach_ - manifold_.distance(v);
    const std::vector<ManifoldVertex> path = PathToBase(manifold_, v);
    LayPath(path);
    FindFlanks(path);
    if (!RunsAway(v)) {
      Begin(v);
      Search();
      CloseDeadlocks(contact);
    }
    LiftPath(path);
  }

 private:
  void CloseDeadlocks(std::size_t contact) {
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (Root(part) == part && IsDeadlock(parts_[part])) Close(contact, part);
    }
    Forget();
    for (auto& bucket : buckets_) bucket.clear();
  }

  void Forget() {
    for (const ManifoldVertex u : visited_) distance_[areas_.ValueOf(u)] = kUnreached;
    visited_.clear();
  }

  static constexpr LatticeDistance kRun = 0, kRunFar = 1;  ///< Marks of running away.
  static constexpr int kRunsPerStep = 8;
  static constexpr std::uint8_t kOnPath = 1, kRising = 2, kFalling = 4;

  /// What one search from beside the contact found out.
  struct Part {
    std::size_t parent = 0;          ///< The part that it belongs to; itself, when it stands for all.
    bool far = false;                ///< Has a vertex farther than the tether's rest.
    std::array<bool, 2> at_flank{};  ///< Reaches the cells to the left and to the right of the path's last step.
    bool resolvable() const { return far || (at_flank[0] && at_flank[1]); }
  };

  static bool IsDeadlock(const Part& part) { return !part.far && part.at_flank[0] != part.at_flank[1]; }

  std::size_t IndexOf(GridCell cell) const { return manifold_.ground().grid().index(cell.column, cell.row); }

  /// Marks the cells of the path, and the squares of four cells that its diagonal steps pass through, at their lower
  /// left cell.
  void LayPath(const std::vector<ManifoldVertex>& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      const GridCell cell = manifold_.CellOf(path[i]);
      marks_[IndexOf(cell)] |= kOnPath;
      if (i == 0) continue;
      const GridCell before = manifold_.CellOf(path[i - 1]);
      const int columns = cell.column - before.column, rows = cell.row - before.row;
      if (columns == 0 || rows == 0) continue;
      const GridCell square{std::min(cell.column, before.column), std::min(cell.row, before.row)};
      marks_[IndexOf(square)] |= columns == rows ? kRising : kFalling;
    }
  }

  void LiftPath(const std::vector<ManifoldVertex>& path) {
    for (const ManifoldVertex u : path) {
      const GridCell cell = manifold_.CellOf(u);
      for (int row = std::max(0, cell.row - 1); row <= cell.row; ++row) {
        for (int column = std::max(0, cell.column - 1); column <= cell.column; ++column) {
          marks_[IndexOf({column, row})] = 0;
        }
      }
    }
  }

  /// The cells on both sides of the last step; they are free, because no blocked cell is beside the parent.
  void FindFlanks(const std::vector<ManifoldVertex>& path) {
    const GridCell parent = manifold_.CellOf(path[1]);
    const int back = *DirectionToBase(manifold_, path[0]), turn = back % 2 == 0 ? 2 : 1;
    for (std::size_t side = 0; side < 2; ++side) {
      const auto d = static_cast<std::size_t>((back ^ 4) + (side == 0 ? turn : kDirections - turn)) % kDirections;
      flanks_[side] = {parent.column + kStepColumns[d], parent.row + kStepRows[d]};
    }
  }

  /// Whether a step comes upon the path, or passes through it between two of its cells.
  bool IsBarred(GridCell from, int direction) const {
    const auto d = static_cast<std::size_t>(direction);
    const GridCell to{from.column + kStepColumns[d], from.row + kStepRows[d]};
    if ((marks_[IndexOf(to)] & kOnPath) != 0) return true;
    if (d % 2 == 0) return false;
    const GridCell square{std::min(from.column, to.column), std::min(from.row, to.row)};
    return (marks_[IndexOf(square)] & (d % 4 == 1 ? kFalling : kRising)) != 0;
  }

  /// The least length of a way between two cells.
  LatticeDistance Apart(GridCell a, GridCell b) const {
    const int columns = std::abs(a.column - b.column), rows = std::abs(a.row - b.row);
    if (step_ == 2) return (columns + rows) * kStraightStep;
    const int less = std::min(columns, rows), more = std::max(columns, rows);
    return less * kDiagonalStep + (more - less) * kStraightStep;
  }

  /// Tries to settle every part by going straight away from the contact: in most places that leads far enough, and
  /// much faster than by way of all that is nearer. Says nothing where it fails.
  bool RunsAway(ManifoldVertex v) {
    bool all = true;
    const GridCell from = manifold_.CellOf(v);
    for (int d = 0; d < kDirections && all; d += step_) {
      const auto first = manifold_.Step(v, d);
      if (first && !IsBarred(from, d)) all = RunsAway(from, *first);
    }
    Forget();
    return all;
  }

  /// Best first, by the distance as the crow flies. What an earlier run has visited is joined to its end.
  bool RunsAway(GridCell from, ManifoldVertex first) {
    using Candidate = std::tuple<LatticeDistance, std::uint32_t, int>;
    std::priority_queue<Candidate> queue;
    queue.emplace(Apart(from, manifold_.CellOf(first)), first.page, first.cell);
    for (int tries = kRunsPerStep * (rest_ / kStraightStep + kRunsPerStep); tries > 0 && !queue.empty(); --tries) {
      const auto [apart, page, cell] = queue.top();
      queue.pop();
      const ManifoldVertex v{page, cell};
      LatticeDistance& mark = distance_[areas_.ValueOf(v)];
      if (apart > rest_ || mark == kRunFar) {
        for (const ManifoldVertex u : visited_) distance_[areas_.ValueOf(u)] = kRunFar;
        return true;
      }
      if (mark != kUnreached) continue;
      mark = kRun;
      visited_.push_back(v);
      for (int d = 0; d < kDirections; d += step_) {
        const auto to = manifold_.Step(v, d);
        if (!to || IsBarred(manifold_.CellOf(v), d) || distance_[areas_.ValueOf(*to)] == kRun) continue;
        queue.emplace(Apart(from, manifold_.CellOf(*to)), to->page, to->cell);
      }
    }
    return false;
  }

  void Begin(ManifoldVertex v) {
    parts_.clear();
    for (int d = 0; d < kDirections; d += step_) {
      const auto to = manifold_.Step(v, d);
      if (!to || IsBarred(manifold_.CellOf(v), d)) continue;
      parts_.push_back({.parent = parts_.size()});
      Offer(*to, StepLength(d), parts_.size() - 1);
    }
  }

  void Offer(ManifoldVertex v, LatticeDistance distance, std::size_t part) {
    const std::size_t value = areas_.ValueOf(v);
    if (distance_[value] == kUnreached) {
      visited_.push_back(v);
    } else {
      Unite(part, part_[value]);
      if (distance_[value] <= distance) return;
    }
    distance_[value] = distance;
    part_[value] = static_cast<std::uint8_t>(part);
    const auto bucket = static_cast<std::size_t>(distance / kStraightStep);
    if (buckets_.size() <= bucket) buckets_.resize(bucket + 1);
    buckets_[bucket].emplace_back(v, distance);
  }

  std::size_t Root(std::size_t part) const {
    while (parts_[part].parent != part) part = parts_[part].parent;
    return part;
  }

  void Unite(std::size_t a, std::size_t b) {
    a = Root(a);
    b = Root(b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    parts_[b].parent = a;
    parts_[a].far = parts_[a].far || parts_[b].far;
    for (std::size_t side = 0; side < 2; ++side) {
      parts_[a].at_flank[side] = parts_[a].at_flank[side] || parts_[b].at_flank[side];
    }
  }

  bool AllResolvable() const {
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (parts_[part].parent == part && !parts_[part].resolvable()) return false;
    }
    return true;
  }

  /// Buckets are no wider than the shortest step, so that what stands in one is final when its turn comes. A vertex
  /// beyond the tether's rest settles its part and is not gone on from.
  void Search() {
    for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
      if (AllResolvable()) return;
      for (std::size_t i = 0; i < buckets_[bucket].size(); ++i) {
        const auto [v, distance] = buckets_[bucket][i];
        const std::size_t value = areas_.ValueOf(v);
        if (distance_[value] != distance) continue;
        Visit(v, distance, part_[value]);
      }
    }
  }

  void Visit(ManifoldVertex v, LatticeDistance distance, std::size_t part) {
    Part& root = parts_[Root(part)];
    if (distance > rest_) {
      root.far = true;
      return;
    }
    const GridCell cell = manifold_.CellOf(v);
    for (std::size_t side = 0; side < 2; ++side) {
      if (cell == flanks_[side]) root.at_flank[side] = true;
    }
    for (int d = 0; d < kDirections; d += step_) {
      const auto to = manifold_.Step(v, d);
      if (to && !IsBarred(cell, d)) Offer(*to, distance + StepLength(d), part);
    }
  }

  void Close(std::size_t contact, std::size_t part) {
    Deadlock deadlock{.contact = contact};
    const LatticeDistance from = manifold_.distance(areas_.contacts_[contact].vertex);
    for (const ManifoldVertex u : visited_) {
      const std::size_t value = areas_.ValueOf(u);
      if (Root(part_[value]) != part) continue;
      ++deadlock.region;
      deadlock.farthest = std::max(deadlock.farthest, distance_[value]);
      if (manifold_.distance(u) <= from) continue;
      ++deadlock.beyond;
      if (areas_.closed_[value]) continue;
      areas_.closed_[value] = true;
      ++deadlock.closed;
    }
    if (deadlock.beyond == 0) return;
    areas_.closed_count_ += deadlock.closed;
    areas_.deadlocks_.push_back(deadlock);
  }

  const GridManifold& manifold_;
  DeadlockAreas& areas_;
  const int step_;
  const LatticeDistance reach_;

  std::vector<std::uint8_t> marks_;        ///< By cell: what the path does there.
  std::vector<LatticeDistance> distance_;  ///< By value: from the contact.
  std::vector<std::uint8_t> part_;         ///< By value: the search that it was reached by.
  std::vector<ManifoldVertex> visited_;
  std::vector<std::vector<std::pair<ManifoldVertex, LatticeDistance>>> buckets_;
  std::vector<Part> parts_;
  std::array<GridCell, 2> flanks_;
  LatticeDistance rest_ = 0;
};

DeadlockAreas::DeadlockAreas(const GridManifold& manifold, const KeepGoing& keep_going)
    : manifold_(manifold), contacts_(FindTetherContacts(manifold)), closed_(manifold.value_count()) {
  DeadlockSearch search(manifold, *this);
  for (; examined_ < contacts_.size(); ++examined_) {
    if (keep_going && !keep_going()) return;
    if (!IsClosed(contacts_[examined_].vertex)) search.Examine(examined_);
  }
}

std::int64_t DeadlockAreas::LostCells() const {
  std::vector<bool> has(manifold_.ground().grid().cells.size()), open(has.size());
  for (std::uint32_t page = 0; page < manifold_.pages(); ++page) {
    for (TileMask cells = manifold_.vertices(page); cells != 0; cells &= cells - 1) {
      const ManifoldVertex v{page, __builtin_ctzll(cells)};
      const GridCell cell = manifold_.CellOf(v);
      const std::size_t index = manifold_.ground().grid().index(cell.column, cell.row);
      has[index] = true;
      if (!IsClosed(v)) open[index] = true;
    }
  }
  return std::count(has.begin(), has.end(), true) - std::count(open.begin(), open.end(), true);
}

std::optional<int> DirectionToBase(const GridManifold& manifold, ManifoldVertex v) {
  const LatticeDistance here = manifold.distance(v);
  if (here == 0) return std::nullopt;
  // Diagonal steps lead nearest.
  for (const int first : {1, 0}) {
    if (first == 1 && manifold.atlas().connectivity() == Connectivity::kFour) continue;
    for (int d = first; d < kDirections; d += 2) {
      const auto to = manifold.Step(v, d);
      if (to && manifold.distance(*to) == here - StepLength(d)) return d;
    }
  }
  TAUTLINE_CHECK(false);
}

std::vector<ManifoldVertex> PathToBase(const GridManifold& manifold, ManifoldVertex v) {
  std::vector<ManifoldVertex> path{v};
  for (auto d = DirectionToBase(manifold, v); d; d = DirectionToBase(manifold, path.back())) {
    path.push_back(*manifold.Step(path.back(), *d));
  }
  return path;
}

}  // namespace tautline
