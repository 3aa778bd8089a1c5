// Taut curves between anchors, each class once: what a search for boundaries asks about them over and over.
#ifndef TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_
#define TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tautline/base/index.h"
#include "tautline/planners/cable_workspace/cable_ground.h"

namespace tautline {

/// A class of curves from one anchor to another.
using CurveId = Index<struct CurveTag>;

/// The classes that were met so far. A class is known by its walk, which is one for each class, since walks end in the
/// triangles of the anchors' exits. Answers about pairs are computed once.
class AnchorCurves {
 public:
  /// Keeps the ground by reference.
  explicit AnchorCurves(const CableGround& ground) : ground_(ground) {}

  /// The curve of a walk from the exit of an anchor to that of another. O(triangles) expected.
  CurveId Add(Walk walk);

  /// Its class.
  const Walk& walk(CurveId id) const { return curves_[id.index()].walk; }
  /// Metres from exit to exit, without stubs.
  double length(CurveId id) const { return curves_[id.index()].length; }
  /// Whether it crosses itself.
  bool CrossesItself(CurveId id) { return Cross(id, id); }
  /// Whether the two cross (see CablesCross).
  bool Cross(CurveId a, CurveId b);
  /// How many there are.
  std::size_t size() const { return curves_.size(); }

 private:
  struct Curve {
    Walk walk;
    double length;
  };

  const CableGround& ground_;
  std::vector<Curve> curves_;
  std::unordered_multimap<std::uint64_t, CurveId> by_hash_;
  std::unordered_map<std::uint64_t, bool> crossings_;  ///< By the smaller id and the larger one.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CABLE_WORKSPACE_ANCHOR_CURVES_H_
