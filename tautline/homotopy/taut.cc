#include "tautline/homotopy/taut.h"

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The funnel: two inward-convex chains from a common apex to the two ends of the current portal. They share one
/// array: chain_[left_] .. chain_[apex_] is the left chain from its tip, chain_[apex_] .. chain_[right_] the right one.
class Funnel {
 public:
  Funnel(TautPoint start, std::size_t portals)
      : chain_(2 * portals + 5), apex_(portals + 2), left_(apex_), right_(apex_) {
    chain_[apex_] = start;
    path_.push_back(start);
  }

  void AddRight(TautPoint p) {
    while (right_ > apex_ && Orientation(chain_[right_ - 1].point, chain_[right_].point, p.point) >= 0) --right_;
    if (right_ == apex_) {
      while (left_ < apex_ && Orientation(chain_[apex_].point, chain_[apex_ - 1].point, p.point) > 0) {
        path_.push_back(chain_[--apex_]);
      }
      right_ = apex_;
    }
    chain_[++right_] = p;
  }

  void AddLeft(TautPoint p) {
    while (left_ < apex_ && Orientation(chain_[left_ + 1].point, chain_[left_].point, p.point) <= 0) ++left_;
    if (left_ == apex_) {
      while (right_ > apex_ && Orientation(chain_[apex_].point, chain_[apex_ + 1].point, p.point) < 0) {
        path_.push_back(chain_[++apex_]);
      }
      left_ = apex_;
    }
    chain_[--left_] = p;
  }

  /// The taut points from the start to `end`.
  std::vector<TautPoint> Finish(TautPoint end) {
    AddRight(end);
    path_.insert(path_.end(), chain_.begin() + static_cast<std::ptrdiff_t>(apex_) + 1,
                 chain_.begin() + static_cast<std::ptrdiff_t>(right_) + 1);
    return std::move(path_);
  }

 private:
  std::vector<TautPoint> chain_;
  std::size_t apex_, left_, right_;
  std::vector<TautPoint> path_;
};

/// Without repeated points and straight turns, which arise where the curve starts or ends on a vertex or grazes one.
std::vector<TautPoint> DropStraight(const std::vector<TautPoint>& points) {
  std::vector<TautPoint> kept;
  for (const TautPoint& p : points) {
    if (!kept.empty() && kept.back().point == p.point) {
      if (kept.size() > 1) kept.back() = p;
      continue;
    }
    while (kept.size() >= 2 && Orientation(kept[kept.size() - 2].point, kept.back().point, p.point) == 0) {
      kept.pop_back();
    }
    kept.push_back(p);
  }
  return kept;
}

}  // namespace

TautCurve PullTaut(const FreeMesh& mesh, const Walk& walk) {
  const auto sleeve = walk.sleeve.triangles();
  Funnel funnel({walk.from, {}}, sleeve.size());
  VertexId left, right;
  for (std::size_t k = 0; k + 1 < sleeve.size(); ++k) {
    const Triangle& here = mesh.triangle(sleeve[k]);
    const int i = here.IndexOf(sleeve[k + 1]);
    // Leaving across the side from Next(i) to Previous(i) with the triangle on its left: Next(i) is on the right.
    const VertexId new_right = here.vertex(Next(i));
    const VertexId new_left = here.vertex(Previous(i));
    if (new_right != right) funnel.AddRight({mesh.point(new_right), new_right});
    if (new_left != left) funnel.AddLeft({mesh.point(new_left), new_left});
    right = new_right;
    left = new_left;
  }
  TautCurve curve;
  curve.points = DropStraight(funnel.Finish({walk.at, {}}));
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    curve.length += Distance(curve.points[i - 1].point, curve.points[i].point);
  }
  return curve;
}

}  // namespace tautline
