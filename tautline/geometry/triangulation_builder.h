// The incremental construction behind Triangulation::Build. Internal to the geometry folder.
#ifndef TAUTLINE_GEOMETRY_TRIANGULATION_BUILDER_H_
#define TAUTLINE_GEOMETRY_TRIANGULATION_BUILDER_H_

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "tautline/geometry/triangulation.h"

namespace tautline {

/// Inserts points along a Hilbert curve, legalising by flips, then forces the edges in by flips.
class TriangulationBuilder {
 public:
  TriangulationBuilder(std::span<const Point> points, Triangulation& result);

  void InsertPoints();
  void InsertEdges(std::span<const InputEdge> edges);

 private:
  /// An edge as the triangle on its left and the position opposite to it there.
  struct Side {
    TriangleId triangle;
    int index;
  };
  /// A walk around a vertex; `at` is invalid after its end.
  struct FanWalk {
    VertexId vertex;
    TriangleId first, at;
    int index;  ///< Of the vertex in `at`.
    bool clockwise;
  };
  using VertexPair = std::pair<VertexId, VertexId>;
  /// The edges in the way of a segment, linked in its direction. A crossing that is gone still leads on to the rest.
  struct Channel {
    static constexpr std::size_t kEnd = static_cast<std::size_t>(-1);
    struct Crossing {
      VertexId right, left;  ///< The ends of the edge, seen along the segment.
      std::size_t before = kEnd, after = kEnd;
      bool gone = false;
    };
    VertexId from, to;
    std::vector<Crossing> crossings;
    std::size_t first = kEnd;
    std::vector<VertexPair> created;  ///< By flips, and clear of the segment.

    void Add(VertexId right, VertexId left);
    void Remove(std::size_t at);
  };

  Triangle& At(TriangleId id) { return mesh_.triangles_[id.index()]; }
  Point PointOf(VertexId id) const { return mesh_.points_[id.index()]; }

  void AddFrame(std::span<const Point> points);
  TriangleId AddTriangle(VertexId a, VertexId b, VertexId c);
  void Link(TriangleId triangle, int index, TriangleId neighbour, TriangleId was);
  void InsertPoint(VertexId vertex);
  void SplitTriangle(TriangleId triangle, VertexId vertex);
  void SplitEdge(TriangleId triangle, int index, VertexId vertex);
  void Flip(TriangleId triangle, int index);
  void FlipAmongEdges(TriangleId triangle, int index);
  void Legalise();
  bool IsIllegal(TriangleId triangle, int index);

  void InsertEdge(VertexId from, VertexId to);
  bool MarkIfPresent(VertexId from, VertexId to);
  VertexId FirstVertexAlong(VertexId from, VertexId to);
  Channel CollectCrossings(VertexId from, VertexId to);
  bool FlipCrossing(std::size_t at, bool must_clear, Channel& channel);
  void FlipAway(Channel& channel);
  void RestoreDelaunay(std::vector<VertexPair> pending);
  Side FindEdge(VertexId from, VertexId to);
  Side FirstCrossing(VertexId from, VertexId to);

  FanWalk FanOf(VertexId vertex);
  void Advance(FanWalk& walk);
  template <class Visit>
  void ForEachInFan(VertexId vertex, Visit visit);

  Triangulation& mesh_;
  std::vector<TriangleId> suspicious_;
  TriangleId last_;
};

}  // namespace tautline

#endif  // TAUTLINE_GEOMETRY_TRIANGULATION_BUILDER_H_
