#include "tautline/geometry/triangulation.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/geometry/triangulation_builder.h"

namespace tautline {
namespace {

/// Triangles per cell of the locator.
constexpr double kTrianglesPerCell = 2;

}  // namespace

Triangulation Triangulation::Build(std::span<const Point> points, std::span<const InputEdge> edges) {
  Triangulation mesh;
  TriangulationBuilder builder(points, mesh);
  builder.InsertPoints();
  builder.InsertEdges(edges);
  mesh.BuildLocator();
  return mesh;
}

std::span<const VertexId> Triangulation::ChainOf(std::size_t edge) const {
  return std::span(chain_vertices_).subspan(chain_begin_[edge], chain_begin_[edge + 1] - chain_begin_[edge]);
}

TriangleId Triangulation::WalkTo(Point p, TriangleId from) const {
  // A visibility walk; which edge is tried first changes with the step, so that it cannot run in circles for ever.
  TriangleId at = from, before;
  std::uint32_t first = 0;
  for (;;) {
    const Triangle& here = triangle(at);
    TriangleId next;
    for (int k = 0; k < 3; ++k) {
      const int i = static_cast<int>((first + static_cast<std::uint32_t>(k)) % 3);
      const TriangleId across = here.neighbour(i);
      if (across == before || !across.valid()) continue;
      if (Orientation(corner(at, Next(i)), corner(at, Previous(i)), p) < 0) {
        next = across;
        break;
      }
    }
    if (!next.valid()) return at;
    before = at;
    at = next;
    first = first * 1664525U + 1013904223U;
  }
}

TriangleId Triangulation::Locate(Point p) const {
  TAUTLINE_CHECK(InFrame(p));
  const auto clamp = [](double value, int count) {
    return std::clamp(static_cast<int>(std::clamp(value, -1.0, 1e9)), 0, count - 1);
  };
  const int column = clamp((p.x - inner_low_.x) / cell_, columns_);
  const int row = clamp((p.y - inner_low_.y) / cell_, rows_);
  return WalkTo(
      p, start_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)]);
}

void Triangulation::BuildLocator() {
  // The grid covers the input points; the frame's corners are far away.
  const std::size_t inputs = points_.size() - 4;
  Point low = points_[0], high = points_[0];
  for (std::size_t i = 0; i < inputs; ++i) {
    low = {std::min(low.x, points_[i].x), std::min(low.y, points_[i].y)};
    high = {std::max(high.x, points_[i].x), std::max(high.y, points_[i].y)};
  }
  inner_low_ = low;
  const Point size = high - low;
  const double cells = std::max(1.0, static_cast<double>(triangles_.size()) / kTrianglesPerCell);
  const double longest = std::max({size.x, size.y, 1e-300});
  cell_ =
      std::max(std::sqrt(std::max(size.x, 1e-6 * longest) * std::max(size.y, 1e-6 * longest) / cells), longest / 10000);
  columns_ = static_cast<int>(size.x / cell_) + 1;
  rows_ = static_cast<int>(size.y / cell_) + 1;
  start_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  TriangleId from(0);
  for (int row = 0; row < rows_; ++row) {
    for (int k = 0; k < columns_; ++k) {
      const int column = row % 2 == 0 ? k : columns_ - 1 - k;
      from = WalkTo({low.x + (column + 0.5) * cell_, low.y + (row + 0.5) * cell_}, from);
      start_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)] =
          from;
    }
  }
}

}  // namespace tautline
