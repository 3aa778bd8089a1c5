#include "tautline/planners/tether/reach_sheets.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "tautline/homotopy/goal_field.h"
#include "tautline/planners/tether/cell_slabs.h"
#include "tautline/planners/tether/chain_rings.h"
#include "tautline/planners/tether/cone_sight.h"
#include "tautline/planners/tether/reach_plane.h"
#include "tautline/planners/tether/word_tree.h"

namespace tautline {
namespace {

/// A taut walk that waits for its turn: the one before it, and its last leg, an edge of the visibility graph or (with
/// an invalid edge) a leg from the root.
struct Waiting {
  double length = 0;
  EdgeId edge;
  std::int32_t leg = -1;
  std::int32_t word = 0;  ///< At the start of the last leg.

  friend bool operator>(const Waiting& a, const Waiting& b) {
    return std::tie(a.length, a.edge, a.leg, a.word) > std::tie(b.length, b.edge, b.leg, b.word);
  }
};

class SheetSearch {
 public:
  SheetSearch(const TautSpace& space, const SheetOptions& options)
      : space_(space),
        options_(options),
        join_(JoinTolerance(space.free_space(), options.length)),
        sliver_(JoinTolerance(space.free_space(), 0)),
        cuts_(space.free_space(), space.mesh(), sliver_) {}

  SheetList Run() {
    Start();
    while (!queue_.empty() && list_.walks < options_.budget && GoesOn()) {
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      const Waiting walk = queue_.back();
      queue_.pop_back();
      Count(walk);
    }
    list_.complete = queue_.empty();
    list_.counted_to = list_.complete ? options_.length : queue_.front().length;
    Collect();
    return std::move(list_);
  }

 private:
  /// What was gathered of one word.
  struct Gathered {
    double area = 0;
    std::vector<RegionPiece> pieces;
  };

  /// Tells the watcher, once in so many walks, and asks it whether to go on.
  bool GoesOn() const {
    constexpr std::int64_t kPeriod = 64;
    if (!options_.watch || list_.walks % kPeriod != 0) return true;
    return options_.watch("classes", static_cast<double>(list_.walks) / static_cast<double>(options_.budget));
  }

  Point PointOf(CornerId id) const { return space_.corners()[id].point; }

  std::int32_t WordAfter(std::int32_t word, Point from, Point to) {
    const Point leg[] = {from, to};
    return words_.Append(word, space_.rays().WordOf(leg));
  }

  void Start() {
    const std::int32_t word = words_.Append(0, options_.prefix);
    const Disc disc{options_.root.point, options_.length};
    ++list_.walks;
    for (const Place& sector : space_.mesh().Sectors(options_.root)) {
      Gather(SeeAround(space_.mesh(), sector, disc), disc, word);
      for (const TautLeg& leg : LegsFrom(space_, sector)) {
        Push({leg.length, {}, static_cast<std::int32_t>(legs_.size()), word});
        legs_.push_back(leg);
      }
    }
  }

  void Push(const Waiting& walk) {
    if (walk.length >= options_.length - join_) return;
    queue_.push_back(walk);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    // No more than the budget can ever be taken; the longest others are dropped, but for one that tells of them.
    const auto most = static_cast<std::size_t>(std::max<std::int64_t>(options_.budget - list_.walks, 0)) + 1;
    if (queue_.size() < 2 * most + 1000) return;
    std::nth_element(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(most) - 1, queue_.end(),
                     [](const Waiting& a, const Waiting& b) { return b > a; });
    queue_.resize(most);
    std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
  }

  /// Counts what lies beyond the last turn of a walk, and queues the walks that go on from there.
  void Count(const Waiting& walk) {
    ++list_.walks;
    const bool at_root = !walk.edge.valid();
    const CornerId corner =
        at_root ? legs_[static_cast<std::size_t>(walk.leg)].corner : space_.graph().edge(walk.edge).to;
    const Side head = at_root ? legs_[static_cast<std::size_t>(walk.leg)].side : space_.graph().edge(walk.edge).head;
    const Point from = at_root ? options_.root.point : PointOf(space_.graph().edge(walk.edge).from);
    const Point here = PointOf(corner);
    const std::int32_t word = WordAfter(walk.word, from, here);
    const Disc disc{here, options_.length - walk.length};
    Gather(SeeBeyond(space_.mesh(), {&space_.corners()[corner], head, from}, disc), disc, word);
    const VisibilityGraph& graph = space_.graph();
    const EdgeRange onward = at_root ? graph.Onward(from, corner, head, space_.corners()) : graph.Onward(walk.edge);
    for (EdgeId id = onward.first; id < onward.last; ++id) {
      Push({walk.length + graph.edge(id).length, id, -1, word});
    }
  }

  /// Adds what an eye sees to the sheets of its words; `word` is that of the walk to the eye.
  void Gather(const std::vector<SightCell>& cells, const Disc& disc, std::int32_t word) {
    for (const SightCell& cell : cells) {
      for (CellSlab& slab : SlabsOf(space_.mesh(), cuts_, cell, {.disc = disc, .join = join_, .sliver = sliver_})) {
        const auto at = static_cast<std::size_t>(WordAfter(word, disc.centre, slab.sample));
        if (at >= gathered_.size()) gathered_.resize(at + 1);
        gathered_[at].area += slab.area;
        gathered_[at].pieces.insert(gathered_[at].pieces.end(), slab.pieces.begin(), slab.pieces.end());
      }
    }
  }

  void Collect() {
    for (std::size_t i = 0; i < gathered_.size(); ++i) {
      list_.area += gathered_[i].area;
      // Narrower than points are told apart: between a ray and a wall beside it.
      if (gathered_[i].area <= join_ * options_.length) continue;
      ++list_.classes;
      // Where walks are missing, so are parts of the boundaries.
      if (!list_.complete) continue;
      list_.sheets.push_back({words_.ToWord(static_cast<std::int32_t>(i)), gathered_[i].area,
                              ChainRings(std::move(gathered_[i].pieces), join_)});
    }
    std::sort(list_.sheets.begin(), list_.sheets.end(), [](const Sheet& a, const Sheet& b) {
      return std::pair(a.word.size(), a.word) < std::pair(b.word.size(), b.word);
    });
  }

  const TautSpace& space_;
  const SheetOptions& options_;
  double join_;
  double sliver_;  ///< What rounding of coordinates alone can cause.
  RayCuts cuts_;
  WordTree words_;
  std::vector<TautLeg> legs_;
  std::vector<Waiting> queue_;      ///< A heap, the shortest first.
  std::vector<Gathered> gathered_;  ///< By word.
  SheetList list_;
};

}  // namespace

SheetList ReachSheets(const TautSpace& space, const SheetOptions& options) {
  if (!(options.length > 0)) return {.complete = true};
  return SheetSearch(space, options).Run();
}

}  // namespace tautline
