#include "tautline/draw/draw_plan.h"

#include <algorithm>

#include "tautline/draw/blocked_parts.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/numbered_lines.h"
#include "tautline/draw/obstacle_names.h"
#include "tautline/draw/tether_layers.h"

namespace tautline {
namespace {

/// What the parts of the picture look up: the problem, the answer, and how lengths are written.
struct Case {
  const Scene& scene;
  const FreeSpace& space;
  const PlanResult& result;
  int decimals = 2;

  std::string Metres(double length) const { return LengthText(length, decimals); }
};

/// The shortest motion, on which the cable would cross itself; nullptr where it is the answer.
const Motion* PlainMotion(const PlanResult& result) {
  return result.crossing_free && result.crossing_free->plain ? &*result.crossing_free->plain : nullptr;
}

/// As many decimals as it takes to see which of two compared lengths is the longer one.
int EnoughDecimals(const FreeSpace& space, const PlanResult& result) {
  int decimals = LengthDecimals(space);
  const auto compare = [&](double a, double b) { decimals = DecimalsToTellApart(a, b, decimals); };
  if (result.motion) compare(result.motion->tether.length, result.limit);
  if (result.rejected) compare(result.rejected->tether.length, result.limit);
  if (result.shortest_tether) compare(result.shortest_tether->length, result.limit);
  if (result.motion && result.rejected) compare(result.motion->path.length, result.rejected->path.length);
  if (PlainMotion(result) != nullptr) compare(result.motion->path.length, PlainMotion(result)->path.length);
  // Lengths that differ by rounding alone would show nothing but digits.
  return std::min(decimals, LengthDecimals(space) + 4);
}

std::string Title(const Case& c) {
  const PlanResult& result = c.result;
  if (result.motion) {
    return "Robot path " + c.Metres(result.motion->path.length) + "; at the goal the tether takes " +
           c.Metres(result.motion->tether.length) + " of " + c.Metres(result.limit);
  }
  if (result.status == PlanStatus::kBudgetExceeded) return "The search stopped at its budget before it had an answer";
  switch (result.obstruction) {
    case PlanObstruction::kStartBlocked:
      return "No plan: the robot stands on blocked ground";
    case PlanObstruction::kGoalBlocked:
      return "No plan: the goal lies on blocked ground";
    case PlanObstruction::kGoalUnreachable:
      return "No plan: robot and goal are on separate pieces of ground";
    case PlanObstruction::kLaidCableBlocked:
      return "No plan: the laid cable runs through blocked ground";
    case PlanObstruction::kLaidCableTooLong:
      return "No plan: pulled tight, the laid cable needs " + c.Metres(result.start.length) + ", the tether has " +
             c.Metres(result.limit);
    case PlanObstruction::kTetherTooShort:
      if (!result.shortest_tether) return "No plan: the tether is too short";
      return "No plan: the goal needs " + c.Metres(result.shortest_tether->length) + " of tether, the limit is " +
             c.Metres(result.limit);
    case PlanObstruction::kMustCross:
      return "No plan without a crossing: pulled tight, the laid cable crosses itself";
    case PlanObstruction::kNone:
      break;
  }
  return "No plan";
}

std::vector<std::string> Notes(const Case& c) {
  std::vector<std::string> notes;
  if (!c.result.explanation.empty()) notes.push_back(c.result.explanation);
  if (c.result.motion && c.result.rejected) {
    notes.push_back("The path of " + c.Metres(c.result.rejected->path.length) + " would be shorter, but would need " +
                    c.Metres(c.result.rejected->tether.length) + " of tether.");
  }
  if (PlainMotion(c.result) != nullptr) {
    notes.push_back("On the path of " + c.Metres(PlainMotion(c.result)->path.length) +
                    ", the shortest, the cable would cross itself.");
  }
  if (c.result.crossing_free && !c.result.crossing_free->optimal) {
    notes.push_back("The budget ran out: a path without a crossing may be shorter, but not than " +
                    c.Metres(c.result.crossing_free->bound) + ".");
  }
  return notes;
}

/// The components of robot and goal, where they are separate.
struct Pieces {
  std::optional<std::size_t> robot;
  std::optional<std::size_t> goal;
};

Pieces FindPieces(const Case& c) {
  if (c.result.obstruction != PlanObstruction::kGoalUnreachable || !c.scene.tether || !c.scene.goal) return {};
  return {ComponentOf(c.space, RobotPosition(*c.scene.tether), c.space.snap),
          ComponentOf(c.space, *c.scene.goal, c.space.snap)};
}

std::vector<std::string> Tints(const Case& c, const Pieces& pieces) {
  std::vector<std::string> tints;
  if (!pieces.robot && !pieces.goal) return tints;
  tints.assign(c.space.components.size(), kFreeColour);
  if (pieces.robot) tints[*pieces.robot] = ComponentTint(1);
  if (pieces.goal) tints[*pieces.goal] = ComponentTint(2);
  return tints;
}

void AppendPieceEntries(const Case& c, const Pieces& pieces, std::vector<LegendEntry>& legend) {
  const auto append = [&](std::optional<std::size_t> piece, int tint, const std::string& text) {
    if (!piece) return;
    legend.push_back({GroundSwatch{.fill = ComponentTint(tint)}, text, {AreaText(c.space.components[*piece].area)}});
  };
  append(pieces.robot, 1, "where the robot can go");
  append(pieces.goal, 2, "the piece of the goal");
}

/// The classes besides the chosen one.
std::vector<NumberedLine> OtherClasses(const Case& c) {
  std::vector<NumberedLine> lines;
  for (std::size_t i = 0; i < c.result.all.size(); ++i) {
    const Motion& motion = c.result.all[i];
    if (c.result.motion && motion.path.points == c.result.motion->path.points) continue;
    lines.push_back({.points = motion.path.points,
                     .number = static_cast<int>(i) + 1,
                     .text = "path " + c.Metres(motion.path.length) + ", tether " + c.Metres(motion.tether.length),
                     .details = {WordText(motion.tether.word, c.space)}});
  }
  return lines;
}

void AppendMotionEntries(const Case& c, std::vector<LegendEntry>& legend) {
  const PlanResult& result = c.result;
  if (result.motion) {
    legend.push_back({kPathLine, "robot path " + c.Metres(result.motion->path.length)});
    legend.push_back({kGoalTetherLine,
                      "tether at the goal " + c.Metres(result.motion->tether.length),
                      {"limit " + c.Metres(result.limit), WordText(result.motion->tether.word, c.space)}});
  }
  if (result.start.points.size() > 1) {
    legend.push_back({kStartTetherLine,
                      "tether at the start " + c.Metres(result.start.length),
                      {WordText(result.start.word, c.space)}});
  }
  AppendLaidEntry(c.scene, c.decimals, legend);
  if (const Motion* plain = PlainMotion(result)) {
    legend.push_back({kCrossingLine,
                      "shorter path " + c.Metres(plain->path.length) + ", the cable crosses itself",
                      {WordText(plain->tether.word, c.space)}});
  }
  if (result.rejected) {
    legend.push_back(
        {kRejectedLine,
         (result.motion ? "shorter path " : "shortest path ") + c.Metres(result.rejected->path.length) + ", rejected",
         {"would need " + c.Metres(result.rejected->tether.length) + " of tether, limit " + c.Metres(result.limit),
          WordText(result.rejected->tether.word, c.space)}});
  }
}

void AppendShortfallEntries(const Case& c, std::vector<LegendEntry>& legend) {
  const PlanResult& result = c.result;
  if (result.shortest_tether) {
    legend.push_back({kGoalTetherLine,
                      "least tether to the goal " + c.Metres(result.shortest_tether->length),
                      {"limit " + c.Metres(result.limit), WordText(result.shortest_tether->word, c.space)}});
    legend.push_back({kForbiddenLine, "beyond the limit " + c.Metres(result.shortest_tether->length - result.limit)});
  } else if (result.obstruction == PlanObstruction::kLaidCableTooLong) {
    legend.push_back({kForbiddenLine, "beyond the limit " + c.Metres(result.start.length - result.limit)});
  } else if (result.obstruction == PlanObstruction::kLaidCableBlocked) {
    legend.push_back({kForbiddenLine, "cable on blocked ground"});
  }
}

std::vector<LegendEntry> PlanLegend(const Case& c, const Pieces& pieces) {
  std::vector<LegendEntry> legend;
  AppendMotionEntries(c, legend);
  AppendShortfallEntries(c, legend);
  const std::vector<NumberedLine> others = OtherClasses(c);
  if (!others.empty()) {
    legend.push_back({std::monostate(),
                      std::string("Other classes within the limit") + (c.result.all_complete ? "" : " (not all)")});
    AppendNumberedEntries(others, legend);
  }
  AppendPieceEntries(c, pieces, legend);
  return legend;
}

void DrawBlockedCable(Figure& figure, const Case& c) {
  constexpr std::size_t kMostMarks = 5;
  if (!c.scene.tether || !c.scene.tether->laid) return;
  const std::vector<Polyline> parts = BlockedParts(c.space, *c.scene.tether->laid);
  for (const Polyline& part : parts) figure.Line("blocked-part", part, kForbiddenLine);
  for (std::size_t i = 0; i < std::min(parts.size(), kMostMarks); ++i) {
    figure.Mark(Marker::kBlocked, Lerp(parts[i].front(), parts[i].back(), 0.5));
  }
}

/// Widest lines first, so that each shows beside the next.
void DrawLines(Figure& figure, const Case& c) {
  const PlanResult& result = c.result;
  DrawNumberedLines(figure, OtherClasses(c));
  if (result.motion) figure.Line("tether-goal", result.motion->tether.points, kGoalTetherLine);
  if (result.shortest_tether) DrawLimitedTether(figure, *result.shortest_tether, result.limit, kGoalTetherLine);
  if (result.obstruction == PlanObstruction::kLaidCableTooLong) {
    DrawLimitedTether(figure, result.start, result.limit, kStartTetherLine);
  } else {
    figure.Line("tether-start", result.start.points, kStartTetherLine);
  }
  if (result.rejected) figure.Line("rejected", result.rejected->path.points, kRejectedLine);
  if (PlainMotion(result) != nullptr) figure.Line("crossing", PlainMotion(result)->path.points, kCrossingLine);
  if (result.motion) figure.Line("robot-path", result.motion->path.points, kPathLine);
  DrawLaid(figure, c.scene);
}

void DrawObstruction(Figure& figure, const Case& c) {
  if (c.result.obstruction == PlanObstruction::kLaidCableBlocked) DrawBlockedCable(figure, c);
  if (c.result.obstruction == PlanObstruction::kStartBlocked && c.scene.tether) {
    figure.Mark(Marker::kBlocked, RobotPosition(*c.scene.tether));
  }
  if (c.result.obstruction == PlanObstruction::kGoalBlocked && c.scene.goal) {
    figure.Mark(Marker::kBlocked, *c.scene.goal);
  }
}

void NameLetters(Figure& figure, const Case& c) {
  const PlanResult& result = c.result;
  figure.Name(IslandsOf(result.start.word));
  if (result.motion) figure.Name(IslandsOf(result.motion->tether.word));
  if (result.rejected) figure.Name(IslandsOf(result.rejected->tether.word));
  if (result.shortest_tether) figure.Name(IslandsOf(result.shortest_tether->word));
}

}  // namespace

std::string DrawPlan(const Scene& scene, const FreeSpace& space, const PlanResult& result) {
  const Case c{scene, space, result, EnoughDecimals(space, result)};
  const Pieces pieces = FindPieces(c);
  Figure figure(scene, space,
                {.title = Title(c),
                 .notes = Notes(c),
                 .legend = PlanLegend(c, pieces),
                 .tints = Tints(c, pieces),
                 .shown = TetherPoints(scene)});
  DrawLines(figure, c);
  DrawObstruction(figure, c);
  NameLetters(figure, c);
  if (result.rejected) {
    figure.LabelLine(
        result.rejected->path.points,
        "needs " + c.Metres(result.rejected->tether.length) + " of tether,\nlimit " + c.Metres(result.limit),
        kWarningColour);
  }
  MarkTether(figure, scene);
  return figure.Finish();
}

}  // namespace tautline
