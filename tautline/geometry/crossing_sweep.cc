#include "tautline/geometry/crossing_sweep.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <vector>

#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// The edges that the sweep line passes, from the lowest up. The line goes over the points in lexicographic order, as
/// if it leaned a little, so that an upright edge has a first and a last point too. As long as no two edges have
/// crossed, their order on the line stays; edges that run along each other stand in any order.
class CrossingSweep {
 public:
  explicit CrossingSweep(RingEdges& edges) : edges_(edges), line_(Order{&edges}), place_(edges.size(), line_.end()) {}

  void Run() {
    std::vector<std::size_t> vertices(edges_.size());
    std::iota(vertices.begin(), vertices.end(), std::size_t{0});
    std::sort(vertices.begin(), vertices.end(), [this](auto i, auto j) { return edges_.At(i) < edges_.At(j); });
    for (auto begin = vertices.begin(); begin != vertices.end() && !edges_.crossing();) {
      const Point p = edges_.At(*begin);
      const auto end = std::find_if(begin, vertices.end(), [&](std::size_t i) { return edges_.At(i) != p; });
      PassPoint(p, {&*begin, static_cast<std::size_t>(end - begin)});  // By pointer: libc++ 14 takes no iterators.
      begin = end;
    }
  }

 private:
  struct Order {
    using is_transparent = void;

    const RingEdges* edges;

    Point First(std::size_t i) const { return std::min(edges->At(i), edges->At(i + 1)); }
    Point Last(std::size_t i) const { return std::max(edges->At(i), edges->At(i + 1)); }
    /// +1 when p is above the edge, -1 below it.
    int Above(std::size_t i, Point p) const { return Orientation(First(i), Last(i), p); }

    bool operator()(std::size_t i, Point p) const { return Above(i, p) > 0; }
    bool operator()(Point p, std::size_t i) const { return Above(i, p) < 0; }
    bool operator()(std::size_t i, std::size_t j) const {
      if (i == j) return false;
      const bool later = First(j) < First(i);  // The one that starts later is seen from the other one.
      const std::size_t base = later ? j : i, other = later ? i : j;
      int above = Above(base, First(other));
      if (above == 0) above = Above(base, Last(other));
      if (above == 0) return i < j;
      return (above > 0) == (base == i);
    }
  };
  using Line = std::set<std::size_t, Order>;

  /// Everything that happens in one point: edges end, start, or pass through it.
  void PassPoint(Point p, std::span<const std::size_t> vertices) {
    const auto [low, high] = line_.equal_range(p);
    std::vector<std::size_t> meeting(low, high), starting;
    for (const std::size_t vertex : vertices) {
      for (const std::size_t edge : {vertex, vertex == 0 ? edges_.size() - 1 : vertex - 1}) {
        if (line_.key_comp().First(edge) == p) starting.push_back(edge);
      }
    }
    meeting.insert(meeting.end(), starting.begin(), starting.end());
    for (std::size_t i = 0; i < meeting.size(); ++i) {
      for (std::size_t j = i + 1; j < meeting.size(); ++j) edges_.Compare(meeting[i], meeting[j]);
    }
    for (const std::size_t edge : meeting) {
      if (line_.key_comp().Last(edge) != p || place_[edge] == line_.end()) continue;
      line_.erase(place_[edge]);
      place_[edge] = line_.end();
    }
    for (const std::size_t edge : starting) place_[edge] = line_.insert(edge).first;
    CompareNewNeighbours(p);
  }

  /// What goes on from p against what is next to it on the line, or both sides of p where nothing goes on.
  void CompareNewNeighbours(Point p) {
    const auto [low, high] = line_.equal_range(p);
    const bool has_below = low != line_.begin(), has_above = high != line_.end();
    if (low == high) {
      if (has_below && has_above) edges_.Compare(*std::prev(low), *high);
      return;
    }
    if (has_below) edges_.Compare(*std::prev(low), *low);
    if (has_above) edges_.Compare(*std::prev(high), *high);
  }

  RingEdges& edges_;
  Line line_;
  std::vector<Line::iterator> place_;
};

}  // namespace

void SweepForCrossing(RingEdges& edges) { CrossingSweep(edges).Run(); }

}  // namespace tautline
