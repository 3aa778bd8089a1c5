#include "tautline/geometry/triangulation_builder.h"

#include <algorithm>
#include <tuple>

#include "tautline/base/check.h"
#include "tautline/geometry/hilbert_order.h"
#include "tautline/geometry/polygon.h"
#include "tautline/geometry/predicates.h"

namespace tautline {

TriangulationBuilder::TriangulationBuilder(std::span<const Point> points, Triangulation& result) : mesh_(result) {
  AddFrame(points);
}

void TriangulationBuilder::AddFrame(std::span<const Point> points) {
  Box box = BoundingBox(points);
  if (box.empty()) box.Add({0, 0});
  const double margin = 2 * std::max({box.size().x, box.size().y, 1e-3 * Norm(box.low), 1.0});
  const Point low = box.low - Point{margin, margin}, high = box.high + Point{margin, margin};
  mesh_.frame_low_ = low;
  mesh_.frame_high_ = high;
  mesh_.points_.assign(points.begin(), points.end());
  mesh_.points_.insert(mesh_.points_.end(), {low, {high.x, low.y}, high, {low.x, high.y}});
  mesh_.triangle_at_.resize(mesh_.points_.size());
  mesh_.triangles_.reserve(2 * mesh_.points_.size());
  const VertexId a(points.size()), b(points.size() + 1), c(points.size() + 2), d(points.size() + 3);
  const TriangleId lower = AddTriangle(a, b, c), upper = AddTriangle(a, c, d);
  At(lower).neighbours[1] = upper;
  At(upper).neighbours[2] = lower;
  last_ = lower;
}

TriangleId TriangulationBuilder::AddTriangle(VertexId a, VertexId b, VertexId c) {
  const TriangleId id(mesh_.triangles_.size());
  mesh_.triangles_.push_back({{a, b, c}, {}, {}});
  return id;
}

/// Makes `neighbour`, which used to border on `was` there, border on side `index` of `triangle`.
void TriangulationBuilder::Link(TriangleId triangle, int index, TriangleId neighbour, TriangleId was) {
  At(triangle).neighbours[static_cast<std::size_t>(index)] = neighbour;
  if (!neighbour.valid()) return;
  At(neighbour).neighbours[static_cast<std::size_t>(At(neighbour).IndexOf(was))] = triangle;
}

void TriangulationBuilder::InsertPoints() {
  const std::span<const Point> inputs(mesh_.points_.data(), mesh_.points_.size() - 4);
  for (const std::int32_t position : HilbertOrder(inputs)) InsertPoint(VertexId(position));
  for (std::size_t t = 0; t < mesh_.triangles_.size(); ++t) {
    for (const VertexId vertex : mesh_.triangles_[t].vertices) mesh_.triangle_at_[vertex.index()] = TriangleId(t);
  }
}

void TriangulationBuilder::InsertPoint(VertexId vertex) {
  const Point p = PointOf(vertex);
  const TriangleId triangle = mesh_.WalkTo(p, last_);
  int on_edge = -1;
  for (int i = 0; i < 3; ++i) {
    TAUTLINE_CHECK(mesh_.corner(triangle, i) != p);
    if (Orientation(mesh_.corner(triangle, Next(i)), mesh_.corner(triangle, Previous(i)), p) == 0) on_edge = i;
  }
  if (on_edge < 0) {
    SplitTriangle(triangle, vertex);
  } else {
    SplitEdge(triangle, on_edge, vertex);
  }
  Legalise();
  last_ = triangle;
}

void TriangulationBuilder::SplitTriangle(TriangleId triangle, VertexId vertex) {
  const Triangle old = At(triangle);
  const auto [a, b, c] = old.vertices;
  // `triangle` becomes (v, b, c); (v, c, a) and (v, a, b) are new.
  const TriangleId second = AddTriangle(vertex, c, a), third = AddTriangle(vertex, a, b);
  At(triangle).vertices = {vertex, b, c};
  At(triangle).neighbours = {old.neighbours[0], second, third};
  Link(second, 0, old.neighbours[1], triangle);
  Link(third, 0, old.neighbours[2], triangle);
  At(second).neighbours = {old.neighbours[1], third, triangle};
  At(third).neighbours = {old.neighbours[2], triangle, second};
  suspicious_ = {triangle, second, third};
}

void TriangulationBuilder::SplitEdge(TriangleId triangle, int index, VertexId vertex) {
  // Rotate names so that the split edge runs from b to c in (a, b, c); d is across.
  const Triangle old = At(triangle);
  const auto k = static_cast<std::size_t>(index);
  const VertexId a = old.vertices[k], b = old.vertices[(k + 1) % 3], c = old.vertices[(k + 2) % 3];
  const TriangleId ca = old.neighbours[(k + 1) % 3], ab = old.neighbours[(k + 2) % 3];
  const TriangleId across = old.neighbours[k];
  TAUTLINE_CHECK(across.valid());
  const Triangle other = At(across);
  const auto m = static_cast<std::size_t>(other.IndexOf(triangle));
  const VertexId d = other.vertices[m];
  const TriangleId bd = other.neighbours[(m + 1) % 3], dc = other.neighbours[(m + 2) % 3];
  // (v, a, b) and (v, d, c) reuse the two; (v, c, a) and (v, b, d) are new.
  const TriangleId vca = AddTriangle(vertex, c, a), vbd = AddTriangle(vertex, b, d);
  At(triangle).vertices = {vertex, a, b};
  At(across).vertices = {vertex, d, c};
  At(vca).neighbours = {TriangleId(), triangle, across};
  At(triangle).neighbours = {ab, vbd, vca};
  At(vbd).neighbours = {TriangleId(), across, triangle};
  At(across).neighbours = {dc, vca, vbd};
  Link(vca, 0, ca, triangle);
  Link(vbd, 0, bd, across);
  suspicious_ = {triangle, vca, across, vbd};
}

/// Replaces the edge opposite to vertices[index] by the other diagonal of its quadrilateral. Afterwards `triangle` is
/// (p, q, d) and its former neighbour (p, d, r), where (p, q, r) was the triangle and d the vertex across.
void TriangulationBuilder::Flip(TriangleId triangle, int index) {
  const auto k = static_cast<std::size_t>(index);
  const TriangleId across = At(triangle).neighbours[k];
  const Triangle here = At(triangle), there = At(across);
  const auto m = static_cast<std::size_t>(there.IndexOf(triangle));
  const VertexId p = here.vertices[k], q = here.vertices[(k + 1) % 3], r = here.vertices[(k + 2) % 3];
  const VertexId d = there.vertices[m];
  const TriangleId rp = here.neighbours[(k + 1) % 3], pq = here.neighbours[(k + 2) % 3];
  // `there` is (d, r, q): across its vertex r lies the edge q-d, across q the edge d-r.
  const TriangleId qd = there.neighbours[(m + 1) % 3], dr = there.neighbours[(m + 2) % 3];
  At(triangle) = {{p, q, d}, {qd, across, pq}, {there.constrained[(m + 1) % 3], false, here.constrained[(k + 2) % 3]}};
  At(across) = {{p, d, r}, {dr, rp, triangle}, {there.constrained[(m + 2) % 3], here.constrained[(k + 1) % 3], false}};
  if (qd.valid()) At(qd).neighbours[static_cast<std::size_t>(At(qd).IndexOf(across))] = triangle;
  if (rp.valid()) At(rp).neighbours[static_cast<std::size_t>(At(rp).IndexOf(triangle))] = across;
}

/// As Flip, and keeps a triangle known for each vertex.
void TriangulationBuilder::FlipAmongEdges(TriangleId triangle, int index) {
  const TriangleId across = At(triangle).neighbour(index);
  Flip(triangle, index);
  for (const TriangleId id : {triangle, across}) {
    for (const VertexId vertex : At(id).vertices) mesh_.triangle_at_[vertex.index()] = id;
  }
}

bool TriangulationBuilder::IsIllegal(TriangleId triangle, int index) {
  const Triangle& here = At(triangle);
  const TriangleId across = here.neighbour(index);
  if (!across.valid() || here.is_constrained(index)) return false;
  const VertexId opposite = At(across).vertex(At(across).IndexOf(triangle));
  return InCircle(mesh_.corner(triangle, 0), mesh_.corner(triangle, 1), mesh_.corner(triangle, 2), PointOf(opposite)) >
         0;
}

/// Flips until all edges opposite to the new vertex are Delaunay. It comes first in the suspicious triangles.
void TriangulationBuilder::Legalise() {
  while (!suspicious_.empty()) {
    const TriangleId triangle = suspicious_.back();
    suspicious_.pop_back();
    if (!IsIllegal(triangle, 0)) continue;
    const TriangleId across = At(triangle).neighbour(0);
    Flip(triangle, 0);
    suspicious_.push_back(triangle);
    suspicious_.push_back(across);
  }
}

void TriangulationBuilder::InsertEdges(std::span<const InputEdge> edges) {
  mesh_.chain_begin_.assign(1, 0);
  for (const auto& [from, to] : edges) {
    VertexId at(from);
    mesh_.chain_vertices_.push_back(at);
    while (at != VertexId(to)) {
      VertexId next(to);
      if (!MarkIfPresent(at, next)) {
        next = FirstVertexAlong(at, next);
        InsertEdge(at, next);
      }
      mesh_.chain_vertices_.push_back(next);
      at = next;
    }
    mesh_.chain_begin_.push_back(mesh_.chain_vertices_.size());
  }
}

/// Calls visit(triangle, position of `vertex` in it) around the vertex until it says true: counter-clockwise all
/// around, or, at a corner of the frame, to the frame and then from the start the other way.
template <class Visit>
void TriangulationBuilder::ForEachInFan(VertexId vertex, Visit visit) {
  for (FanWalk walk = FanOf(vertex); walk.at.valid(); Advance(walk)) {
    if (visit(walk.at, walk.index)) return;
  }
}

TriangulationBuilder::FanWalk TriangulationBuilder::FanOf(VertexId vertex) {
  const TriangleId first = mesh_.triangle_at_[vertex.index()];
  return {vertex, first, first, At(first).IndexOf(vertex), false};
}

/// To the next triangle of the fan; to none at the end of the fan.
void TriangulationBuilder::Advance(FanWalk& walk) {
  if (!walk.clockwise) {
    walk.at = At(walk.at).neighbour(Next(walk.index));
    if (walk.at == walk.first) {
      walk.at = TriangleId();
    } else if (!walk.at.valid()) {  // The frame: turn round at the start.
      walk.clockwise = true;
      walk.at = walk.first;
      walk.index = At(walk.at).IndexOf(walk.vertex);
    }
  }
  if (walk.clockwise) walk.at = At(walk.at).neighbour(Previous(walk.index));
  if (walk.at.valid()) walk.index = At(walk.at).IndexOf(walk.vertex);
}

/// The edge seen from its left, or no triangle when there is no such edge. The fan of a corner of the frame may have as
/// many triangles as there are points, but a triangulation has few edges both of whose ends have many: past the first
/// few triangles both fans are walked in step, so that the smaller one ends the search.
TriangulationBuilder::Side TriangulationBuilder::FindEdge(VertexId from, VertexId to) {
  constexpr int kSmallFan = 12;
  const TriangleId first = mesh_.triangle_at_[from.index()];
  TriangleId at = first;
  for (int steps = 0; at.valid() && steps < kSmallFan; ++steps) {
    const Triangle& here = At(at);
    const int i = here.IndexOf(from);
    if (here.vertex(Next(i)) == to) return {at, Previous(i)};
    at = here.neighbour(Next(i));
    if (at == first) return {{}, 0};
  }
  FanWalk ahead = FanOf(from), back = FanOf(to);
  for (; ahead.at.valid() && back.at.valid(); Advance(ahead), Advance(back)) {
    if (At(ahead.at).vertex(Next(ahead.index)) == to) return {ahead.at, Previous(ahead.index)};
    if (At(back.at).vertex(Previous(back.index)) == from) return {back.at, Next(back.index)};
  }
  return {{}, 0};
}

bool TriangulationBuilder::MarkIfPresent(VertexId from, VertexId to) {
  const Side side = FindEdge(from, to);
  if (!side.triangle.valid()) return false;
  const auto index = static_cast<std::size_t>(side.index);
  At(side.triangle).constrained[index] = true;
  Triangle& across = At(At(side.triangle).neighbours[index]);
  across.constrained[static_cast<std::size_t>(across.IndexOf(side.triangle))] = true;
  return true;
}

/// The side opposite to `from` through which the open segment leaves the fan of `from`. Requires that no edge of the
/// fan lies along the segment.
TriangulationBuilder::Side TriangulationBuilder::FirstCrossing(VertexId from, VertexId to) {
  Side side{{}, 0};
  const Point p = PointOf(from), q = PointOf(to);
  ForEachInFan(from, [&](TriangleId at, int i) {
    if (Orientation(p, q, mesh_.corner(at, Next(i))) >= 0 || Orientation(p, q, mesh_.corner(at, Previous(i))) <= 0) {
      return false;
    }
    side = {at, i};
    return true;
  });
  TAUTLINE_CHECK(side.triangle.valid());
  return side;
}

/// The first vertex on the segment after `from`: `to`, or one that the segment passes through.
VertexId TriangulationBuilder::FirstVertexAlong(VertexId from, VertexId to) {
  const Point p = PointOf(from), q = PointOf(to);
  VertexId along;
  ForEachInFan(from, [&](TriangleId at, int i) {
    const VertexId next = At(at).vertex(Next(i));
    const bool ahead = Orientation(p, q, PointOf(next)) == 0 && Dot(q - p, PointOf(next) - p) > 0;
    if (ahead) along = next;
    return ahead;
  });
  if (along.valid()) return along;
  Side side = FirstCrossing(from, to);
  for (;;) {
    const TriangleId across = At(side.triangle).neighbour(side.index);
    const int i = At(across).IndexOf(side.triangle);
    const VertexId apex = At(across).vertex(i);
    const int turn = Orientation(p, q, PointOf(apex));
    if (apex == to || turn == 0) return apex;
    // The segment leaves through the side between the apex and the vertex on the other side of the segment.
    side = {across, turn > 0 ? Next(i) : Previous(i)};
  }
}

/// The edges that cross the open segment, from its start on. Requires that no vertex lies on the open segment.
TriangulationBuilder::Channel TriangulationBuilder::CollectCrossings(VertexId from, VertexId to) {
  Channel channel;
  channel.from = from;
  channel.to = to;
  Side side = FirstCrossing(from, to);
  for (;;) {
    const Triangle& here = At(side.triangle);
    const auto index = static_cast<std::size_t>(side.index);
    TAUTLINE_CHECK(!here.constrained[index]);
    channel.Add(here.vertices[(index + 1) % 3], here.vertices[(index + 2) % 3]);
    const TriangleId across = here.neighbours[index];
    const int i = At(across).IndexOf(side.triangle);
    const VertexId apex = At(across).vertex(i);
    if (apex == to) return channel;
    side = {across, Orientation(PointOf(from), PointOf(to), PointOf(apex)) > 0 ? Next(i) : Previous(i)};
  }
}

/// Appends a crossing.
void TriangulationBuilder::Channel::Add(VertexId right, VertexId left) {
  const std::size_t last = crossings.size();
  crossings.push_back({.right = right, .left = left, .before = last == 0 ? kEnd : last - 1});
  if (last == 0) {
    first = last;
  } else {
    crossings[last - 1].after = last;
  }
}

void TriangulationBuilder::Channel::Remove(std::size_t at) {
  const auto [before, after] = std::pair(crossings[at].before, crossings[at].after);
  (before == kEnd ? first : crossings[before].after) = after;
  if (after != kEnd) crossings[after].before = before;
  crossings[at].gone = true;
}

/// Flips the edge of the crossing if its quadrilateral is strictly convex and, when `must_clear`, the other diagonal
/// does not cross the segment. A diagonal that does not is left in `created`, and the crossing gone.
bool TriangulationBuilder::FlipCrossing(std::size_t at, bool must_clear, Channel& channel) {
  Channel::Crossing& crossing = channel.crossings[at];
  const Side side = FindEdge(crossing.right, crossing.left);
  const Triangle& here = At(side.triangle);
  const TriangleId across = here.neighbour(side.index);
  const VertexId apex = here.vertex(side.index), opposite = At(across).vertex(At(across).IndexOf(side.triangle));
  const Point p = PointOf(channel.from), q = PointOf(channel.to), a = PointOf(apex), b = PointOf(opposite);
  if (Orientation(a, b, PointOf(crossing.right)) * Orientation(a, b, PointOf(crossing.left)) >= 0) return false;
  const int turn_a = Orientation(p, q, a), turn_b = Orientation(p, q, b);
  const bool crosses = turn_a * turn_b < 0;
  if (crosses && must_clear) return false;
  FlipAmongEdges(side.triangle, side.index);
  if (crosses) {
    std::tie(crossing.right, crossing.left) = turn_a < 0 ? VertexPair(apex, opposite) : VertexPair(opposite, apex);
  } else {
    channel.created.emplace_back(apex, opposite);
    channel.Remove(at);
  }
  return true;
}

/// Flips until nothing crosses the segment. Passes along the segment flip what can be flipped [Sloan1993]; each flip
/// may let the crossings beside it clear the segment, which therefore is tried at once: past a chain of vertices that
/// bulges towards the segment, a pass would clear only the two at its ends.
void TriangulationBuilder::FlipAway(Channel& channel) {
  std::vector<std::size_t> beside;
  const auto add_beside = [&](std::size_t at) {
    beside.push_back(channel.crossings[at].before);
    beside.push_back(channel.crossings[at].after);
  };
  while (channel.first != Channel::kEnd) {
    for (std::size_t at = channel.first; at != Channel::kEnd; at = channel.crossings[at].after) {
      if (channel.crossings[at].gone || !FlipCrossing(at, false, channel)) continue;
      add_beside(at);
      while (!beside.empty()) {
        const std::size_t next = beside.back();
        beside.pop_back();
        if (next == Channel::kEnd || channel.crossings[next].gone || !FlipCrossing(next, true, channel)) continue;
        add_beside(next);
      }
    }
  }
}

void TriangulationBuilder::RestoreDelaunay(std::vector<VertexPair> pending) {
  while (!pending.empty()) {
    const auto [a, b] = pending.back();
    pending.pop_back();
    const Side side = FindEdge(a, b);
    if (!side.triangle.valid() || !IsIllegal(side.triangle, side.index)) continue;
    const TriangleId across = At(side.triangle).neighbour(side.index);
    const VertexId apex = At(side.triangle).vertex(side.index);
    const VertexId opposite = At(across).vertex(At(across).IndexOf(side.triangle));
    FlipAmongEdges(side.triangle, side.index);
    for (const VertexId end : {apex, opposite}) {
      pending.emplace_back(end, a);
      pending.emplace_back(end, b);
    }
  }
}

/// Forces the edge in. Requires that no vertex lies strictly between its ends.
void TriangulationBuilder::InsertEdge(VertexId from, VertexId to) {
  if (MarkIfPresent(from, to)) return;
  Channel channel = CollectCrossings(from, to);
  FlipAway(channel);
  TAUTLINE_CHECK(MarkIfPresent(from, to));
  RestoreDelaunay(std::move(channel.created));
}

}  // namespace tautline
