#include "tautline/draw/obstacle_names.h"

#include <algorithm>
#include <map>

#include "tautline/draw/line_style.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kNameSize = 12;
constexpr double kSmallNameSize = 10.5;
constexpr double kLongestName = 150;  // Pixels.
constexpr std::size_t kMostNeeded = 150;

using RingsByIsland = std::map<ObstacleId, std::vector<Ring>>;

/// The boundaries of the chosen islands, pixels.
RingsByIsland CollectRings(const FreeSpace& space, const View& view, const std::set<ObstacleId>& chosen) {
  RingsByIsland rings;
  const auto add = [&](const BoundaryRing& ring) {
    if (chosen.contains(ring.obstacle)) rings[ring.obstacle].push_back(view.ToPixels(ring.points));
  };
  for (const FreeComponent& component : space.components) {
    add(component.outer);
    for (const BoundaryRing& hole : component.holes) add(hole);
  }
  return rings;
}

/// The needed islands and those others that may be named, largest first within both.
std::vector<ObstacleId> ChooseIslands(const FreeSpace& space, const std::set<ObstacleId>& needed) {
  std::vector<ObstacleId> order;
  for (std::size_t i = 0; i < space.islands.size(); ++i) order.emplace_back(i);
  std::stable_sort(order.begin(), order.end(), [&](ObstacleId a, ObstacleId b) {
    if (needed.contains(a) != needed.contains(b)) return needed.contains(a);
    return space.islands[a.index()].area > space.islands[b.index()].area;
  });
  const std::size_t least = std::min(needed.size(), kMostNeeded);
  if (order.size() > kMostNamedIslands) order.resize(std::min(order.size(), least + kLargestNamed));
  return order;
}

/// Whether the box lies inside of the ground between the rings (even-odd).
bool FitsInside(const std::vector<Ring>& rings, const Box& box) {
  int inside = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (Meets(box, ring[i], ring[(i + 1) % ring.size()])) return false;
    }
    inside += WindingNumber(ring, box.centre()).number != 0 ? 1 : 0;
  }
  return inside % 2 == 1;
}

/// Where in an island a name may stand: its representative point first, then a lattice from the
/// middle outwards.
std::vector<Point> CandidatesInside(const Box& box, Point representative) {
  constexpr int kSteps = 4;
  std::vector<Point> points;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      points.push_back(box.centre() +
                       Point{0.5 * i / (kSteps + 1) * box.size().x, 0.5 * j / (kSteps + 1) * box.size().y});
    }
  }
  std::stable_sort(points.begin(), points.end(),
                   [&](Point a, Point b) { return Distance(a, box.centre()) < Distance(b, box.centre()); });
  points.insert(points.begin(), representative);
  return points;
}

/// Room for the name inside of the island; cost 1e300 when it fits nowhere.
LabelPlacer::Place FindInside(const std::vector<Ring>& rings, Point representative, Point size,
                              const LabelPlacer& placer) {
  Box bounds;
  for (const Ring& ring : rings) {
    for (const Point p : ring) bounds.Add(p);
  }
  std::vector<Point> centres;
  if (bounds.size().x > size.x && bounds.size().y > size.y) {
    for (const Point centre : CandidatesInside(bounds, representative)) {
      if (FitsInside(rings, {centre - 0.5 * size, centre + 0.5 * size})) centres.push_back(centre);
    }
  }
  return placer.FindAt(centres, size);
}

Box BoundsOf(const std::vector<Ring>& rings, Point fallback) {
  Box bounds;
  bounds.Add(fallback);
  for (const Ring& ring : rings) {
    for (const Point p : ring) bounds.Add(p);
  }
  return bounds;
}

SvgText NameAt(const Box& box, const std::string& name, double size, bool inside) {
  return {.at = {box.centre().x, box.centre().y + 0.36 * size},
          .text = name,
          .size = size,
          .anchor = TextAnchor::kMiddle,
          .italic = !inside,
          .halo = inside ? kBlockedHaloColour : kHaloColour};
}

}  // namespace

std::vector<SvgText> PlaceObstacleNames(const FreeSpace& space, const View& view, const std::set<ObstacleId>& needed,
                                        LabelPlacer& placer) {
  std::vector<SvgText> names;
  const std::vector<ObstacleId> order = ChooseIslands(space, needed);
  const RingsByIsland rings = CollectRings(space, view, {order.begin(), order.end()});
  const std::vector<Ring> none;
  const auto rings_of = [&](ObstacleId id) -> const std::vector<Ring>& {
    const auto found = rings.find(id);
    return found == rings.end() ? none : found->second;
  };
  for (const ObstacleId id : order) {
    const Island& island = space.islands[id.index()];
    const Point representative = view.ToPixels(island.representative);
    const std::string name = Ellipsize(island.name, kNameSize, kLongestName);
    Point size{TextWidth(name, kNameSize) + 2, kNameSize + 2};
    LabelPlacer::Place place = FindInside(rings_of(id), representative, size, placer);
    const bool inside = place.cost < LabelPlacer::kOverlap;
    const double font = inside ? kNameSize : kSmallNameSize;
    if (!inside) {
      size = {TextWidth(name, font) + 2, font + 1};
      place = placer.FindBeside(BoundsOf(rings_of(id), representative), size);
      if (place.cost >= LabelPlacer::kCrossing && !needed.contains(id)) continue;
    }
    placer.Take(place.box);
    names.push_back(NameAt(place.box, name, font, inside));
  }
  return names;
}

std::set<ObstacleId> IslandsOf(const Word& word) {
  std::set<ObstacleId> islands;
  for (const Letter letter : word.letters()) islands.insert(letter.obstacle);
  return islands;
}

}  // namespace tautline
