#include "tautline/planners/grid_manifold/literal_manifold.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/homotopy/taut_path.h"
#include "tautline/planners/grid_manifold/tile_relaxation.h"

namespace tautline {
namespace {

using Vertex = LiteralManifold::Vertex;

/// BUILDMANIFOLD; the letters of the paper's lines are the names here.
class LiteralBuilder {
 public:
  LiteralBuilder(const CellGround& ground, LiteralManifold& manifold) : ground_(ground), v_(manifold) {}

  void Expand(std::int32_t a) {
    std::array<std::int32_t, 4> successors{};
    const int count = MakeSuccessors(a, successors);
    for (int i = 0; i < count; ++i) {
      const std::int32_t t = successors[static_cast<std::size_t>(i)];
      Join(t, a);
      // ADJACENT(ADJACENT(va)): at the corners of the square around va there may be vertices beside vt.
      for (int k = 0; k < at(a).degree; ++k) {
        const std::int32_t c = at(a).beside[static_cast<std::size_t>(k)];
        for (int l = 0; l < at(c).degree; ++l) {
          const std::int32_t b = at(c).beside[static_cast<std::size_t>(l)];
          if (b != a && b != t && AreNeighbours(b, t) && !AreJoined(b, t)) Join(t, b);
        }
      }
    }
  }

 private:
  Vertex& at(std::int32_t i) { return v_.vertices[static_cast<std::size_t>(i)]; }

  int MakeSuccessors(std::int32_t a, std::array<std::int32_t, 4>& successors) {
    int count = 0;
    for (std::size_t d = 0; d < kDirections; d += 2) {
      const GridCell p{at(a).cell.column + kStepColumns[d], at(a).cell.row + kStepRows[d]};
      if (!ground_.IsFree(p) || IsAdjacentAt(a, p)) continue;
      successors[static_cast<std::size_t>(count++)] = static_cast<std::int32_t>(v_.vertices.size());
      v_.vertices.push_back({p, at(a).distance + 1});
    }
    return count;
  }

  bool IsAdjacentAt(std::int32_t a, GridCell p) {
    for (int k = 0; k < at(a).degree; ++k) {
      if (at(at(a).beside[static_cast<std::size_t>(k)]).cell == p) return true;
    }
    return false;
  }

  bool AreNeighbours(std::int32_t a, std::int32_t b) {
    return std::abs(at(a).cell.column - at(b).cell.column) + std::abs(at(a).cell.row - at(b).cell.row) == 1;
  }

  bool AreJoined(std::int32_t a, std::int32_t b) {
    return std::find(at(a).beside.begin(), at(a).beside.end(), b) != at(a).beside.end();
  }

  void Join(std::int32_t a, std::int32_t b) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      Vertex& vertex = at(from);
      TAUTLINE_CHECK(vertex.degree < 4);
      vertex.beside[vertex.degree++] = to;
    }
    ++v_.edges;
  }

  const CellGround& ground_;
  LiteralManifold& v_;
};

}  // namespace

LiteralManifold BuildLiteralManifold(const CellGround& ground, GridCell base, double length_cells,
                                     std::int64_t max_vertices) {
  TAUTLINE_CHECK(ground.IsFree(base));
  LiteralManifold manifold;
  manifold.vertices.push_back({base});
  LiteralBuilder builder(ground, manifold);
  // The list of vertices is the queue as well: distances grow along it.
  for (std::size_t i = 0; i < manifold.vertices.size(); ++i) {
    const double distance = manifold.vertices[i].distance;
    if (distance >= length_cells * (1 - kLengthTolerance)) break;
    if (static_cast<std::int64_t>(manifold.vertices.size()) > std::min<std::int64_t>(max_vertices, INT32_MAX / 2)) {
      manifold.budget_exceeded = true;
      break;
    }
    builder.Expand(static_cast<std::int32_t>(i));
  }
  return manifold;
}

std::vector<std::int64_t> LiteralManifold::Multiplicity() const {
  std::vector<std::pair<int, int>> cells;
  for (const Vertex& vertex : vertices) cells.emplace_back(vertex.cell.row, vertex.cell.column);
  std::sort(cells.begin(), cells.end());
  std::vector<std::int64_t> multiplicity;
  for (std::size_t i = 0, k = 0; i < cells.size(); i = k) {
    while (k < cells.size() && cells[k] == cells[i]) ++k;
    if (multiplicity.size() < k - i) multiplicity.resize(k - i);
    ++multiplicity[k - i - 1];
  }
  return multiplicity;
}

}  // namespace tautline
