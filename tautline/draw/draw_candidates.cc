#include "tautline/draw/draw_candidates.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/workspace_panels.h"

namespace tautline {
namespace {

constexpr std::size_t kMostShown = 12;

std::string Percent(double share) { return CompactText(100 * share, 2) + " %"; }

std::string WordsText(const WorkspaceBoundary& boundary, const FreeSpace& space) {
  const std::vector<std::string> names = NamesOf(space);
  std::string text;
  for (const BoundarySide& side : boundary.sides) {
    const std::string word = ToString(side.path.word, names);
    text += (text.empty() ? "" : " | ") + (word.empty() ? std::string("-") : word);
  }
  return text;
}

std::vector<Point> AnchorsOf(const Scene& scene) { return scene.cables ? scene.cables->anchors : std::vector<Point>{}; }

}  // namespace

std::string DrawCandidates(const Scene& scene, const FreeSpace& space, const CandidatesPicture& picture) {
  PanelsContent content;
  const std::string limit =
      LengthText(picture.max_boundary, LengthDecimals(std::max(space.box.size().x, space.box.size().y)));
  const bool expects = !picture.candidates.empty() && picture.candidates[0].futures != nullptr;
  content.title = picture.candidates.empty()
                      ? "No way to lay the cables within a boundary of " + limit
                      : std::to_string(picture.found) + (picture.found == 1 ? " workspace" : " workspaces") +
                            " within a boundary of " + limit + ", the largest " + (expects ? "expected " : "") +
                            "area first";
  if (!picture.explanation.empty()) content.notes.push_back(picture.explanation + ".");
  const std::size_t shown = std::min(kMostShown, picture.candidates.size());
  if (shown < picture.found) content.notes.push_back("Shown are the first " + std::to_string(shown) + ".");
  content.notes.emplace_back(scene.tasks.empty() ? "Dots are winches." : "Dots are winches, squares are tasks.");
  std::vector<WorkspacePanel> panels;
  for (std::size_t i = 0; i < shown; ++i) {
    const Candidate& candidate = picture.candidates[i];
    const WorkspaceBoundary& boundary = *candidate.boundary;
    std::string title = std::to_string(i + 1) + ": " + AreaText(boundary.area);
    std::vector<std::string> notes;
    if (candidate.futures != nullptr) {
      title += ", expected " + AreaText(candidate.futures->expected_area);
      const double lost = candidate.futures->lost_probability;
      notes.push_back(lost > 0 ? "lost with " + Percent(lost) : "valid in every future");
    }
    notes.push_back("boundary " + LengthText(boundary.length, 1));
    notes.push_back(WordsText(boundary, space));
    panels.push_back({.world = &scene.world,
                      .space = &space,
                      .title = std::move(title),
                      .notes = std::move(notes),
                      .anchors = AnchorsOf(scene),
                      .boundary = boundary.ring,
                      .tasks = scene.tasks});
  }
  if (panels.empty()) {
    panels.push_back({.world = &scene.world,
                      .space = &space,
                      .title = "the winches",
                      .notes = {},
                      .anchors = AnchorsOf(scene),
                      .boundary = {},
                      .tasks = scene.tasks});
  }
  return DrawWorkspacePanels(content, panels);
}

std::string DrawFutures(const Scene& scene, const FreeSpace& space, const WorkspaceBoundary& boundary,
                        const Futures& futures, const FutureOutcomes& outcomes) {
  PanelsContent content{.title = "Expected workspace " + AreaText(outcomes.expected_area) + ", now " +
                                 AreaText(boundary.area)};
  if (outcomes.lost_probability > 0) {
    content.notes.push_back("With " + Percent(outcomes.lost_probability) +
                            " there is no workspace; that counts as no area.");
  }
  std::vector<WorkspacePanel> panels = {{.world = &scene.world,
                                         .space = &space,
                                         .title = "now: " + AreaText(boundary.area),
                                         .notes = {WordsText(boundary, space)},
                                         .anchors = AnchorsOf(scene),
                                         .boundary = boundary.ring,
                                         .tasks = scene.tasks}};
  for (std::size_t i = 0; i < outcomes.outcomes.size(); ++i) {
    const FutureOutcome& outcome = outcomes.outcomes[i];
    const FreeSpace& there = futures.ground(i).space().free_space();
    WorkspacePanel panel{
        .world = &futures.world(i), .space = &there, .anchors = AnchorsOf(scene), .tasks = scene.tasks};
    panel.title = Percent(outcome.probability) + ": ";
    if (outcome.boundary) {
      panel.title += AreaText(outcome.boundary->area);
      panel.notes = {WordsText(*outcome.boundary, there)};
      panel.boundary = outcome.boundary->ring;
    } else {
      panel.title += "no workspace";
      panel.notes = {outcome.boundary.error().explanation};
      panel.sides = outcome.boundary.error().curves;
    }
    for (const ObstacleMove& move : scene.futures[i].moves) panel.moves.push_back(move.path);
    panels.push_back(std::move(panel));
  }
  return DrawWorkspacePanels(content, panels);
}

}  // namespace tautline
