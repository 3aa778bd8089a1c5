#include "tautline/planners/cable_workspace/futures.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "tautline/base/check.h"
#include "tautline/scene/check_world.h"

namespace tautline {

Expected<Futures> Futures::Prepare(const World& world, std::span<const Point> anchors, std::span<const Future> futures,
                                   const Watcher& watch) {
  if (const auto checked = CheckWorld(world); !checked) return tl::unexpected(checked.error());
  Futures prepared;
  prepared.points_.assign(anchors.begin(), anchors.end());
  for (std::size_t i = 0; i < futures.size(); ++i) {
    Watcher part;
    if (watch) {
      part = [&watch, i, count = futures.size()](std::string_view stage, double share) {
        return watch(stage, (static_cast<double>(i) + share) / static_cast<double>(count));
      };
    }
    auto future = FutureGround::Prepare(world, anchors, futures[i], i, part);
    if (!future) return tl::unexpected(future.error());
    prepared.futures_.push_back(std::make_unique<const FutureGround>(*std::move(future)));
  }
  return prepared;
}

FutureOutcomes Futures::Carry(const CableGround& ground, const Anchors& anchors,
                              const WorkspaceBoundary& boundary) const {
  return BoundaryCarrier(*this, ground, anchors).Carry(boundary);
}

BoundaryCarrier::BoundaryCarrier(const Futures& futures, const CableGround& ground, const Anchors& anchors)
    : futures_(futures), ground_(ground), anchors_(anchors), carried_(futures.size()) {
  TAUTLINE_CHECK(anchors.size() == futures.points().size());
  for (std::size_t i = 0; i < futures.size(); ++i) blocked_now_.push_back(futures.future(i).BlockedOn(ground));
}

const BoundaryCarrier::Carried& BoundaryCarrier::CarrySide(std::size_t future, std::size_t side, const TautPath& path) {
  auto& carried = carried_[future];
  const std::pair<std::size_t, Word> key(side, path.word);
  const auto known = carried.find(key);
  if (known != carried.end()) return known->second;
  const FutureGround& there = futures_.future(future);
  return carried.emplace(key, there.CarrySide(side, anchors_, path, blocked_now_[future])).first->second;
}

tl::expected<WorkspaceBoundary, BoundaryFault> BoundaryCarrier::CarryBoundary(std::size_t future,
                                                                              const WorkspaceBoundary& boundary) {
  const FutureGround& there = futures_.future(future);
  if (!there.anchors()) {
    const AnchorFault& blocked = there.anchors().error();
    return tl::unexpected(
        BoundaryFault{.obstruction = WorkspaceObstruction::kAnchorBlocked,
                      .sides = {blocked.anchor},
                      .at = futures_.points()[blocked.anchor],
                      .explanation = "anchor " + std::to_string(blocked.anchor + 1) + " " + blocked.text});
  }
  std::vector<Walk> walks;
  std::vector<TautPath> paths;
  std::optional<BoundaryFault> fault;
  for (std::size_t i = 0; i < boundary.sides.size(); ++i) {
    const Carried& side = CarrySide(future, i, boundary.sides[i].path);
    if (side) {
      walks.push_back(side->walk);
      paths.push_back(side->path);
    } else if (!fault) {
      fault = side.error();
    }
  }
  if (!fault) return CloseBoundary(there.ground(), *there.anchors(), std::move(walks), std::move(paths));
  fault->curves = std::move(paths);
  return tl::unexpected(*std::move(fault));
}

FutureOutcomes BoundaryCarrier::Carry(const WorkspaceBoundary& boundary, const CarryOptions& options) {
  TAUTLINE_CHECK(boundary.sides.size() == anchors_.size());
  FutureOutcomes all;
  const auto lengthen = [&all](const std::vector<LongestCable>& longest) {
    all.longest_cables.resize(longest.size(), 0);
    for (std::size_t i = 0; i < longest.size(); ++i) {
      all.longest_cables[i] = std::max(all.longest_cables[i], longest[i].length);
    }
  };
  if (options.longest_cables) lengthen(LongestCables(ground_, anchors_, boundary));
  for (std::size_t i = 0; i < futures_.size(); ++i) {
    const FutureGround& there = futures_.future(i);
    FutureOutcome outcome{there.probability(), CarryBoundary(i, boundary), {}};
    if (!outcome.boundary) {
      all.lost_probability += outcome.probability;
    } else {
      all.expected_area += outcome.probability * outcome.boundary->area;
      if (options.longest_cables) {
        outcome.longest = LongestCables(there.ground(), *there.anchors(), *outcome.boundary);
        lengthen(outcome.longest);
      }
    }
    all.outcomes.push_back(std::move(outcome));
  }
  return all;
}

}  // namespace tautline
