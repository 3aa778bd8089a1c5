// A peer: CGAL's constrained Delaunay triangulation and its point location.
#ifndef TAUTLINE_BENCH_PEERS_CGAL_TRIANGULATION_H_
#define TAUTLINE_BENCH_PEERS_CGAL_TRIANGULATION_H_

#include <array>
#include <memory>
#include <span>

#include "tautline/geometry/triangulation.h"

namespace tautline {

/// Input points as CGAL has them, so that copying is not counted.
class CgalInput {
 public:
  CgalInput(std::span<const Point> points, std::span<const InputEdge> edges);
  ~CgalInput();

 private:
  friend class CgalTriangulation;
  struct Data;
  std::unique_ptr<const Data> data_;
};

/// Exact predicates; points are inserted in spatial order, as CGAL does for ranges of constraints.
class CgalTriangulation {
 public:
  explicit CgalTriangulation(const CgalInput& input);
  ~CgalTriangulation();

  /// The corners of the triangle that holds p, by a walk from the triangle of the question before.
  std::array<Point, 3> Locate(Point p);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace tautline

#endif  // TAUTLINE_BENCH_PEERS_CGAL_TRIANGULATION_H_
