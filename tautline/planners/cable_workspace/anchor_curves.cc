#include "tautline/planners/cable_workspace/anchor_curves.h"

#include <algorithm>
#include <utility>

#include "tautline/homotopy/taut.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

/// FNV-1a over the triangles, which tell the ends as well: an anchor's exit has a triangle, and curves between other
/// anchors that share both triangles are told apart by comparison.
std::uint64_t HashOf(const Walk& walk) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const TriangleId id : walk.sleeve.triangles()) {
    hash = (hash ^ static_cast<std::uint32_t>(id.value())) * 0x100000001b3ULL;
  }
  return hash;
}

bool SameClass(const Walk& a, const Walk& b) { return a.from == b.from && a.at == b.at && a.sleeve == b.sleeve; }

}  // namespace

CurveId AnchorCurves::Add(Walk walk) {
  const std::uint64_t hash = HashOf(walk);
  const auto [first, last] = by_hash_.equal_range(hash);
  for (auto it = first; it != last; ++it) {
    if (SameClass(curves_[it->second.index()].walk, walk)) return it->second;
  }
  const CurveId id(curves_.size());
  const double length = PullTaut(ground_.space().mesh(), walk).length;
  curves_.push_back({std::move(walk), length});
  by_hash_.emplace(hash, id);
  return id;
}

bool AnchorCurves::Cross(CurveId a, CurveId b) {
  const std::uint64_t low = std::min(a, b).index(), high = std::max(a, b).index();
  const auto [entry, is_new] = crossings_.try_emplace(low << 32 | high, false);
  if (is_new) entry->second = CablesCross(ground_.space(), walk(a), walk(b));
  return entry->second;
}

}  // namespace tautline
