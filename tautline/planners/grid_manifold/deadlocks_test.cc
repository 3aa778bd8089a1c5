#include "tautline/planners/grid_manifold/deadlocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "tautline/base/test_scale.h"
#include "tautline/planners/grid_manifold/manifold_oracle.h"

namespace tautline {
namespace {

using Vertex = std::pair<std::uint32_t, int>;

std::vector<ManifoldVertex> AllVertices(const GridManifold& manifold) {
  std::vector<ManifoldVertex> all;
  for (std::uint32_t page = 0; page < manifold.pages(); ++page) {
    for (int cell = 0; cell < 64; ++cell) {
      if (manifold.Has({page, cell})) all.push_back({page, cell});
    }
  }
  return all;
}

/// The rule, read off the page: for every contact a graph without the steps that come upon or pass through its path,
/// the part of that graph at each vertex beside the contact, and the ways in it.
class DeadlockOracle {
 public:
  explicit DeadlockOracle(const GridManifold& manifold) : manifold_(manifold) {
    step_ = manifold.atlas().connectivity() == Connectivity::kEight ? 1 : 2;
    auto all = AllVertices(manifold);
    std::stable_sort(all.begin(), all.end(),
                     [&](auto a, auto b) { return manifold.distance(a) < manifold.distance(b); });
    for (const ManifoldVertex v : all) {
      if (!IsContact(v)) continue;
      ++contacts_;
      if (closed_.count({v.page, v.cell}) == 0) Examine(v);
    }
  }

  std::size_t contacts() const { return contacts_; }
  std::size_t deadlocks() const { return deadlocks_; }
  const std::set<Vertex>& closed() const { return closed_; }

 private:
  using Cell = std::pair<int, int>;

  Cell CellOf(ManifoldVertex v) const {
    const GridCell cell = manifold_.CellOf(v);
    return {cell.column, cell.row};
  }

  bool TouchesBlocked(ManifoldVertex v) const {
    const auto [column, row] = CellOf(v);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        if (!manifold_.ground().IsFree({column + dx, row + dy})) return true;
      }
    }
    return false;
  }

  bool IsContact(ManifoldVertex v) const {
    const auto path = PathToBase(manifold_, v);
    return path.size() > 1 && TouchesBlocked(v) && !TouchesBlocked(path[1]);
  }

  /// Whether the step is in the graph: two diagonal steps that cross have one midpoint.
  bool IsOpen(Cell a, Cell b, const std::vector<Cell>& path) const {
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (b == path[i]) return false;
      if (i == 0 || a.first == b.first || a.second == b.second) continue;
      const auto& [c, d] = std::pair(path[i - 1], path[i]);
      if (a.first + b.first == c.first + d.first && a.second + b.second == c.second + d.second) return false;
    }
    return true;
  }

  void Examine(ManifoldVertex v) {
    std::vector<Cell> path;
    for (const ManifoldVertex u : PathToBase(manifold_, v)) path.push_back(CellOf(u));
    const Cell along{path[0].first - path[1].first, path[0].second - path[1].second};
    std::set<Vertex> seen;
    for (int d = 0; d < kDirections; d += step_) {
      const auto first = manifold_.Step(v, d);
      if (!first || !IsOpen(path[0], CellOf(*first), path) || seen.count({first->page, first->cell}) > 0) continue;
      const std::map<Vertex, LatticeDistance> part = PartOf(*first, v, path);
      LatticeDistance farthest = 0;
      bool left = false, right = false;
      for (const auto& [u, distance] : part) {
        seen.insert(u);
        farthest = std::max(farthest, distance);
        const Cell cell = CellOf({u.first, u.second});
        const Cell from_parent{cell.first - path[1].first, cell.second - path[1].second};
        left = left || from_parent == Flank(along, 1);
        right = right || from_parent == Flank(along, -1);
      }
      if (left == right || farthest + manifold_.distance(v) > manifold_.limit()) continue;
      bool beyond = false;
      for (const auto& [u, distance] : part) {
        if (manifold_.distance({u.first, u.second}) <= manifold_.distance(v)) continue;
        closed_.insert(u);
        beyond = true;
      }
      if (beyond) ++deadlocks_;
    }
  }

  /// A step turned by a quarter, or by an eighth where it is diagonal.
  static Cell Flank(Cell along, int sign) {
    const Cell quarter{-sign * along.second, sign * along.first};
    if (along.first == 0 || along.second == 0) return quarter;
    return {(along.first + quarter.first) / 2, (along.second + quarter.second) / 2};
  }

  /// All vertices joined to one beside the contact, with their ways from the contact.
  std::map<Vertex, LatticeDistance> PartOf(ManifoldVertex first, ManifoldVertex contact,
                                           const std::vector<Cell>& path) const {
    std::map<Vertex, LatticeDistance> part{{{first.page, first.cell}, kUnreached}};
    std::vector<ManifoldVertex> stack{first};
    const auto steps = [&](ManifoldVertex v, const auto& use) {
      for (int d = 0; d < kDirections; d += step_) {
        const auto to = manifold_.Step(v, d);
        if (to && IsOpen(CellOf(v), CellOf(*to), path)) use(*to, StepLength(d));
      }
    };
    while (!stack.empty()) {
      const ManifoldVertex v = stack.back();
      stack.pop_back();
      steps(v, [&](ManifoldVertex to, LatticeDistance) {
        if (part.try_emplace({to.page, to.cell}, kUnreached).second) stack.push_back(to);
      });
    }
    steps(contact, [&](ManifoldVertex to, LatticeDistance length) {
      const auto at = part.find({to.page, to.cell});
      if (at != part.end()) at->second = length;
    });
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [u, distance] : part) {
        steps({u.first, u.second}, [&, from = distance](ManifoldVertex to, LatticeDistance length) {
          LatticeDistance& at = part.at({to.page, to.cell});
          if (from == kUnreached || from + length >= at) return;
          at = from + length;
          changed = true;
        });
      }
    }
    return part;
  }

  const GridManifold& manifold_;
  int step_ = 1;
  std::size_t contacts_ = 0, deadlocks_ = 0;
  std::set<Vertex> closed_;
};

TEST(DeadlockAreas, AreWhatTheSlowWayFinds) {
  std::size_t deadlocks = 0, islands = 0;
  for (std::int64_t seed = 0; seed < ScaledTestCount(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(static_cast<std::uint64_t>(seed));
    ManifoldOptions options;
    const CellGround ground = RandomGround(rng, options.base);
    options.connectivity = seed % 2 == 0 ? Connectivity::kFour : Connectivity::kEight;
    options.length_m = ground.cell_m() * rng.Uniform(0, 12);
    const GridManifold manifold = GridManifold::Build(ground, options);
    if (manifold.value_count() > 4000) continue;
    const DeadlockOracle oracle(manifold);
    const DeadlockAreas areas(manifold);
    ASSERT_EQ(areas.examined(), areas.contacts().size());
    ASSERT_EQ(areas.contacts().size(), oracle.contacts());
    ASSERT_EQ(areas.deadlocks().size(), oracle.deadlocks());
    ASSERT_EQ(areas.closed_vertices(), static_cast<std::int64_t>(oracle.closed().size()));
    for (const ManifoldVertex v : AllVertices(manifold)) {
      ASSERT_EQ(areas.IsClosed(v), oracle.closed().count({v.page, v.cell}) > 0);
    }
    deadlocks += areas.deadlocks().size();
    for (const Deadlock& deadlock : areas.deadlocks()) islands += areas.contacts()[deadlock.contact].obstacle ? 1 : 0;
  }
  EXPECT_GE(deadlocks, static_cast<std::size_t>(ScaledTestCount(20)));
  if (ScaledTestCount(100) >= 100) {
    EXPECT_GT(islands, 2U);
  }
}

/// The deadlocks of a sketch, the base being where '*' stands.
struct Sketched {
  GridManifold manifold;
  DeadlockAreas areas;

  Sketched(const std::vector<std::string_view>& rows, double length)
      : manifold(GridManifold::Build(CellGround(GridOf(rows), {}), {.base = BaseOf(rows), .length_m = length})),
        areas(manifold) {}

  static GridCell BaseOf(const std::vector<std::string_view>& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::size_t column = rows[i].find('*');
      if (column != std::string_view::npos) return {static_cast<int>(column), static_cast<int>(rows.size() - 1 - i)};
    }
    return {};
  }
  static OccupancyGrid GridOf(const std::vector<std::string_view>& rows) {
    const GridCell base = BaseOf(rows);
    std::vector<std::string> texts(rows.begin(), rows.end());
    texts[texts.size() - 1 - static_cast<std::size_t>(base.row)][static_cast<std::size_t>(base.column)] = '.';
    return GridFromSketch({texts.begin(), texts.end()});
  }

  bool IsClosed(GridCell cell) const {
    const auto at = manifold.VerticesAt(cell);
    return !at.empty() && areas.IsClosed(at[0]);
  }
};

// [Igarashi2010, Fig. 12]: the tether comes to a wall. On the left the room ends before the tether does, and once the
// robot is there the tether bars the way back; on the right it has room enough to pull the tether off the wall.
TEST(DeadlockAreas, CloseTheShortSideOfARoom) {
  const std::vector<std::string_view> room{
      "####################",  //
      "#..................#",  //
      "#..................#",  //
      "#..................#",  //
      "#....*.............#",  //
      "####################",
  };
  const Sketched sketch(room, 10);
  ASSERT_FALSE(sketch.areas.deadlocks().empty());
  EXPECT_FALSE(sketch.areas.contacts()[sketch.areas.deadlocks()[0].contact].obstacle);
  EXPECT_TRUE(sketch.IsClosed({1, 4}));
  EXPECT_FALSE(sketch.IsClosed({10, 4}));
  EXPECT_FALSE(sketch.IsClosed({5, 1}));
  EXPECT_EQ(sketch.areas.LostCells(), sketch.areas.closed_vertices());
  EXPECT_EQ(Sketched(room, 4).areas.closed_vertices(), 0);
}

/// How many deadlocks islands cause.
std::size_t DeadlocksAtIslands(const DeadlockAreas& areas) {
  std::size_t count = 0;
  for (const Deadlock& deadlock : areas.deadlocks()) count += areas.contacts()[deadlock.contact].obstacle ? 1 : 0;
  return count;
}

// A pier locks the robot in beside it; a pillar in its place does not, since the robot can go round it.
TEST(DeadlockAreas, AreNoneWhereTheTetherCanBeCarriedRound) {
  const Sketched pier(
      {
          "....#....",  //
          "....#....",  //
          "....#....",  //
          "....#....",  //
          ".........",  //
          ".........",  //
          "....*....",  //
      },
      14);
  EXPECT_EQ(DeadlocksAtIslands(pier.areas), 0U);
  EXPECT_TRUE(pier.IsClosed({0, 6}));
  EXPECT_TRUE(pier.IsClosed({8, 6}));
  const Sketched pillar(
      {
          ".........",  //
          ".........",  //
          "....#....",  //
          "....#....",  //
          ".........",  //
          ".........",  //
          "....*....",  //
      },
      14);
  EXPECT_EQ(DeadlocksAtIslands(pillar.areas), 0U);
  EXPECT_FALSE(pillar.IsClosed({0, 6}));
  EXPECT_FALSE(pillar.IsClosed({8, 6}));
}

// In a bay the tether runs along a jaw of the mouth and comes to the wall opposite.
TEST(DeadlockAreas, NameTheIslandThatCausesThem) {
  const Sketched bay(
      {
          "...................",  //
          "...................",  //
          ".#################.",  //
          ".#...............#.",  //
          ".#...............#.",  //
          ".#...............#.",  //
          ".#...............#.",  //
          ".########....#####.",  //
          "...................",  //
          ".........*.........",  //
          "...................",  //
      },
      30);
  EXPECT_GT(DeadlocksAtIslands(bay.areas), 0U);
  EXPECT_TRUE(bay.IsClosed({3, 5}));
  EXPECT_FALSE(bay.IsClosed({9, 0}));
}

TEST(DeadlockAreas, StopsWhenAsked) {
  const GridManifold manifold =
      GridManifold::Build(CellGround(GridFromSketch({"....", "....", "...."}), {}), {.base = {1, 1}, .length_m = 9});
  int left = 3;
  const DeadlockAreas areas(manifold, [&] { return left-- > 0; });
  EXPECT_EQ(areas.examined(), 3U);
  EXPECT_GT(areas.contacts().size(), 3U);
}

}  // namespace
}  // namespace tautline
