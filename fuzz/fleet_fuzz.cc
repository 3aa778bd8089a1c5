// Fleets on small lattice scenes: nothing throws, every plan that is made brings its layout about when it is played,
// and the mirror image has the same answer.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/byte_source.h"
#include "fuzz/check_answer.h"
#include "fuzz/lattice_world.h"
#include "tautline/base/check.h"
#include "tautline/planners/fleet/check_layout.h"
#include "tautline/planners/fleet/choose_layout.h"
#include "tautline/planners/fleet/layouts.h"
#include "tautline/planners/fleet/plan_fleet.h"
#include "tautline/planners/fleet/playback.h"

namespace tautline::fuzz {
namespace {

/// Where the layout comes from.
enum class Source { kGiven, kFound, kChosen };

struct Question {
  Scene scene;
  Source source = Source::kGiven;
  std::size_t which = 0;  ///< Of the layouts found.
};

Fleet AnyFleet(ByteSource& bytes, Lattice& lattice, bool with_cables) {
  Fleet fleet;
  const int count = bytes.Int(2, 5);
  for (int i = 1; i <= count; ++i) {
    FleetRobot robot;
    robot.name = "r" + std::to_string(i);
    robot.start = lattice.HalfNode();
    robot.target = lattice.HalfNode();
    robot.speed = lattice.spacing() * bytes.Pick({1.0, 1.0, 0.5, 3.0});
    fleet.robots.push_back(robot);
  }
  for (FleetRobot& robot : fleet.robots) {
    if (!with_cables) continue;
    robot.cable = Polyline{robot.start};
    for (int bends = std::max(0, bytes.Int(-2, 2)); bends > 0; --bends) {
      robot.cable->push_back(fleet.robots[static_cast<std::size_t>(bytes.Int(0, count - 1))].target);
    }
    robot.cable->push_back(robot.target);
  }
  return fleet;
}

Question AnyQuestion(ByteSource& bytes, Lattice& lattice) {
  Question question;
  question.source = bytes.Pick({Source::kGiven, Source::kFound, Source::kChosen});
  question.which = static_cast<std::size_t>(bytes.Int(0, 7));
  question.scene.fleet = AnyFleet(bytes, lattice, question.source == Source::kGiven);
  if (bytes.Int(0, 2) == 2) question.scene.world = AnyWorld(lattice);
  return question;
}

Question Mirrored(Question question) {
  const auto mirror = [](std::vector<Point>& points) {
    for (Point& p : points) p.y = -p.y;
  };
  mirror(question.scene.world.outline);
  for (Obstacle& obstacle : question.scene.world.obstacles) {
    if (obstacle.circle) obstacle.circle->centre.y = -obstacle.circle->centre.y;
    if (!obstacle.polygon) continue;
    mirror(obstacle.polygon->outer);
    for (Ring& hole : obstacle.polygon->holes) mirror(hole);
  }
  for (FleetRobot& robot : question.scene.fleet->robots) {
    robot.start.y = -robot.start.y;
    robot.target.y = -robot.target.y;
    if (robot.cable) mirror(*robot.cable);
  }
  return question;
}

/// What is compared with the mirror image.
struct Answer {
  bool is_ground = false;
  bool has_layout = false;
  bool is_sound = false;
  bool has_plan = false;
  std::size_t passings = 0, pair_deadlocks = 0, detours = 0;
  double travel_time = 0;
};

template <class Fault>
void CheckExplained(const FleetGround& ground, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) TAUTLINE_CHECK(!Explain(ground, fault).empty());
}

/// Whether every robot can stand at its ends: what a search asks for.
bool CanStand(const FleetGround& ground) {
  if (ground.space() == nullptr) return true;
  return std::all_of(ground.robots().begin(), ground.robots().end(), [&](const FleetRobot& robot) {
    return ground.space()->Locate(robot.start) && ground.space()->Locate(robot.target);
  });
}

std::optional<FleetLayout> AnyLayout(const FleetGround& ground, const Question& question) {
  if (question.source == Source::kGiven) {
    auto layout = ReadLayout(ground);
    if (layout) return *std::move(layout);
    TAUTLINE_CHECK(!Explain(ground, layout.error()).empty());
    return std::nullopt;
  }
  if (!CanStand(ground)) return std::nullopt;
  if (question.source == Source::kFound) {
    const LayoutsResult found = FindLayouts(ground, {.max_count = 8, .budget = 2'000});
    if (found.layouts.empty()) return std::nullopt;
    return found.layouts[question.which % found.layouts.size()].routes;
  }
  const ChosenLayout chosen = ChooseLayout(ground, {.budget = 40});
  TAUTLINE_CHECK((chosen.status == ChooseStatus::kSolved) == chosen.explanation.empty());
  if (chosen.status != ChooseStatus::kSolved) return std::nullopt;
  const FleetPlan plan = PlanFleet(ground, chosen.layout).value();
  TAUTLINE_CHECK(plan.modes[0].realizable);
  TAUTLINE_CHECK(std::fabs(plan.travel_time - chosen.travel_time) <= 1e-6 * chosen.travel_time);
  return chosen.layout;
}

void CheckPlayed(const FleetGround& ground, const FleetLayout& layout, const FleetPlan& plan) {
  const auto playback = Play(ground, layout, plan.schedule, PassingsToKeep(plan));
  TAUTLINE_CHECK(playback.has_value());
  TAUTLINE_CHECK(playback->matches());
}

Answer Ask(const Question& question) {
  const auto ground = FleetGround::Prepare(question.scene);
  CheckAnswer(ground);
  if (!ground) return {};
  Answer answer{.is_ground = true};
  const auto layout = AnyLayout(*ground, question);
  if (!layout) return answer;
  answer.has_layout = true;
  const LayoutFaults faults = CheckLayout(*ground, *layout);
  CheckExplained(*ground, faults.crossings);
  CheckExplained(*ground, faults.self_loops);
  CheckExplained(*ground, faults.starts_enclosed);
  CheckExplained(*ground, faults.short_tethers);
  answer.is_sound = faults.none();
  TAUTLINE_CHECK(answer.is_sound || question.source == Source::kGiven);
  if (!answer.is_sound) return answer;
  const auto found = PlanFleet(*ground, *layout);
  if (!found) {
    TAUTLINE_CHECK(!Explain(*ground, found.error()).empty());
    return answer;
  }
  answer.has_plan = true;
  const FleetPlan& plan = *found;
  CheckPlayed(*ground, *layout, plan);
  answer.passings = plan.passings.size();
  answer.pair_deadlocks = plan.pair_deadlocks.size();
  answer.detours = plan.detours.size();
  answer.travel_time = plan.travel_time;
  for (const FleetMode mode :
       {FleetMode::kStraightSequential, FleetMode::kBentConcurrent, FleetMode::kBentSequential}) {
    CheckPlayed(*ground, *layout, PlanFleet(*ground, *layout, {.mode = mode}).value());
  }
  return answer;
}

/// Equal to rounding. Layouts that a search finds are listed by length, and equal ones in any order.
void CheckSame(const Question& question, const Answer& one, const Answer& other) {
  TAUTLINE_CHECK(one.is_ground == other.is_ground);
  if (question.source != Source::kGiven) return;
  TAUTLINE_CHECK(one.has_layout == other.has_layout);
  TAUTLINE_CHECK(one.is_sound == other.is_sound);
  TAUTLINE_CHECK(one.has_plan == other.has_plan);
  TAUTLINE_CHECK(one.passings == other.passings);
  TAUTLINE_CHECK(one.pair_deadlocks == other.pair_deadlocks);
  TAUTLINE_CHECK(one.detours == other.detours);
  TAUTLINE_CHECK(std::fabs(one.travel_time - other.travel_time) <= 1e-6 * one.travel_time);
}

void Run(ByteSource bytes) {
  const double spacing = bytes.Pick({1.0, 1.0, 0.125, 0.1, 1e3});
  const bool far = bytes.Int(0, 3) == 3;
  Lattice lattice(bytes, spacing, far ? Point{9e6, -8e6} : Point{0, 0});
  const Question question = AnyQuestion(bytes, lattice);
  CheckSame(question, Ask(question), Ask(Mirrored(question)));
}

}  // namespace
}  // namespace tautline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tautline::fuzz::Run(tautline::fuzz::ByteSource({data, size}));
  return 0;
}
