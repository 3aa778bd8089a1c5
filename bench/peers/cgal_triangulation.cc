#include "bench/peers/cgal_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace tautline {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::No_constraint_intersection_tag>;

}  // namespace

struct CgalInput::Data {
  std::vector<Kernel::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

struct CgalTriangulation::Data {
  Cdt cdt;
  Cdt::Face_handle last;
};

CgalInput::CgalInput(std::span<const Point> points, std::span<const InputEdge> edges) {
  auto data = std::make_unique<Data>();
  for (const Point p : points) data->points.emplace_back(p.x, p.y);
  for (const auto& [a, b] : edges) data->edges.emplace_back(a, b);
  data_ = std::move(data);
}

CgalInput::~CgalInput() = default;

CgalTriangulation::CgalTriangulation(const CgalInput& input) : data_(std::make_unique<Data>()) {
  const CgalInput::Data& in = *input.data_;
  data_->cdt.insert_constraints(in.points.begin(), in.points.end(), in.edges.begin(), in.edges.end());
}

CgalTriangulation::~CgalTriangulation() = default;

std::array<Point, 3> CgalTriangulation::Locate(Point p) {
  data_->last = data_->cdt.locate(Kernel::Point_2(p.x, p.y), data_->last);
  std::array<Point, 3> corners;
  for (int i = 0; i < 3; ++i) {
    const auto vertex = data_->last->vertex(i);
    corners[static_cast<std::size_t>(i)] = {vertex->point().x(), vertex->point().y()};
  }
  return corners;
}

}  // namespace tautline
