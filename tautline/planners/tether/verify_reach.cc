#include "tautline/planners/tether/verify_reach.h"

#include <algorithm>
#include <cmath>

#include "tautline/homotopy/curve_faults.h"

namespace tautline {
namespace {

/// Lengths and areas that agree this closely, relative to the tether and its square, are equal.
constexpr double kTolerance = 1e-6;
constexpr std::size_t kMostArcs = 32;

/// Not by the formula for arcs: by chords, and the circular segments beyond them.
double AreaByChords(const RegionRing& ring) {
  double area = 0;
  const Point origin = ring.pieces[0].from;
  for (const RegionPiece& piece : ring.pieces) {
    area += 0.5 * Cross(piece.from - origin, piece.to - origin);
    area += 0.5 * piece.radius * piece.radius * (piece.sweep - std::sin(piece.sweep));
  }
  return area;
}

class ReachCheck {
 public:
  ReachCheck(const TetherPlanner& planner, const Tether& tether, const ReachResult& result)
      : planner_(planner), tether_(tether), result_(result) {}

  Verification Run() {
    if (result_.status == PlanStatus::kInfeasible) return {};
    CheckRings(result_.regions, result_.area, "the region");
    if (result_.area > result_.connected_area + area_tolerance()) Fault("the region is larger than the free ground");
    CheckArcs();
    if (result_.stretched) CheckCurve(*result_.stretched);
    if (result_.sheets) CheckSheets(*result_.sheets);
    if (result_.at && result_.at->least_tether) CheckCurve(*result_.at->least_tether);
    return verification_;
  }

 private:
  double area_tolerance() const {
    return kTolerance * std::min(tether_.length * tether_.length, std::max(result_.connected_area, 1e-300));
  }

  void Fault(const std::string& fault) { verification_.faults.push_back(fault); }

  void CheckRings(const std::vector<RegionRing>& rings, double area, const std::string& what) {
    double sum = 0;
    for (const RegionRing& ring : rings) {
      for (std::size_t i = 0; i < ring.pieces.size(); ++i) {
        if (ring.pieces[i].to != ring.pieces[(i + 1) % ring.pieces.size()].from) Fault(what + " is not closed");
      }
      sum += AreaByChords(ring);
    }
    if (!(std::fabs(sum - area) <= area_tolerance())) Fault(what + " has another area than its rings");
  }

  void CheckCurve(const TautPath& path) {
    ++verification_.curves;
    const FreeSpace* stub_space = result_.socket->stub_length > 0 ? &planner_.ungrown_space() : nullptr;
    for (const std::string& fault : CurveFaults(planner_.space().free_space(), path, stub_space)) {
      Fault("a tether " + fault);
    }
  }

  /// The middles of arcs all along the boundary.
  void CheckArcs() {
    std::vector<Point> ends;
    for (const RegionRing& ring : result_.regions) {
      for (const RegionPiece& piece : ring.pieces) {
        if (piece.is_arc() && Length(piece) > kTolerance * tether_.length) ends.push_back(Middle(piece));
      }
    }
    const std::size_t step = ends.size() / kMostArcs + 1;
    for (std::size_t i = 0; i < ends.size(); i += step) CheckEnd(ends[i]);
  }

  void CheckEnd(Point end) {
    const auto place = planner_.space().Locate(end);
    const Socket& socket = *result_.socket;
    auto path = place ? FindShortestOnward(planner_.space(), Walk(socket.exit), *place) : std::nullopt;
    if (!path) return Fault("an arc lies where no tether comes");
    if (socket.stub_length > 0) {
      path->points.insert(path->points.begin(), socket.base);
      path = planner_.space().MakePath(std::move(path->points));
    }
    if (std::fabs(path->length - tether_.length) > kTolerance * tether_.length) {
      Fault("an arc is not where the tether ends");
    }
    CheckCurve(*path);
  }

  void CheckSheets(const SheetList& list) {
    if (!list.complete) return;
    double sum = 0;
    for (const Sheet& sheet : list.sheets) {
      sum += sheet.area;
      CheckRings(sheet.rings, sheet.area, "a sheet");
    }
    if (list.area < result_.area - area_tolerance()) Fault("the sheets are smaller than the region");
    // Each may be off by what a strip too narrow to count may hold.
    if (std::fabs(sum - list.area) > kTolerance * list.area) Fault("the areas of the sheets do not sum up");
  }

  const TetherPlanner& planner_;
  const Tether& tether_;
  const ReachResult& result_;
  Verification verification_;
};

}  // namespace

Verification VerifyReach(const TetherPlanner& planner, const Tether& tether, const ReachResult& result) {
  return ReachCheck(planner, tether, result).Run();
}

}  // namespace tautline
