#include "tautline/planners/cable_workspace/placement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/planners/cable_workspace/best.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

/// See DefaultMaxBoundary.
constexpr double kLimitPerOutline = 1.25;
constexpr double kLimitPerStub = 4;

/// Sums of the same lengths in another order differ by less than this share.
constexpr double kLengthSlack = 1e-9;

std::optional<std::size_t> ComponentOfTasks(const FreeSpace& space, std::span<const Point> tasks) {
  return tasks.empty() ? std::nullopt : ComponentOf(space, tasks[0], BoundaryTolerance(space));
}

/// Positions are to mean the same whichever corner the free space starts with.
Ring FromFirstCorner(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

/// What no cable can undercut: each anchor's cable reaches its neighbours.
double LowestCable(const Placement& at, const WorkspaceBoundary& boundary) {
  const std::size_t n = at.anchors.size();
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = NextAnchor(i, n), before = i == 0 ? n - 1 : i - 1;
    const double ahead = boundary.sides[i].path.length + at.anchors[next].stub_length;
    const double behind = boundary.sides[before].path.length + at.anchors[before].stub_length;
    sum += at.anchors[i].stub_length + std::max(ahead, behind);
  }
  return sum;
}

std::vector<double> LengthsOf(const std::vector<LongestCable>& cables) {
  std::vector<double> lengths;
  lengths.reserve(cables.size());
  for (const LongestCable& cable : cables) lengths.push_back(cable.length);
  return lengths;
}

double Sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

std::optional<Error> FaultOf(const PlacementOptions& options) {
  if (options.anchors < 3) {
    return Error{ErrorCode::kInvalidInput,
                 std::to_string(options.anchors) + " anchors hold no area between their cables: give 3 or more",
                 "anchors"};
  }
  if (options.objective == PlaceObjective::kCable && options.tasks.empty()) {
    return Error{ErrorCode::kInvalidInput,
                 "without tasks the least cable is none at all: give the scene `tasks`, or maximise the area", "tasks"};
  }
  if (options.max_boundary && !(*options.max_boundary > 0 && std::isfinite(*options.max_boundary))) {
    return Error{ErrorCode::kInvalidInput, "the longest boundary must be a positive number of metres", "max_boundary"};
  }
  return std::nullopt;
}

}  // namespace

double DefaultMaxBoundary(const OutlineWalk& outline, std::size_t anchors, double clearance) {
  return kLimitPerOutline * outline.length() + kLimitPerStub * clearance * static_cast<double>(anchors);
}

double DistanceToTask(const CableGround& ground, const WorkspaceBoundary& boundary, Point task) {
  const Winding winding = WindingNumber(boundary.ring, task);
  if (winding.number != 0 || winding.on_boundary) return 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < boundary.ring.size(); ++i) {
    const Point from = boundary.ring[i], to = boundary.ring[(i + 1) % boundary.ring.size()];
    distance = std::min(distance, DistanceToSegment(task, from, to));
  }
  return distance <= ground.space().tolerance() ? 0 : distance;
}

Expected<PlacementGround> PlacementGround::Prepare(const World& world, const PlacementOptions& options,
                                                   const Watcher& watch) {
  if (const auto fault = FaultOf(options)) return tl::unexpected(*fault);
  auto ground = CableGround::Prepare(world, watch);
  if (!ground) return tl::unexpected(ground.error());
  if (!options.futures.empty()) {
    // What is wrong with the futures themselves shows without any anchors.
    const auto futures = Futures::Prepare(world, {}, options.futures, watch);
    if (!futures) return tl::unexpected(futures.error());
  }
  const FreeSpace& space = ground->ungrown_space();
  OutlineWalk outline(
      FromFirstCorner(space.components[ComponentOfTasks(space, options.tasks).value_or(0)].outer.points));
  return PlacementGround(*std::move(ground), std::move(outline), world, options);
}

PlacementGround::PlacementGround(CableGround ground, OutlineWalk outline, const World& world, PlacementOptions options)
    : ground_(std::move(ground)), outline_(std::move(outline)), world_(world), options_(std::move(options)) {
  if (!options_.max_boundary) {
    options_.max_boundary = DefaultMaxBoundary(outline_, options_.anchors, ground_.space().free_space().clearance);
  }
  lost_task_ = FindLostTask();
}

std::optional<std::size_t> PlacementGround::FindLostTask() const {
  std::optional<Place> first;
  for (std::size_t i = 0; i < options_.tasks.size(); ++i) {
    const auto place = ground_.space().Locate(options_.tasks[i]);
    if (!place || (first && !ground_.space().mesh().Connected(*first, *place))) return i;
    if (!first) first = place;
  }
  return std::nullopt;
}

bool PlacementGround::IsBetter(const PlacementWorth& a, const PlacementWorth& b) const {
  if (a.outside != b.outside) return a.outside < b.outside;
  const bool least = options_.objective == PlaceObjective::kCable && a.holds_all();
  return least ? a.value < b.value : a.value > b.value;
}

PlacementAnswer PlacementGround::Evaluate(std::vector<double> positions,
                                          const std::optional<PlacementWorth>& to_beat) const {
  TAUTLINE_CHECK(positions.size() == options_.anchors);
  for (double& position : positions) position = outline_.Wrapped(position);
  std::sort(positions.begin(), positions.end());
  std::vector<Point> points;
  points.reserve(positions.size());
  for (const double position : positions) points.push_back(outline_.At(position));
  auto anchors = PlaceAnchors(ground_, points);
  if (!anchors) return {};
  std::optional<Futures> futures;
  if (!options_.futures.empty()) {
    auto prepared = Futures::Prepare(world_, points, options_.futures);
    if (!prepared) return {};  // An obstacle moves exactly through an anchor.
    futures = *std::move(prepared);
  }
  const Placement at{.positions = std::move(positions), .anchors = *std::move(anchors)};
  BoundaryList list =
      FindBoundaries(ground_, at.anchors, {.max_boundary = LimitToBeat(to_beat), .budget = options_.budget});
  PlacementAnswer answer{.placement = {}, .complete = list.complete};
  Boundaries holding = TakeHolding(list.boundaries);
  if (options_.objective == PlaceObjective::kCable) {
    answer.placement = LeastCable(at, std::move(holding), futures ? &*futures : nullptr);
  } else if (futures) {
    answer.placement = LargestExpected(at, std::move(holding), *futures);
  } else {
    answer.placement = Largest(at, std::move(holding));
  }
  if (!answer.placement) answer.placement = Nearest(at, std::move(list.boundaries));
  return answer;
}

/// The greatest length of a boundary that may be better: its cables together are no shorter than it, since each reaches
/// both neighbours.
double PlacementGround::LimitToBeat(const std::optional<PlacementWorth>& to_beat) const {
  if (options_.objective != PlaceObjective::kCable || !to_beat || !to_beat->holds_all()) return max_boundary();
  return std::min(max_boundary(), (1 + kLengthSlack) * to_beat->value);
}

double PlacementGround::Outside(const WorkspaceBoundary& boundary) const {
  double sum = 0;
  for (const Point task : options_.tasks) sum += DistanceToTask(ground_, boundary, task);
  return sum;
}

/// Takes out the boundaries that hold all tasks; the others stay. Both keep their order.
PlacementGround::Boundaries PlacementGround::TakeHolding(Boundaries& boundaries) const {
  const auto outside = std::stable_partition(boundaries.begin(), boundaries.end(),
                                             [this](const WorkspaceBoundary& b) { return Outside(b) == 0; });
  Boundaries holding(std::make_move_iterator(boundaries.begin()), std::make_move_iterator(outside));
  boundaries.erase(boundaries.begin(), outside);
  return holding;
}

std::optional<Placement> PlacementGround::Largest(Placement at, Boundaries boundaries) const {
  if (boundaries.empty()) return std::nullopt;
  at.worth = {0, boundaries[0].area};
  at.boundary = std::move(boundaries[0]);
  return at;
}

std::optional<Placement> PlacementGround::LargestExpected(Placement at, Boundaries boundaries,
                                                          const Futures& futures) const {
  BoundaryCarrier carrier(futures, ground_, at.anchors);
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const double expected = carrier.Carry(boundaries[i], {.longest_cables = false}).expected_area;
    if (best && expected <= at.worth.value) continue;
    best = i;
    at.worth = {0, expected};
  }
  if (!best) return std::nullopt;
  at.boundary = std::move(boundaries[*best]);
  return at;
}

std::optional<Placement> PlacementGround::LeastCable(Placement at, Boundaries boundaries,
                                                     const Futures* futures) const {
  std::optional<BoundaryCarrier> carrier;
  if (futures != nullptr) carrier.emplace(*futures, ground_, at.anchors);
  std::vector<std::pair<double, std::size_t>> by_lowest;
  for (std::size_t i = 0; i < boundaries.size(); ++i) by_lowest.emplace_back(LowestCable(at, boundaries[i]), i);
  std::sort(by_lowest.begin(), by_lowest.end());
  std::optional<std::size_t> best;
  for (const auto& [lowest, i] : by_lowest) {
    if (best && lowest >= at.worth.value) break;
    double cable = 0;
    if (carrier) {
      const FutureOutcomes outcomes = carrier->Carry(boundaries[i]);
      // Nobody knows how much cable a workspace takes that is no more.
      if (outcomes.lost_probability > 0) continue;
      cable = Sum(outcomes.longest_cables);
    } else {
      cable = Sum(LengthsOf(LongestCables(ground_, at.anchors, boundaries[i])));
    }
    if (best && cable >= at.worth.value) continue;
    best = i;
    at.worth = {0, cable};
  }
  if (!best) return std::nullopt;
  at.boundary = std::move(boundaries[*best]);
  return at;
}

/// Of boundaries that do not hold all tasks.
std::optional<Placement> PlacementGround::Nearest(Placement at, Boundaries boundaries) const {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < boundaries.size(); ++i) {
    const PlacementWorth worth{Outside(boundaries[i]), boundaries[i].area};
    if (nearest && !IsBetter(worth, at.worth)) continue;
    nearest = i;
    at.worth = worth;
  }
  if (!nearest) return std::nullopt;
  at.boundary = std::move(boundaries[*nearest]);
  return at;
}

PlacementDetails PlacementGround::DetailsOf(const Placement& placement) const {
  PlacementDetails details;
  for (const Point task : options_.tasks) {
    if (DistanceToTask(ground_, placement.boundary, task) == 0) ++details.tasks_held;
  }
  if (options_.futures.empty()) {
    details.longest_cables = LengthsOf(LongestCables(ground_, placement.anchors, placement.boundary));
    return details;
  }
  std::vector<Point> points;
  for (const Socket& anchor : placement.anchors) points.push_back(anchor.base);
  const auto futures = Futures::Prepare(world_, points, options_.futures);
  TAUTLINE_CHECK(futures.has_value());
  details.futures = futures->Carry(ground_, placement.anchors, placement.boundary);
  details.longest_cables = details.futures->longest_cables;
  return details;
}

}  // namespace tautline
