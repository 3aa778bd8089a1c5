// Workspaces of cables on small lattice scenes: nothing throws, boundaries are what they claim to be, and the mirror
// image has the same answer.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fuzz/byte_source.h"
#include "fuzz/check_answer.h"
#include "fuzz/lattice_world.h"
#include "tautline/base/check.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/planners/cable_workspace/best.h"
#include "tautline/planners/cable_workspace/boundary.h"
#include "tautline/planners/cable_workspace/pose.h"
#include "tautline/planners/cable_workspace/region.h"

namespace tautline::fuzz {
namespace {

struct Question {
  World world;
  Cables cables;
  std::vector<Point> poses;
};

/// Around the middle of the lattice, so that sides need not cross.
void SortAround(Point centre, std::vector<Point>& points) {
  std::sort(points.begin(), points.end(), [centre](Point a, Point b) {
    return std::pair(std::atan2(a.y - centre.y, a.x - centre.x), a) <
           std::pair(std::atan2(b.y - centre.y, b.x - centre.x), b);
  });
}

Cables AnyCables(ByteSource& bytes, Lattice& lattice) {
  Cables cables;
  const int count = bytes.Int(3, 6);
  const std::vector<Point> corners{lattice.At(0, 0), lattice.At(15, 0), lattice.At(15, 15), lattice.At(0, 15)};
  for (int i = 0; i < count; ++i) {
    const int corner = bytes.Int(0, 7);
    cables.anchors.push_back(corner < 4 ? corners[static_cast<std::size_t>(corner)] : lattice.HalfNode());
  }
  if (bytes.Int(0, 3) > 0) SortAround(lattice.At(7.5, 7.5), cables.anchors);
  const Point robot = lattice.HalfNode();
  cables.laid.emplace();
  for (const Point anchor : cables.anchors) {
    Polyline laid{robot};
    for (int bends = std::max(0, bytes.Int(-3, 2)); bends > 0; --bends) laid.push_back(lattice.HalfNode());
    laid.push_back(anchor);
    cables.laid->push_back(std::move(laid));
  }
  return cables;
}

Question AnyQuestion(ByteSource& bytes, Lattice& lattice) {
  Question question;
  question.cables = AnyCables(bytes, lattice);
  question.poses = {question.cables.laid->front().front(), question.cables.anchors[0], lattice.HalfNode()};
  question.world = AnyWorld(lattice);
  question.world.clearance = lattice.spacing() * bytes.Pick({0.0, 0.0, 0.0, 0.5, 0.01});
  return question;
}

Question Mirrored(Question question) {
  const auto mirror = [](std::vector<Point>& points) {
    for (Point& p : points) p.y = -p.y;
  };
  mirror(question.world.outline);
  for (Obstacle& obstacle : question.world.obstacles) {
    if (obstacle.circle) obstacle.circle->centre.y = -obstacle.circle->centre.y;
    if (!obstacle.polygon) continue;
    mirror(obstacle.polygon->outer);
    for (Ring& hole : obstacle.polygon->holes) mirror(hole);
  }
  mirror(question.cables.anchors);
  for (Polyline& laid : *question.cables.laid) mirror(laid);
  mirror(question.poses);
  return question;
}

/// What is compared with the mirror image.
struct Answer {
  bool is_world = false;
  bool has_anchors = false;
  bool has_stub = false;  ///< An anchor stands in the clearance.
  WorkspaceObstruction obstruction = WorkspaceObstruction::kNone;
  double area = 0;
  double length = 0;
  std::vector<Containment> positions;
};

void CheckBoundary(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary) {
  Word product;
  std::vector<Word> words;
  for (const BoundarySide& side : boundary.sides) {
    const auto faults = CurveFaults(ground.space().free_space(), side.path);
    if (!faults.empty()) throw std::logic_error("a side " + faults[0]);
    product.Append(side.path.word);
    words.push_back(side.path.word);
  }
  TAUTLINE_CHECK(product.empty());
  TAUTLINE_CHECK(boundary.area > 0);
  for (const Island& island : ground.space().free_space().islands) {
    TAUTLINE_CHECK(WindingNumber(boundary.ring, island.representative).number == 0);
  }
  const auto again = BoundaryOfWords(ground, anchors, words);
  TAUTLINE_CHECK(again.has_value());
  TAUTLINE_CHECK(again->ring == boundary.ring);
}

Containment CheckPose(const WorkspaceRegion& region, const std::vector<LongestCable>& longest, Point at) {
  const Pose pose = LookAtPose(region, at);
  TAUTLINE_CHECK(pose.cables.empty() == (pose.position == Containment::kOutside));
  TAUTLINE_CHECK(pose.spans || pose.position != Containment::kInside);
  const double tolerance = 4 * region.ground().space().tolerance();
  for (std::size_t i = 0; i < pose.cables.size(); ++i) {
    TAUTLINE_CHECK(pose.cables[i].length <= longest[i].length * (1 + 1e-9) + tolerance);
  }
  return pose.position;
}

/// The best boundaries within a small budget hold what they were asked to hold.
void CheckBest(const CableGround& ground, const Anchors& anchors, const WorkspaceBoundary& boundary) {
  const BoundaryList list =
      FindBoundaries(ground, anchors, {.max_boundary = 1.01 * boundary.length, .tasks = {}, .budget = 300});
  bool found = false;
  for (const WorkspaceBoundary& other : list.boundaries) {
    TAUTLINE_CHECK(other.length <= 1.0101 * boundary.length);
    found = found || other.ring == boundary.ring;
  }
  TAUTLINE_CHECK(found || !list.complete);
}

Answer Ask(const Question& question) {
  const auto ground = CableGround::Prepare(question.world);
  CheckAnswer(ground);
  if (!ground) return {};
  const auto anchors = PlaceAnchors(*ground, question.cables.anchors);
  if (!anchors) return {.is_world = true};
  Answer answer{.is_world = true, .has_anchors = true};
  for (const Socket& anchor : *anchors) answer.has_stub = answer.has_stub || anchor.stub_length > 0;
  const auto boundary = BoundaryOfCables(*ground, *anchors, *question.cables.laid);
  if (!boundary) {
    TAUTLINE_CHECK(!boundary.error().explanation.empty());
    answer.obstruction = boundary.error().obstruction;
    return answer;
  }
  CheckBoundary(*ground, *anchors, *boundary);
  answer.area = boundary->area;
  answer.length = boundary->length;
  const WorkspaceRegion region(*ground, *anchors, *boundary);
  const auto longest = LongestCables(*ground, *anchors, *boundary);
  for (const Point at : question.poses) answer.positions.push_back(CheckPose(region, longest, at));
  CheckBest(*ground, *anchors, *boundary);
  return answer;
}

/// Equal to rounding. An anchor in the clearance is led out by the nearest way, of which there may be two.
void CheckSame(const Answer& one, const Answer& other) {
  TAUTLINE_CHECK(one.is_world == other.is_world);
  if (one.has_stub || other.has_stub) return;
  TAUTLINE_CHECK(one.has_anchors == other.has_anchors);
  TAUTLINE_CHECK(one.obstruction == other.obstruction);
  TAUTLINE_CHECK(std::fabs(one.area - other.area) <= 1e-6 * one.length * one.length);
  TAUTLINE_CHECK(std::fabs(one.length - other.length) <= 1e-6 * one.length);
  TAUTLINE_CHECK(one.positions == other.positions);
}

void Run(ByteSource bytes) {
  const double spacing = bytes.Pick({1.0, 1.0, 0.125, 0.1, 1e3});
  const bool far = bytes.Int(0, 3) == 3;
  Lattice lattice(bytes, spacing, far ? Point{9e6, -8e6} : Point{0, 0});
  const Question question = AnyQuestion(bytes, lattice);
  CheckSame(Ask(question), Ask(Mirrored(question)));
}

}  // namespace
}  // namespace tautline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tautline::fuzz::Run(tautline::fuzz::ByteSource({data, size}));
  return 0;
}
