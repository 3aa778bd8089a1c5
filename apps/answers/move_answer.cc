#include "apps/answers/move_answer.h"

#include <cmath>
#include <utility>

#include "apps/answers/verification.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"

namespace tautline {
namespace {

constexpr double kSamples = 200;  // Where nobody says how many.
constexpr double kMostSamples = 1e6;

Json SampleJson(const MoveSample& sample, const JsonValues& values) {
  Json json;
  json["t"] = sample.t_s;
  json["robot"] = values.Of(sample.robot);
  json["speed"] = sample.speed;
  json["lengths"] = sample.lengths;
  json["rates"] = sample.rates;
  json["corners"] = values.Of(sample.corners);
  return json;
}

Json PieceJson(const MovePiece& piece, const JsonValues& values) {
  Json json;
  json["from"] = values.Of(piece.from);
  json["to"] = values.Of(piece.to);
  json["t"] = piece.begin_s;
  json["duration"] = piece.profile.duration_s();
  json["length"] = piece.profile.length_m();
  json["top_speed"] = piece.profile.top_speed();
  json["cables"] = Json::array();
  for (const auto& sections : piece.cables) {
    Json& cable = json["cables"].emplace_back(Json::array());
    for (const CableSection& section : sections) {
      Json& part = cable.emplace_back();
      part["t"] = piece.begin_s + piece.profile.TimeAt(section.begin);
      part["via"] = values.Of(section.via);
    }
  }
  return json;
}

void AddMove(const Move& move, const std::vector<MoveSample>& samples, const JsonValues& values, Json& json) {
  json["path"] = values.Of(move.path.points);
  json["length"] = move.path.length;
  json["word"] = values.Of(move.path.word);
  json["duration"] = move.duration_s;
  if (move.outside) json["leaves_workspace_at"] = values.Of(*move.outside);
  json["pieces"] = Json::array();
  for (const MovePiece& piece : move.pieces) json["pieces"].push_back(PieceJson(piece, values));
  json["switches"] = Json::array();
  for (const CornerSwitch& s : move.switches) {
    Json& entry = json["switches"].emplace_back();
    entry["t"] = s.t_s;
    entry["anchor"] = s.anchor;
    entry["from"] = values.Of(s.from);
    entry["to"] = values.Of(s.to);
  }
  json["samples"] = Json::array();
  for (const MoveSample& sample : samples) json["samples"].push_back(SampleJson(sample, values));
}

/// The path, and the cables at the ends of all pieces.
std::vector<TautPath> CurvesOf(const WorkspaceSetup& setup, const Move& move) {
  const TautSpace& space = setup.ground.space();
  std::vector<TautPath> curves{move.path};
  for (std::size_t k = 0; k < move.pieces.size(); ++k) {
    for (const double distance : {0.0, move.pieces[k].profile.length_m()}) {
      for (Polyline& cable : CablesAt(move, k, distance)) curves.push_back(space.MakePath(std::move(cable)));
    }
  }
  return curves;
}

void Verify(MoveAnswer& answer) {
  std::vector<std::string> faults = BoundaryFaults(answer.setup, *answer.boundary);
  const std::vector<TautPath> curves = CurvesOf(answer.setup, **answer.move);
  for (const TautPath& curve : curves) {
    for (const std::string& fault : CurveFaults(answer.setup.ground.space().free_space(), curve)) {
      faults.push_back("a curve of the motion " + fault);
    }
  }
  const auto count = static_cast<int>(answer.boundary->sides.size() + curves.size());
  answer.verified_curves = ReportVerification(faults, count, answer.json);
}

Expected<void> Fill(const MoveQuestion& question, const JsonValues& values, MoveAnswer& answer) {
  const WorkspaceRegion region(answer.setup.ground, answer.setup.anchors, *answer.boundary);
  answer.move = PlanMove(region, answer.from, answer.to, question.options);
  if (!*answer.move) {
    AddOutside(answer.move->error(), answer.json);
    answer.explanation = answer.move->error().explanation;
    answer.status = kExitInfeasible;
    return {};
  }
  const Move& move = **answer.move;
  const double duration = move.duration_s;
  const double dt = question.dt.value_or(duration > 0 ? duration / kSamples : 1);
  if (duration / dt > kMostSamples) {
    return InvalidInput("a motion of " + ShortNumber(duration) + " s has more than a million samples at steps of " +
                        FormatNumber(dt) + " s; take longer steps");
  }
  answer.samples = SampleMove(move, dt);
  answer.json["status"] = "solved";
  AddMove(move, answer.samples, values, answer.json);
  if (MustVerify(question.verify)) Verify(answer);
  return {};
}

}  // namespace

Expected<MoveAnswer> AnswerMove(const Scene& scene, const MoveQuestion& question) {
  auto setup = SetUpWorkspace(scene);
  if (!setup) return tl::unexpected(setup.error());
  auto boundary = LayCables(scene, *setup);
  if (!boundary) return tl::unexpected(boundary.error());
  const auto from = RobotInWorkspace(scene, question.from);
  if (!from) return tl::unexpected(from.error());
  if (!question.to && !scene.goal) {
    return InvalidInput("no goal: set goal: [x, y], or give it as --to X,Y", scene.path);
  }
  MoveAnswer answer{.setup = std::move(*setup), .boundary = std::move(*boundary)};
  answer.from = *from;
  answer.to = question.to ? *question.to : *scene.goal;
  answer.options = question.options;
  if (const auto checked = CheckGoal(answer.to); !checked) return tl::unexpected(checked.error());
  if (const auto checked = CheckMoveOptions(question.options, answer.setup.anchors.size()); !checked) {
    return tl::unexpected(checked.error());
  }
  const JsonValues values(answer.setup.ground.space().free_space());
  answer.json["command"] = "workspace move";
  answer.json["status"] = "infeasible";
  if (!answer.boundary) {
    answer.explanation = answer.boundary.error().explanation;
    AddFault(answer.setup, answer.boundary.error(), values, answer.json);
    answer.status = kExitInfeasible;
  } else if (const auto filled = Fill(question, values, answer); !filled) {
    return tl::unexpected(filled.error());
  }
  return answer;
}

std::string MoveCsv(const MoveAnswer& answer) {
  std::string text = "t,x,y,speed";
  for (std::size_t i = 1; i <= answer.setup.anchors.size(); ++i) {
    for (const char* column : {"length_", "rate_", "corner_x_", "corner_y_"}) {
      text += "," + (column + std::to_string(i));
    }
  }
  text += "\n";
  const JsonValues values(answer.setup.ground.space().free_space());
  const auto add = [&text](const Json& value) { text += "," + value.dump(); };
  for (const MoveSample& sample : answer.samples) {
    text += Json(sample.t_s).dump();
    for (const Json& coordinate : values.Of(sample.robot)) add(coordinate);
    add(sample.speed);
    for (std::size_t i = 0; i < sample.lengths.size(); ++i) {
      add(sample.lengths[i]);
      add(sample.rates[i]);
      for (const Json& coordinate : values.Of(sample.corners[i])) add(coordinate);
    }
    text += "\n";
  }
  return text;
}

}  // namespace tautline
