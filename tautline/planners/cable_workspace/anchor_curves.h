// Taut curves between anchors, each class once: what a search for boundaries asks about them over and over.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tautline/base/index.h"
#include "tautline/planners/cable_workspace/cable_ground.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {

/// A class of curves from one anchor to another.
using CurveId = Index<struct CurveTag>;

/// The classes that were met so far. A class is known by its walk, which is one for each class, since walks end in the
/// triangles of the anchors' exits.
class AnchorCurves {
 public:
  /// Keeps the ground by reference.
  explicit AnchorCurves(const CableGround& ground) : ground_(ground), slots_(64, -1) {}

  /// The curve of a walk from the exit of an anchor to that of another, with its refund (see RayTolls), metres.
  /// O(triangles) expected.
  CurveId Add(Walk walk, double refund);

  /// The same curve from its end to its start. O(triangles) expected the first time.
  CurveId Reverse(CurveId id);

  /// The curve of one and then another, unless it is longer than that, metres. O(triangles) expected. Requires that the
  /// second starts where the first ends.
  std::optional<CurveId> AddJoined(CurveId first, CurveId second, double longest);

  /// The curve of one and then another, if it was met before. O(triangles that cancel) expected, unless it was.
  std::optional<CurveId> FindJoined(CurveId first, CurveId second) const;

  /// Its class.
  const Walk& walk(CurveId id) const { return curves_[id.index()].walk; }
  /// Metres from exit to exit, without stubs.
  double length(CurveId id) const { return curves_[id.index()].length; }

  /// What its length costs less, metres.
  double refund(CurveId id) const { return curves_[id.index()].refund; }
  /// Its length less its refund, metres.
  double cost(CurveId id) const { return length(id) - refund(id); }

  /// Whether it crosses itself. Remembered.
  bool CrossesItself(CurveId id);
  /// Whether the two cross (see CablesCross). For pairs that are asked about once.
  bool Cross(CurveId a, CurveId b) { return CablesCross(SpotsOf(a), SpotsOf(b)); }
  /// The same, remembered.
  bool CrossAgain(CurveId a, CurveId b);

 private:
  struct Curve {
    Walk walk;
    double length;
    double refund;
    std::vector<std::uint64_t> hashes;            ///< Of the first triangles of the walk, one more each time.
    std::unique_ptr<const WalkSpots> spots = {};  ///< Made when a crossing is asked for.
    std::optional<bool> crosses_itself = {};
    CurveId reverse = {};
  };

  template <class IsSame>
  std::optional<CurveId> Find(std::uint64_t hash, IsSame is_same) const;
  CurveId Append(Curve curve);
  void EnterSlot(CurveId id);
  const WalkSpots& SpotsOf(CurveId id);

  const CableGround& ground_;
  std::vector<Curve> curves_;
  std::vector<std::int32_t> slots_;       ///< A hash table of curves with open addressing; -1 where it is empty.
  std::vector<std::uint64_t> powers_{1};  ///< Of the base of the hashes.
  std::unordered_map<std::uint64_t, bool> crossings_;  ///< By the smaller id and the larger one.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_
