#include "tautline/homotopy/taut_space.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {

TautSpace::TautSpace(FreeSpace space, const Watcher& watch)
    : space_(std::move(space)),
      mesh_(space_),
      corners_(space_, mesh_),
      graph_(corners_, SeeFromAllCorners(mesh_, corners_, watch)),
      rays_(space_),
      tolerance_(BoundaryTolerance(space_)) {}

TautSpace::TautSpace(FreeSpace space, const SightList& sight)
    : space_(std::move(space)),
      mesh_(space_),
      corners_(space_, mesh_),
      graph_(corners_, sight),
      rays_(space_),
      tolerance_(BoundaryTolerance(space_)) {}

std::optional<Departure> TautSpace::Follow(std::span<const Point> polyline, std::optional<Walk>& walk) const {
  TAUTLINE_CHECK(!polyline.empty());
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    const auto place = Locate(polyline[i]);
    if (!place) return Departure{i == 0 ? 0 : i - 1, polyline[i]};
    if (!walk) {
      walk.emplace(*place);
      continue;
    }
    if (const auto blocked = WalkNearly(mesh_, place->point, tolerance_, *walk)) {
      return Departure{i == 0 ? 0 : i - 1, *blocked};
    }
  }
  return std::nullopt;
}

TautPath TautSpace::MakePath(Polyline points) const {
  TautPath path;
  path.length = Length(points);
  path.word = rays_.WordOf(points);
  path.points = std::move(points);
  return path;
}

TautPath TautSpace::Pull(const Walk& walk) const {
  Polyline points;
  for (const TautPoint& p : PullTaut(mesh_, walk).points) points.push_back(p.point);
  return MakePath(std::move(points));
}

Shortened Shorten(const TautSpace& space, std::span<const Point> polyline) {
  std::optional<Walk> walk;
  const auto departure = space.Follow(polyline, walk);
  if (departure) return {{}, departure};
  return {space.Pull(*walk), std::nullopt};
}

}  // namespace tautline
