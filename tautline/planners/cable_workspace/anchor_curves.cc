#include "tautline/planners/cable_workspace/anchor_curves.h"

#include <algorithm>
#include <utility>

#include "tautline/homotopy/taut.h"

namespace tautline {
namespace {

constexpr std::uint64_t kBase = 0x9e3779b97f4a7c15ULL;

/// The first n triangles as the digits of a number to the base kBase, modulo 2^64: so the hash of two parts one after
/// the other follows from theirs.
std::vector<std::uint64_t> HashesOf(const Walk& walk) {
  std::vector<std::uint64_t> hashes{0};
  hashes.reserve(walk.sleeve.size() + 1);
  for (const TriangleId id : walk.sleeve.triangles()) {
    const std::uint64_t digit = (static_cast<std::uint64_t>(id.value()) + 1) * 0xbf58476d1ce4e5b9ULL;
    hashes.push_back(hashes.back() * kBase + (digit ^ digit >> 31));
  }
  return hashes;
}

/// The table has a power of two of slots; the upper bits of the hash depend on all triangles.
std::size_t SlotOf(std::uint64_t hash, std::size_t slots) {
  return static_cast<std::size_t>((hash ^ hash >> 32) & (slots - 1));
}

bool SameClass(const Walk& a, const Walk& b) { return a.from == b.from && a.at == b.at && a.sleeve == b.sleeve; }

}  // namespace

template <class IsSame>
std::optional<CurveId> AnchorCurves::Find(std::uint64_t hash, IsSame is_same) const {
  for (std::size_t slot = SlotOf(hash, slots_.size()); slots_[slot] >= 0; slot = (slot + 1) & (slots_.size() - 1)) {
    const Curve& curve = curves_[static_cast<std::size_t>(slots_[slot])];
    if (curve.hashes.back() == hash && is_same(curve.walk)) return CurveId(slots_[slot]);
  }
  return std::nullopt;
}

void AnchorCurves::EnterSlot(CurveId id) {
  std::size_t slot = SlotOf(curves_[id.index()].hashes.back(), slots_.size());
  while (slots_[slot] >= 0) slot = (slot + 1) & (slots_.size() - 1);
  slots_[slot] = id.value();
}

CurveId AnchorCurves::Append(Curve curve) {
  while (powers_.size() < curve.hashes.size()) powers_.push_back(powers_.back() * kBase);
  const CurveId id(curves_.size());
  curves_.push_back(std::move(curve));
  if (2 * curves_.size() > slots_.size()) {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < curves_.size(); ++i) EnterSlot(CurveId(i));
  } else {
    EnterSlot(id);
  }
  return id;
}

CurveId AnchorCurves::Add(Walk walk, double refund) {
  auto hashes = HashesOf(walk);
  if (const auto known = Find(hashes.back(), [&](const Walk& other) { return SameClass(walk, other); })) return *known;
  const double length = PullTaut(ground_.space().mesh(), walk).length;
  return Append({std::move(walk), length, refund, std::move(hashes)});
}

CurveId AnchorCurves::Reverse(CurveId id) {
  if (!curves_[id.index()].reverse.valid()) {
    const CurveId reverse = Add(Reversed(walk(id)), -refund(id));
    curves_[id.index()].reverse = reverse;
    curves_[reverse.index()].reverse = id;
  }
  return curves_[id.index()].reverse;
}

std::optional<CurveId> AnchorCurves::AddJoined(CurveId first, CurveId second, double longest) {
  if (const auto known = FindJoined(first, second)) return known;
  Walk joined = Joined(ground_.space().mesh(), walk(first), walk(second));
  const double length = PullTaut(ground_.space().mesh(), joined).length;
  if (length > longest) return std::nullopt;
  auto hashes = HashesOf(joined);
  return Append({std::move(joined), length, refund(first) + refund(second), std::move(hashes)});
}

std::optional<CurveId> AnchorCurves::FindJoined(CurveId first, CurveId second) const {
  const Curve &a = curves_[first.index()], &b = curves_[second.index()];
  const auto before = a.walk.sleeve.triangles(), after = b.walk.sleeve.triangles();
  // The last triangle of one is the first of the other; more of them may cancel.
  std::size_t shared = 1;
  const std::size_t most = std::min(before.size(), after.size());
  while (shared < most && before[before.size() - 1 - shared] == after[shared]) ++shared;
  const std::size_t kept = before.size() - shared + 1, added = after.size() - shared;
  if (kept + added >= powers_.size()) return std::nullopt;
  const std::uint64_t tail = b.hashes.back() - b.hashes[shared] * powers_[added];
  return Find(a.hashes[kept] * powers_[added] + tail, [&](const Walk& walk) {
    const auto triangles = walk.sleeve.triangles();
    if (walk.from != a.walk.from || walk.at != b.walk.at || triangles.size() != kept + added) return false;
    const auto middle = triangles.begin() + static_cast<std::ptrdiff_t>(kept);
    return std::equal(triangles.begin(), middle, before.begin()) &&
           std::equal(middle, triangles.end(), after.begin() + static_cast<std::ptrdiff_t>(shared));
  });
}

const WalkSpots& AnchorCurves::SpotsOf(CurveId id) {
  Curve& curve = curves_[id.index()];
  if (!curve.spots) curve.spots = std::make_unique<const WalkSpots>(ground_.space(), curve.walk);
  return *curve.spots;
}

bool AnchorCurves::CrossesItself(CurveId id) {
  std::optional<bool>& known = curves_[id.index()].crosses_itself;
  if (!known) known = Cross(id, id);
  return *known;
}

bool AnchorCurves::CrossAgain(CurveId a, CurveId b) {
  const std::uint64_t low = std::min(a, b).index(), high = std::max(a, b).index();
  const auto [entry, is_new] = crossings_.try_emplace(low << 32 | high, false);
  if (is_new) entry->second = Cross(a, b);
  return entry->second;
}

}  // namespace tautline
