#include "apps/pictures/fleet_pictures.h"

#include <algorithm>

#include "tautline/draw/draw_fleet.h"
#include "tautline/draw/workspace_layers.h"

namespace tautline {
namespace {

constexpr std::size_t kMostNotes = 5;  // Explanations above the map; the JSON has all.

/// The first explanations as notes.
std::vector<std::string> NotesOf(const std::vector<std::string>& explanations) {
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < std::min(explanations.size(), kMostNotes); ++i) {
    notes.push_back(Sentence(explanations[i]));
  }
  if (explanations.size() > kMostNotes) {
    notes.push_back("And " + std::to_string(explanations.size() - kMostNotes) + " more.");
  }
  return notes;
}

/// What is wrong with the layout, where it is.
std::vector<LayoutMark> MarksOf(const CheckAnswer& answer) {
  const FleetSetup& setup = answer.setup;
  if (!*setup.layout) return {{setup.layout->error().at, setup.name(setup.layout->error().robot)}};
  std::vector<LayoutMark> marks;
  for (const LayoutCrossing& fault : answer.faults.crossings) {
    marks.push_back({fault.crossing.at, setup.name(fault.a) + " and " + setup.name(fault.b) + " cross"});
  }
  for (const SelfLoop& fault : answer.faults.self_loops) {
    marks.push_back({fault.at, setup.name(fault.robot) + " loops"});
  }
  for (const EnclosedStart& fault : answer.faults.starts_enclosed) {
    marks.push_back({setup.ground.robot(fault.robot).start, setup.name(fault.by) + " encloses this start"});
  }
  for (const ShortTether& fault : answer.faults.short_tethers) {
    marks.push_back({setup.ground.robot(fault.robot).target, "too far for " + setup.name(fault.robot)});
  }
  return marks;
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const CheckAnswer& answer) {
  const auto& layout = *answer.setup.layout;
  const bool solved = answer.status == kExitSolved;
  return DrawLayout(scene, answer.setup.ground,
                    {.title = solved ? "The layout is free of crossings" : "The layout cannot be made",
                     .notes = NotesOf(answer.explanations),
                     .layout = layout ? &*layout : nullptr,
                     .marks = MarksOf(answer)});
}

std::string DrawAnswer(const Scene& scene, const LayoutsAnswer& answer) {
  const FleetGround& ground = answer.setup.ground;
  const std::size_t count = answer.result.layouts.size();
  if (count == 0) {
    const FleetLayout none;
    return DrawLayout(scene, ground,
                      {.title = "No layout", .notes = NotesOf({answer.explanation}), .layout = &none, .marks = {}});
  }
  LayoutsPicture picture{.title = std::to_string(count) + (count == 1 ? " layout" : " layouts, the shortest first"),
                         .notes = {},
                         .layouts = {}};
  if (answer.result.complete) picture.title += "; there are no more up to the limits";
  for (const FoundLayout& found : answer.result.layouts) picture.layouts.push_back(&found.routes);
  if (count > kMostLayoutsDrawn) {
    picture.notes = {"The first " + std::to_string(kMostLayoutsDrawn) + " are drawn."};
  }
  return DrawLayouts(scene, ground, picture);
}

std::string DrawAnswer(const Scene& scene, const FleetPlanAnswer& answer) {
  const FleetGround& ground = answer.setup.ground;
  if (answer.plan) return DrawFleetPlan(scene, ground, {.layout = answer.layout(), .plan = *answer.plan});
  const auto& layout = answer.setup.layout;
  return DrawLayout(scene, ground,
                    {.title = "No plan",
                     .notes = NotesOf({answer.explanation}),
                     .layout = layout && *layout ? &**layout : nullptr,
                     .marks = {}});
}

std::string AnimateAnswer(const Scene& scene, const FleetPlanAnswer& answer) {
  if (!answer.plan || !answer.played) return DrawAnswer(scene, answer);
  return AnimateFleet(scene, answer.setup.ground,
                      {.layout = answer.layout(), .plan = *answer.plan, .frames = answer.played->frames});
}

std::string DrawAnswer(const Scene& scene, const SimulateAnswer& answer) {
  const auto& layout = *answer.setup.layout;
  if (answer.playback) {
    return DrawSimulate(scene, answer.setup.ground, {.layout = *layout, .playback = *answer.playback});
  }
  return DrawLayout(scene, answer.setup.ground,
                    {.title = "It does not come out",
                     .notes = NotesOf({answer.explanation}),
                     .layout = layout ? &*layout : nullptr,
                     .marks = {}});
}

std::string AnimateAnswer(const Scene& scene, const SimulateAnswer& answer) {
  if (!answer.playback) return DrawAnswer(scene, answer);
  FleetPlan motion;
  motion.schedule = answer.schedule;
  motion.travel_time = answer.playback->frames.back().t;
  return AnimateFleet(
      scene, answer.setup.ground,
      {.layout = **answer.setup.layout,
       .plan = motion,
       .frames = answer.playback->frames,
       .title = answer.playback->differing.empty() ? "The layout comes out" : "The layout does not come out"});
}

}  // namespace tautline
