#include "tautline/planners/cable_workspace/best.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "tautline/base/test_scale.h"
#include "tautline/geometry/self_crossing.h"
#include "tautline/homotopy/classes.h"
#include "tautline/homotopy/random_scene.h"
#include "tautline/planners/cable_workspace/side_crossing.h"

namespace tautline {
namespace {

CableGround Prepared(const World& world) { return CableGround::Prepare(world).value(); }

World Room(double size, std::vector<Ring> blocks) {
  World world;
  world.outline = Rectangle({0, 0}, {size, size});
  for (Ring& block : blocks) world.obstacles.push_back(random_scene::PolygonObstacle(world, std::move(block)));
  return world;
}

Ring Block(Point centre, double half) { return Rectangle(centre - Point{half, half}, centre + Point{half, half}); }

std::vector<Point> CornersOf(double size) { return {{0, 0}, {0, size}, {size, size}, {size, 0}}; }

std::vector<double> AreasOf(const BoundaryList& list, double factor) {
  std::vector<double> areas;
  for (const WorkspaceBoundary& boundary : list.boundaries) areas.push_back(factor * boundary.area);
  return areas;
}

void ExpectAreas(const BoundaryList& list, const std::vector<double>& areas) {
  EXPECT_TRUE(list.complete);
  ASSERT_EQ(list.boundaries.size(), areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    EXPECT_NEAR(list.boundaries[i].area, areas[i], 1e-6 * std::max(1.0, areas[i])) << i;
  }
}

BoundaryList Find(const World& world, const std::vector<Point>& anchors, BestOptions options) {
  const CableGround ground = Prepared(world);
  return FindBoundaries(ground, PlaceAnchors(ground, anchors).value(), options);
}

std::vector<Word> WordsOf(const WorkspaceBoundary& boundary) {
  std::vector<Word> words;
  for (const BoundarySide& side : boundary.sides) words.push_back(side.path.word);
  return words;
}

std::set<std::vector<Word>> WordsOf(const BoundaryList& list) {
  std::set<std::vector<Word>> all;
  for (const WorkspaceBoundary& boundary : list.boundaries) EXPECT_TRUE(all.insert(WordsOf(boundary)).second);
  return all;
}

TEST(BestTest, OneBlockIsCutOffTowardsEachSide) {
  const BoundaryList list = Find(Room(10, {Block({5, 5}, 1)}), CornersOf(10), {.max_boundary = 46.432205101855956});
  ExpectAreas(list, {64, 64, 64, 64});
}

TEST(BestTest, ThreeBlocksOnADiagonal) {
  const World world = Room(200, {Block({50, 150}, 8), Block({100, 100}, 8), Block({150, 50}, 8)});
  std::vector<double> areas(4, 22136.0);
  areas.insert(areas.end(), 8, 21672.0);
  areas.insert(areas.end(), 8, 17008.0);
  ExpectAreas(Find(world, CornersOf(200), {.max_boundary = 1000}), areas);
}

TEST(BestTest, ThreeBlocksTwoOfThemInACorner) {
  const World world = Room(200, {Block({50, 150}, 8), Block({25, 170}, 8), Block({150, 50}, 8)});
  ExpectAreas(Find(world, CornersOf(200), {.max_boundary = 1050}),
              {27417, 27417, 27167, 27167, 24403, 24403, 24113, 24113, 22081, 21581, 19421,
               19381, 19067, 18777, 18572, 18572, 18272, 18272, 18272, 18032, 18032});
}

TEST(BestTest, BoundariesAtTheLimitCount) {
  const World world = Room(10, {Block({5, 5}, 1)});
  const double length = Find(world, CornersOf(10), {.max_boundary = 50}).boundaries.front().length;
  EXPECT_EQ(Find(world, CornersOf(10), {.max_boundary = length}).boundaries.size(), 4u);
  const BoundaryList none = Find(world, CornersOf(10), {.max_boundary = length * (1 - 1e-6)});
  EXPECT_TRUE(none.boundaries.empty());
  EXPECT_TRUE(none.complete);
  EXPECT_EQ(none.obstruction, WorkspaceObstruction::kNoBoundary);
}

TEST(BestTest, AnchorsInDifferentComponentsAreNotConnected) {
  const World world = Room(10, {Rectangle({4, 0}, {6, 10})});
  const BoundaryList list = Find(world, CornersOf(10), {.max_boundary = 100});
  EXPECT_EQ(list.obstruction, WorkspaceObstruction::kAnchorsUnconnected);
  EXPECT_TRUE(list.boundaries.empty());
}

TEST(BestTest, TasksMustBeHeld) {
  const World world = Room(10, {Block({5, 5}, 1)});
  BestOptions options{.max_boundary = 50, .tasks = {{5, 9}, {4, 8}}};
  const BoundaryList above = Find(world, CornersOf(10), options);
  const BoundaryList all = Find(world, CornersOf(10), {.max_boundary = 50});
  ASSERT_FALSE(above.boundaries.empty());
  EXPECT_LT(above.boundaries.size(), all.boundaries.size());
  const auto expected = std::count_if(all.boundaries.begin(), all.boundaries.end(), [&](const WorkspaceBoundary& b) {
    return std::all_of(options.tasks.begin(), options.tasks.end(), [&](Point p) { return ContainsPoint(b.ring, p); });
  });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(above.boundaries.size()), expected);
  options.tasks = {{5, 5}};
  EXPECT_EQ(Find(world, CornersOf(10), options).obstruction, WorkspaceObstruction::kNoBoundary);
}

TEST(BestTest, ASpentBudgetIsTold) {
  const World world = Room(200, {Block({50, 150}, 8), Block({100, 100}, 8), Block({150, 50}, 8)});
  const auto all = WordsOf(Find(world, CornersOf(200), {.max_boundary = 1000}));
  for (const std::int64_t budget : {0, 1, 10, 50, 100}) {
    const BoundaryList list = Find(world, CornersOf(200), {.max_boundary = 1000, .budget = budget});
    EXPECT_FALSE(list.complete) << budget;
    for (const auto& words : WordsOf(list)) EXPECT_TRUE(all.count(words));
  }
}

TEST(BestTest, StopsWhenToldTo) {
  int asked = 0;
  const World world = Room(200, {Block({50, 150}, 8), Block({100, 100}, 8), Block({150, 50}, 8)});
  const BoundaryList stopped =
      Find(world, CornersOf(200), {.max_boundary = 2500, .keep_going = [&asked] { return ++asked < 1; }});
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(asked, 1);
}

TEST(BestTest, TwelveAnchors) {
  const World world = Room(60, {Block({22, 25}, 3), Block({40, 36}, 4), Block({25, 44}, 2)});
  std::vector<Point> anchors;
  for (const double along : {0.0, 20.0, 40.0}) anchors.push_back({along, 0});
  for (const double along : {0.0, 20.0, 40.0}) anchors.push_back({60, along});
  for (const double along : {0.0, 20.0, 40.0}) anchors.push_back({60 - along, 60});
  for (const double along : {0.0, 20.0, 40.0}) anchors.push_back({0, 60 - along});
  const BoundaryList list = Find(world, anchors, {.max_boundary = 400});
  EXPECT_TRUE(list.complete);
  EXPECT_GT(list.boundaries.size(), 10u);
  for (const WorkspaceBoundary& boundary : list.boundaries) {
    EXPECT_LE(boundary.length, 400 * (1 + 1e-9));
    for (const Obstacle& obstacle : world.obstacles) {
      EXPECT_EQ(WindingNumber(boundary.ring, Lerp(obstacle.polygon->outer[0], obstacle.polygon->outer[2], 0.5)).number,
                0);
    }
  }
}

/// Every combination of classes, the longest of them as long as the others leave room for.
class BruteBoundaries {
 public:
  BruteBoundaries(const CableGround& ground, const Anchors& anchors, double limit)
      : ground_(ground), anchors_(anchors), limit_(limit) {
    for (const Socket& anchor : anchors_) limit_ -= 2 * anchor.stub_length;
    for (std::size_t i = 0; i < anchors.size(); ++i)
      shortest_.push_back(Classes(i, {.max_length = {}, .max_count = 1})[0].length);
    for (std::size_t i = 0; i < anchors.size(); ++i) {
      double others = 0;
      for (std::size_t k = 0; k < anchors.size(); ++k) others += k == i ? 0 : shortest_[k];
      sides_.push_back(limit_ > others ? Classes(i, {.max_length = limit_ - others, .max_count = kMostClasses})
                                       : std::vector<TautPath>());
    }
  }

  static constexpr std::size_t kMostClasses = 5000;

  /// How many combinations there are; infinite where there are too many classes to list.
  double Count() const {
    double count = 1;
    for (const auto& side : sides_) {
      count *= side.size() < kMostClasses ? static_cast<double>(side.size()) : std::numeric_limits<double>::infinity();
    }
    return count;
  }

  /// How many rings were held against their classes.
  std::int64_t checked() const { return checked_; }

  std::set<std::vector<Word>> Find() {
    Extend(0, limit_ * (1 + kLengthTolerance), Word());
    return found_;
  }

 private:
  std::vector<TautPath> Classes(std::size_t i, const ClassOptions& options) const {
    return FindClasses(ground_.space(), anchors_[i].exit.point, anchors_[NextAnchor(i, anchors_.size())].exit.point,
                       options)
        .classes;
  }

  void Extend(std::size_t i, double left, const Word& product) {
    if (i == anchors_.size()) {
      if (product.empty()) Close();
      return;
    }
    for (const TautPath& path : sides_[i]) {
      if (path.length > left) return;
      chosen_.push_back(&path);
      Extend(i + 1, left - path.length, product * path.word);
      chosen_.pop_back();
    }
  }

  void Close() {
    std::vector<Walk> walks;
    std::vector<Word> words;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      walks.push_back(WalkBetween(ground_, anchors_[i], anchors_[NextAnchor(i, anchors_.size())], *chosen_[i]));
      words.push_back(chosen_[i]->word);
    }
    const auto boundary = CloseBoundary(ground_, anchors_, walks);
    if (boundary) found_.insert(words);
    if (boundary || boundary.error().obstruction == WorkspaceObstruction::kCrossesItself) CheckCrossing(!boundary);
  }

  /// Whether sides cross is decided by triangles; the ring of points says the same where the anchors are on walls. It
  /// need not tell a crossing where it runs along itself.
  void CheckCrossing(bool crosses) {
    Ring ring;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (anchors_[i].stub_length > 0 || !EndsOnBoundary(ground_.space(), anchors_[i].exit)) return;
      ring.insert(ring.end(), chosen_[i]->points.begin(), chosen_[i]->points.end() - 1);
    }
    Ring sorted = ring;
    std::sort(sorted.begin(), sorted.end());
    const bool touches = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    if (touches && crosses) return;
    EXPECT_EQ(FindSelfCrossing(ring).has_value(), crosses) << testing::PrintToString(ring);
    ++checked_;
  }

  const CableGround& ground_;
  const Anchors& anchors_;
  double limit_;
  std::vector<double> shortest_;
  std::vector<std::vector<TautPath>> sides_;
  std::vector<const TautPath*> chosen_;
  std::set<std::vector<Word>> found_;
  std::int64_t checked_ = 0;
};

/// The shortest sides together, closed or not, with stubs.
double ShortestBoundary(const CableGround& ground, const Anchors& anchors) {
  double length = 0;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Socket& next = anchors[NextAnchor(i, anchors.size())];
    const auto list =
        FindClasses(ground.space(), anchors[i].exit.point, next.exit.point, {.max_length = {}, .max_count = 1});
    length += list.classes[0].length + 2 * next.stub_length;
  }
  return length;
}

/// Anchors around the outline, in order, some of them at its corners.
std::vector<Point> OutlineAnchors(Rng& rng, const World& world, int count) {
  const auto edges = static_cast<int>(world.outline.size());
  std::vector<std::pair<int, double>> places;
  for (int i = 0; i < count; ++i) {
    places.emplace_back(rng.UniformInt(0, edges - 1), rng.UniformInt(0, 1) == 0 ? 0 : 0.125 * rng.UniformInt(1, 7));
  }
  std::sort(places.begin(), places.end());
  std::vector<Point> anchors;
  for (const auto& [edge, along] : places) {
    const auto i = static_cast<std::size_t>(edge);
    anchors.push_back(Lerp(world.outline[i], world.outline[(i + 1) % world.outline.size()], along));
  }
  return anchors;
}

/// Around the outline as a rule; at times on any walls and islands in any order, and at times in the open.
std::vector<Point> RandomAnchors(Rng& rng, const RandomScene& scene) {
  const int count = rng.UniformInt(3, 5), kind = rng.UniformInt(0, 9);
  if (kind <= 5) return OutlineAnchors(rng, scene.world, count);
  std::vector<Point> anchors;
  for (int i = 0; i < count; ++i) {
    anchors.push_back(kind <= 7 ? random_scene::RandomBoundaryVertex(rng, scene) : RandomFreePoint(rng, scene));
  }
  return anchors;
}

/// Calls test(world, ground, anchors, rng) for random scenes whose anchors are connected.
template <class Test>
void ForRandomScenes(std::int64_t count, Test test) {
  for (std::int64_t seed = 1, done = 0; done < ScaledTestCount(count); ++seed) {
    Rng rng(static_cast<std::uint64_t>(seed));
    const RandomScene scene = MakeRandomScene(rng);
    World world = scene.world;
    if (rng.UniformInt(0, 3) == 0) world.clearance = 0.125;
    auto ground = CableGround::Prepare(world);
    if (!ground) continue;
    const auto anchors = PlaceAnchors(*ground, RandomAnchors(rng, scene));
    if (!anchors) continue;
    const bool connected = std::all_of(anchors->begin(), anchors->end(), [&](const Socket& anchor) {
      return ground->space().mesh().Connected((*anchors)[0].exit, anchor.exit);
    });
    if (!connected) continue;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    test(world, *ground, *anchors, rng);
    ++done;
  }
}

TEST(BestTest, EqualsAllCombinationsOfAllClasses) {
  constexpr double kMostCombinations = 1e5;
  std::int64_t results = 0, scenes = 0, full = 0, checked = 0;
  ForRandomScenes(400, [&](const World&, const CableGround& ground, const Anchors& anchors, Rng& rng) {
    const double limit = ShortestBoundary(ground, anchors) * rng.Uniform(1, 1.8);
    BruteBoundaries brute(ground, anchors, limit);
    if (brute.Count() > kMostCombinations) return;
    const BoundaryList list = FindBoundaries(ground, anchors, {.max_boundary = limit});
    EXPECT_TRUE(list.complete);
    EXPECT_EQ(WordsOf(list), brute.Find());
    ++scenes;
    checked += brute.checked();
    results += static_cast<std::int64_t>(list.boundaries.size());
    full += list.boundaries.empty() ? 0 : 1;
  });
  EXPECT_GE(scenes, ScaledTestCount(200));
  EXPECT_GE(full, ScaledTestCount(100));
  EXPECT_GE(results, ScaledTestCount(400));
  EXPECT_GE(checked, ScaledTestCount(200));
}

TEST(BestTest, MirroredScenesHaveTheSameAreas) {
  std::int64_t found = 0;
  ForRandomScenes(60, [&](const World& world, const CableGround& ground, const Anchors& anchors, Rng& rng) {
    // Grown corners, and exits that are equally near, need not be mirrored; neither is the mesh, in which an end in the
    // open crosses nothing.
    const bool on_walls = std::all_of(anchors.begin(), anchors.end(), [&](const Socket& anchor) {
      return EndsOnBoundary(ground.space(), anchor.exit);
    });
    if (world.clearance > 0 || !on_walls) return;
    const double limit = ShortestBoundary(ground, anchors) * rng.Uniform(1, 1.4);
    const BoundaryList list = FindBoundaries(ground, anchors, {.max_boundary = limit, .budget = 20'000});
    if (!list.complete) return;
    const auto changed = [&](double factor, double sign) {
      const auto moved = [=](Point p) { return Point{sign * factor * p.x, factor * p.y}; };
      World other = world;
      for (Point& p : other.outline) p = moved(p);
      for (Obstacle& obstacle : other.obstacles) {
        for (Point& p : obstacle.polygon->outer) p = moved(p);
      }
      other.clearance *= factor;
      std::vector<Point> points;
      for (const Socket& anchor : anchors) points.push_back(moved(anchor.base));
      return Find(other, points, {.max_boundary = factor * limit});
    };
    const BoundaryList mirrored = changed(1, -1), doubled = changed(2, 1);
    ExpectAreas(mirrored, AreasOf(list, 1));
    ExpectAreas(doubled, AreasOf(list, 4));
    found += static_cast<std::int64_t>(list.boundaries.size());
  });
  // Of a few scenes, all may be among those left out.
  EXPECT_GE(found, ScaledTestCount(50) - 3);
}

TEST(BestTest, WordsMultiplyToTheEmptyWordAndTheOrderIsByArea) {
  std::int64_t found = 0;
  ForRandomScenes(200, [&](const World&, const CableGround& ground, const Anchors& anchors, Rng& rng) {
    const double limit = ShortestBoundary(ground, anchors) * rng.Uniform(1, 1.5);
    const BoundaryList list = FindBoundaries(ground, anchors, {.max_boundary = limit, .budget = 20'000});
    for (std::size_t i = 0; i < list.boundaries.size(); ++i) {
      const WorkspaceBoundary& boundary = list.boundaries[i];
      Word product;
      for (const BoundarySide& side : boundary.sides) product.Append(side.path.word);
      EXPECT_TRUE(product.empty());
      EXPECT_LE(boundary.length, limit * (1 + kLengthTolerance));
      EXPECT_NEAR(boundary.length, Length(boundary.ring) + Distance(boundary.ring.back(), boundary.ring.front()),
                  1e-9 * limit);
      EXPECT_LE(boundary.area, list.boundaries[i > 0 ? i - 1 : 0].area * (1 + 1e-8));
    }
    found += static_cast<std::int64_t>(list.boundaries.size());
  });
  EXPECT_GE(found, ScaledTestCount(400));
}

TEST(BestTest, AnEndedSearchKnowsTheShorterBoundaries) {
  std::int64_t told = 0;
  ForRandomScenes(200, [&](const World&, const CableGround& ground, const Anchors& anchors, Rng& rng) {
    const double limit = ShortestBoundary(ground, anchors) * rng.Uniform(1.2, 1.6);
    const BoundaryList all = FindBoundaries(ground, anchors, {.max_boundary = limit, .budget = 20'000});
    if (!all.complete) return;
    const BoundaryList some =
        FindBoundaries(ground, anchors, {.max_boundary = limit, .budget = rng.UniformInt(1, 300)});
    const auto known = WordsOf(some);
    for (const WorkspaceBoundary& boundary : all.boundaries) {
      const bool promised = boundary.length <= some.complete_length * (1 - 1e-8);
      EXPECT_TRUE(!promised || known.count(WordsOf(boundary)) == 1);
    }
    told += !some.complete && !some.boundaries.empty() ? 1 : 0;
  });
  EXPECT_GE(told, ScaledTestCount(5));
}

}  // namespace
}  // namespace tautline
