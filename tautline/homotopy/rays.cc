#include "tautline/homotopy/rays.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "tautline/geometry/predicates.h"

namespace tautline {

namespace {

std::vector<Point> RepresentativesOf(const FreeSpace& space) {
  std::vector<Point> points;
  for (const Island& island : space.islands) points.push_back(island.representative);
  return points;
}

}  // namespace

Rays::Rays(const FreeSpace& space) : Rays(RepresentativesOf(space), NamesOf(space)) {}

Rays::Rays(std::span<const Point> origins, std::vector<std::string> names) : names_(std::move(names)) {
  for (std::size_t i = 0; i < origins.size(); ++i) by_x_.push_back({origins[i], ObstacleId(i)});
  std::sort(by_x_.begin(), by_x_.end(), [](const Ray& a, const Ray& b) {
    return std::tie(a.origin.x, a.obstacle) < std::tie(b.origin.x, b.obstacle);
  });
}

template <class Visit>
void Rays::ForEachCrossing(std::span<const Point> polyline, Visit visit) const {
  // Rays with left < x <= right lie between the two ends of a segment: an end exactly on a ray's column is to its
  // right.
  const auto after = [](double x, const Ray& ray) { return x < ray.origin.x; };
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Point p = polyline[i - 1], q = polyline[i];
    const auto begin = std::upper_bound(by_x_.begin(), by_x_.end(), std::min(p.x, q.x), after);
    const auto end = std::upper_bound(begin, by_x_.end(), std::max(p.x, q.x), after);
    if (p.x < q.x) {
      for (auto ray = begin; ray != end; ++ray) {
        if (Orientation(p, q, ray->origin) < 0) visit(Letter{ray->obstacle, false});
      }
    } else {
      for (auto ray = end; ray != begin;) {
        --ray;
        if (Orientation(q, p, ray->origin) < 0) visit(Letter{ray->obstacle, true});
      }
    }
  }
}

Word Rays::WordOf(std::span<const Point> polyline) const {
  Word word;
  ForEachCrossing(polyline, [&word](Letter letter) { word.Append(letter); });
  return word;
}

std::vector<int> Rays::HomologyOf(std::span<const Point> polyline) const {
  std::vector<int> sums(names_.size(), 0);
  ForEachCrossing(polyline, [&sums](Letter letter) { sums[letter.obstacle.index()] += letter.inverse ? -1 : 1; });
  return sums;
}

std::vector<int> Abelianize(const Word& word, std::size_t islands) {
  std::vector<int> sums(islands, 0);
  for (const Letter letter : word.letters()) sums[letter.obstacle.index()] += letter.inverse ? -1 : 1;
  return sums;
}

}  // namespace tautline
