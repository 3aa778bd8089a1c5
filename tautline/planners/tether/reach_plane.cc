#include "tautline/planners/tether/reach_plane.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <span>
#include <utility>

#include "tautline/homotopy/goal_field.h"
#include "tautline/planners/tether/chain_rings.h"
#include "tautline/planners/tether/cone_sight.h"

namespace tautline {
namespace {

/// Ways to a corner that agree this closely, relative to the tether, are equally short: each turn counts.
constexpr double kTieTolerance = 1e-12;

/// A turn at the end of a shortest path, and what the tether reaches beyond it.
struct Sector {
  Turn turn;  ///< Without a corner: around the root itself.
  Disc disc;
};

/// A cell of one sector.
struct OwnedCell {
  SightCell cell;
  std::size_t sector = 0;
};

/// The last leg of a way to a corner.
struct LastLeg {
  CornerId corner;
  Side head = Side::kNone;
  Point from;
  double length = 0;  ///< Of the whole way.
};

class PlaneRegion {
 public:
  PlaneRegion(const TautSpace& space, Place root, double length)
      : space_(space),
        mesh_(space.mesh()),
        root_(root),
        length_(length),
        join_(JoinTolerance(space.free_space(), length)) {}

  std::vector<RegionRing> Run() {
    for (const Place& sector : mesh_.Sectors(root_)) {
      AddSector({{}, {root_.point, length_}}, SeeAround(mesh_, sector, {root_.point, length_}));
    }
    for (const LastLeg& leg : ShortestTurns()) {
      const Disc disc{PointOf(leg.corner), length_ - leg.length};
      const Turn turn{&space_.corners()[leg.corner], leg.head, leg.from};
      AddSector({turn, disc}, SeeBeyond(mesh_, turn, disc));
    }
    std::stable_sort(cells_.begin(), cells_.end(),
                     [](const OwnedCell& a, const OwnedCell& b) { return a.cell.triangle < b.cell.triangle; });
    for (auto begin = cells_.begin(); begin != cells_.end();) {
      const auto end = std::find_if(begin, cells_.end(),
                                    [begin](const OwnedCell& c) { return c.cell.triangle != begin->cell.triangle; });
      const std::span<const OwnedCell> cells(&*begin, static_cast<std::size_t>(end - begin));
      for (int side = 0; side < 3; ++side) AddWalls(cells, side);
      for (const OwnedCell& cell : cells) AddArcs(cells, cell);
      begin = end;
    }
    return ChainRings(std::move(pieces_), join_);
  }

 private:
  Point PointOf(CornerId id) const { return space_.corners()[id].point; }

  void AddSector(const Sector& sector, const std::vector<SightCell>& cells) {
    for (const SightCell& cell : cells) cells_.push_back({cell, sectors_.size()});
    sectors_.push_back(sector);
  }

  /// Calls visit for every leg that extends a shortest path: from the root, or from a corner at `distance`.
  template <class Visit>
  void ForEachLegOut(CornerId corner, double distance, Visit visit) const {
    for (const TautEdge& edge : space_.graph().OutOf(corner)) {
      visit(LastLeg{edge.to, edge.head, PointOf(corner), distance + edge.length});
    }
  }

  template <class Visit>
  void ForEachLegFromRoot(Visit visit) const {
    for (const Place& sector : mesh_.Sectors(root_)) {
      for (const TautLeg& leg : LegsFrom(space_, sector)) visit(LastLeg{leg.corner, leg.side, root_.point, leg.length});
    }
  }

  /// Dijkstra over corners; then the last legs of all shortest ways that are shorter than the tether, ties included.
  std::vector<LastLeg> ShortestTurns() const {
    std::vector<double> distance(space_.corners().size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, CornerId>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto relax = [&](const LastLeg& leg) {
      if (leg.length >= length_ || leg.length >= distance[leg.corner.index()]) return;
      distance[leg.corner.index()] = leg.length;
      queue.emplace(leg.length, leg.corner);
    };
    ForEachLegFromRoot(relax);
    std::vector<CornerId> reached;
    while (!queue.empty()) {
      const auto [length, corner] = queue.top();
      queue.pop();
      if (length > distance[corner.index()]) continue;
      reached.push_back(corner);
      ForEachLegOut(corner, length, relax);
    }
    std::vector<LastLeg> turns;
    const auto keep = [&](const LastLeg& leg) {
      if (leg.length >= length_ || leg.length > distance[leg.corner.index()] + kTieTolerance * length_) return;
      turns.push_back(leg);
    };
    ForEachLegFromRoot(keep);
    for (const CornerId corner : reached) ForEachLegOut(corner, distance[corner.index()], keep);
    return turns;
  }

  /// The reached parts of one side of a triangle, where it is a wall.
  void AddWalls(std::span<const OwnedCell> cells, int side) {
    const TriangleId id = cells[0].cell.triangle;
    if (!mesh_.triangle(id).is_constrained(side)) return;
    const Point from = mesh_.triangulation().corner(id, Next(side)),
                to = mesh_.triangulation().corner(id, Previous(side));
    std::vector<std::pair<double, double>> parts;
    for (const OwnedCell& owned : cells) {
      const auto seen = PartInCone(mesh_, owned.cell, side);
      if (!seen) continue;
      if (const auto part = PartInDisc(*seen, sectors_[owned.sector].disc)) parts.emplace_back(part->from, part->to);
    }
    std::sort(parts.begin(), parts.end());
    const Point low = std::min(from, to), high = std::max(from, to);
    const double gap = join_ / Distance(low, high);
    for (std::size_t i = 0; i < parts.size();) {
      auto [begin, end] = parts[i];
      for (; i < parts.size() && parts[i].first <= end + gap; ++i) end = std::max(end, parts[i].second);
      Point a = begin == 0 ? low : Lerp(low, high, begin), b = end == 1 ? high : Lerp(low, high, end);
      if (to < from) std::swap(a, b);
      pieces_.push_back(
          {.kind = PieceKind::kWall, .from = a, .to = b, .source = 3 * static_cast<std::int64_t>(id.index()) + side});
    }
  }

  /// The parts of a cell's circle that no other cell of the triangle holds.
  void AddArcs(std::span<const OwnedCell> cells, const OwnedCell& owned) {
    const Disc& disc = sectors_[owned.sector].disc;
    for (const AngleSpan& arc : ArcsIn(mesh_, owned.cell, disc)) {
      std::vector<AngleSpan> covers;
      for (const OwnedCell& other : cells) {
        if (other.sector == owned.sector) continue;
        for (const AngleSpan& cover : CoveredBy(other, arc, owned)) covers.push_back(cover);
      }
      for (const AngleSpan& rest : Uncovered(arc, std::move(covers), join_ / disc.radius)) {
        pieces_.push_back({.kind = PieceKind::kArc,
                           .from = PointAt(disc, rest.low),
                           .to = PointAt(disc, rest.high),
                           .centre = disc.centre,
                           .radius = disc.radius,
                           .sweep = rest.width()});
      }
    }
  }

  /// The parts of an arc of `owned` that another cell of the same triangle holds.
  std::vector<AngleSpan> CoveredBy(const OwnedCell& other, const AngleSpan& arc, const OwnedCell& owned) const {
    const Disc& disc = sectors_[owned.sector].disc;
    const AngleRange inside = InsideDisc(disc, sectors_[other.sector].disc, other.sector < owned.sector);
    if (inside.half < 0) return {};
    std::vector<AngleSpan> parts = Intersect({&arc, 1}, inside);
    if (parts.empty()) return {};
    parts = Intersect(parts, LeftOfLine(disc, other.cell.right.tail, other.cell.right.tip));
    return Intersect(parts, LeftOfLine(disc, other.cell.left.tip, other.cell.left.tail));
  }

  const TautSpace& space_;
  const FreeMesh& mesh_;
  Place root_;
  double length_;
  double join_;
  std::vector<Sector> sectors_;
  std::vector<OwnedCell> cells_;
  std::vector<RegionPiece> pieces_;
};

}  // namespace

std::vector<RegionRing> ReachPlane(const TautSpace& space, Place root, double length) {
  if (!(length > 0)) return {};
  return PlaneRegion(space, root, length).Run();
}

double JoinTolerance(const FreeSpace& space, double length) {
  // Crossings of nearly tangent circles are good to about the root of the rounding error; all others are far better.
  constexpr double kShare = 1e-9;
  constexpr double kUlps = 64 * std::numeric_limits<double>::epsilon();
  const double extent = space.box.empty() ? 0 : std::max(space.box.size().x, space.box.size().y);
  double largest = 0;
  for (const Point p : {space.box.low, space.box.high}) {
    if (!space.box.empty()) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  }
  return kShare * std::min(length, extent) + kUlps * largest;
}

}  // namespace tautline
