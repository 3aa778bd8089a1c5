#include "tautline/homotopy/taut_ground.h"

#include <utility>

namespace tautline {

Expected<TautGround> TautGround::Prepare(const World& world, const Watcher& watch) {
  try {
    if (watch && !watch("free space", 0)) throw Stopped();
    auto space = BuildFreeSpace(world);
    if (!space) return tl::unexpected(space.error());
    std::optional<FreeSpace> without_clearance;
    if (space->clearance > 0) {
      auto ungrown = BuildFreeSpace(world, {.clearance = 0});
      if (!ungrown) return tl::unexpected(ungrown.error());
      without_clearance = *std::move(ungrown);
    }
    return TautGround(std::make_unique<const TautSpace>(*std::move(space), watch), std::move(without_clearance));
  } catch (const Stopped&) {
    return tl::unexpected<Error>(Error{ErrorCode::kStopped, "stopped while the world was prepared", ""});
  }
}

TautGround::TautGround(std::unique_ptr<const TautSpace> space, std::optional<FreeSpace> ungrown)
    : space_(std::move(space)) {
  if (ungrown) ungrown_ = std::make_unique<const Ungrown>(*std::move(ungrown));
}

}  // namespace tautline
