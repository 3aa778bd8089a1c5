// A world prepared for taut curves, with its clearance and without.
#ifndef TAUTLINE_HOMOTOPY_TAUT_GROUND_H_
#define TAUTLINE_HOMOTOPY_TAUT_GROUND_H_

#include <memory>
#include <optional>

#include "tautline/base/error.h"
#include "tautline/base/stop.h"
#include "tautline/homotopy/taut_space.h"
#include "tautline/scene/scene.h"

namespace tautline {

/// The free space of a world, prepared for taut curves. Immutable; queries may run in several threads.
class TautGround {
 public:
  /// Builds both free spaces. Errors: as BuildFreeSpace; kStopped when `watch` said stop. Cost: as TautSpace.
  [[nodiscard]] static Expected<TautGround> Prepare(const World& world, const Watcher& watch = {});

  /// From what was built before: `ungrown` is there exactly where `space` has a clearance.
  TautGround(std::unique_ptr<const TautSpace> space, std::optional<FreeSpace> ungrown);

  /// The free space with clearance.
  const TautSpace& space() const { return *space_; }
  /// Whether there is a clearance.
  bool has_clearance() const { return ungrown_ != nullptr; }
  /// The free space without clearance; that of `space` where there is none.
  const FreeSpace& ungrown_space() const { return ungrown_ ? ungrown_->space : space_->free_space(); }
  /// Its mesh: what a socket's stub may cross.
  const FreeMesh& ungrown() const { return ungrown_ ? ungrown_->mesh : space_->mesh(); }

 private:
  struct Ungrown {
    explicit Ungrown(FreeSpace free_space) : space(std::move(free_space)), mesh(space) {}

    FreeSpace space;
    FreeMesh mesh;
  };

  std::unique_ptr<const TautSpace> space_;
  std::unique_ptr<const Ungrown> ungrown_;
};

}  // namespace tautline

#endif  // TAUTLINE_HOMOTOPY_TAUT_GROUND_H_
