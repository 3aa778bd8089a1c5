#include "apps/answers/manifold_answer.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "apps/answers/deadlock_json.h"
#include "apps/answers/manifold_faults.h"
#include "tautline/planners/grid_manifold/literal_manifold.h"
#include "tautline/planners/grid_manifold/manifold_file.h"
#include "tautline/scene/check_tether.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/world_digest.h"

namespace tautline {
namespace {

/// Sheets with boundaries in the answer; all sheets are counted.
constexpr std::size_t kMostOutlined = 1000;

Json ToJson(Point p) { return Json::array({p.x, p.y}); }

Json ToJson(const Ring& ring) {
  Json json = Json::array();
  for (const Point p : ring) json.push_back(ToJson(p));
  return json;
}

/// Why the manifold is not complete and what the answer then holds; empty when it is.
std::string StopSentence(const GridManifold& manifold, const ManifoldOptions& options, bool prepared) {
  const StopText stop = ExplainStop(manifold, options);
  if (stop.what.empty()) return "";
  const std::string upto =
      "; the answer holds every vertex nearer than " +
      Metres(CellsOf(manifold.complete_up_to() / kStraightStep * kStraightStep) * manifold.ground().cell_m()) + ": ";
  // The budget that it stopped at is not kept with it.
  if (prepared) return "the prepared manifold was stopped before its end" + upto + "make it anew with a larger budget";
  return stop.what + upto + stop.mend;
}

void AddGround(const CellGround& ground, Json& json) {
  json["resolution"] = ground.cell_m();
  json["columns"] = ground.columns();
  json["rows"] = ground.rows();
  json["free_cells"] = ground.free_cells();
  json["islands"] = ground.names();
}

void AddCounts(const ManifoldCounts& counts, double cell_m, Json& json) {
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["multiplicity"] = counts.multiplicity;
  json["max_distance"] = CellsOf(counts.farthest) * cell_m;
}

Json ToJson(const ManifoldSheet& sheet, const CellGround& ground) {
  Json json;
  json["word"] = ToStrings(sheet.word, ground.names());
  json["vertices"] = sheet.vertices;
  json["min_distance"] = CellsOf(sheet.nearest) * ground.cell_m();
  json["max_distance"] = CellsOf(sheet.farthest) * ground.cell_m();
  if (sheet.boundary.empty()) return json;
  json["boundary"] = Json::array();
  for (const PolygonWithHoles& polygon : sheet.boundary) {
    json["boundary"].push_back(ToJson(polygon.outer));
    for (const Ring& hole : polygon.holes) json["boundary"].push_back(ToJson(hole));
  }
  return json;
}

/// A list of the vertices with their words and next headings.
Json SamplesOf(const GridManifold& manifold, const ManifoldGoalField& field) {
  const CellGround& ground = manifold.ground();
  Json samples = Json::array();
  for (int row = 0; row < ground.rows(); ++row) {
    for (int column = 0; column < ground.columns(); ++column) {
      for (const ManifoldVertex v : manifold.VerticesAt({column, row})) {
        if (field.distance(v) == kUnreached) continue;
        Json& sample = samples.emplace_back();
        sample["cell"] = Json::array({column, row});
        sample["word"] = ToStrings(manifold.WordOf(v), ground.names());
        sample["distance"] = CellsOf(field.distance(v)) * ground.cell_m();
        if (const auto d = field.Direction(v)) {
          sample["heading"] = std::remainder(*d * std::numbers::pi / 4 + ground.grid().yaw_rad, 2 * std::numbers::pi);
        }
      }
    }
  }
  return samples;
}

void AddField(const GridManifold& manifold, Point goal, Json& json) {
  Json& list = json["field"];
  list["goal"] = ToJson(goal);
  const auto cell = manifold.ground().CellAt(goal);
  const std::size_t goals = cell ? manifold.VerticesAt(*cell).size() : 0;
  list["goal_vertices"] = goals;
  if (goals == 0) return;
  const ManifoldGoalField field(manifold, *cell);
  list["from_base"] = CellsOf(field.distance(manifold.base_vertex())) * manifold.ground().cell_m();
  Json path = Json::array();
  for (const ManifoldVertex v : field.WayFrom(manifold.base_vertex())) {
    path.push_back(ToJson(manifold.ground().CentreOf(manifold.CellOf(v))));
  }
  list["path"] = std::move(path);
  list["samples"] = SamplesOf(manifold, field);
}

ManifoldCounts CountLiteral(const LiteralManifold& literal) {
  ManifoldCounts counts{.vertices = static_cast<std::int64_t>(literal.vertices.size()), .edges = literal.edges};
  counts.multiplicity = literal.Multiplicity();
  counts.farthest = literal.vertices.back().distance * kStraightStep;
  return counts;
}

void SetStatus(const char* status, const char* reason, ManifoldAnswer& answer) {
  answer.json["status"] = status;
  if (answer.explanation.empty()) return;
  answer.status = kExitInfeasible;
  answer.json["reason"] = reason;
  answer.json["explanation"] = answer.explanation;
}

Expected<GridManifold> Obtain(const Scene& scene, const ManifoldQuestion& question, CellGround ground,
                              const ManifoldOptions& options) {
  if (!question.prepared) return GridManifold::Build(std::move(ground), options);
  auto manifold = ManifoldFile::Read(*question.prepared, WorldDigest(scene.world), std::move(ground), options);
  if (!manifold) manifold.error().where = question.prepared_path;
  return manifold;
}

Expected<void> AddManifold(const Scene& scene, const ManifoldQuestion& question, CellGround ground,
                           const ManifoldOptions& options, ManifoldAnswer& answer) {
  if (question.watch) question.watch("manifold", 0);
  auto manifold = Obtain(scene, question, std::move(ground), options);
  if (!manifold) return tl::unexpected(manifold.error());
  answer.explanation = StopSentence(*manifold, options, question.prepared.has_value());
  SetStatus(answer.explanation.empty() ? "solved" : "budget_exceeded", "budget_exceeded", answer);
  AddGround(manifold->ground(), answer.json);
  answer.json["connectivity"] = options.connectivity == Connectivity::kEight ? 8 : 4;
  answer.json["limit"] = options.length_m;
  answer.counts = manifold->Count();
  AddCounts(answer.counts, manifold->ground().cell_m(), answer.json);
  if (question.sheets) {
    answer.sheets = SheetsOf(*manifold, kMostOutlined);
    answer.json["classes"] = answer.sheets.size();
    answer.json["sheets"] = Json::array();
    for (const ManifoldSheet& sheet : answer.sheets) {
      answer.json["sheets"].push_back(ToJson(sheet, manifold->ground()));
    }
  }
  if (question.field) AddField(*manifold, *scene.goal, answer.json);
  answer.manifold = std::make_unique<const GridManifold>(*std::move(manifold));
  if (question.deadlocks) {
    if (question.watch) question.watch("deadlocks", 0);
    answer.deadlocks.emplace(*answer.manifold);
    AddDeadlocks(scene.world, *answer.manifold, *answer.deadlocks, answer.json);
  }
  return {};
}

void AddLiteral(const CellGround& ground, const ManifoldOptions& options, ManifoldAnswer& answer) {
  const LiteralManifold literal =
      BuildLiteralManifold(ground, options.base, options.length_m / ground.cell_m(), options.max_vertices);
  if (literal.budget_exceeded) {
    answer.explanation = "the construction stopped after " + std::to_string(options.max_vertices) +
                         " vertices: raise --max-nodes or shorten the tether";
  }
  SetStatus(literal.budget_exceeded ? "budget_exceeded" : "solved", "budget_exceeded", answer);
  AddGround(ground, answer.json);
  answer.json["connectivity"] = 4;
  answer.json["construction"] = "literal";
  answer.json["limit"] = options.length_m;
  answer.counts = CountLiteral(literal);
  AddCounts(answer.counts, ground.cell_m(), answer.json);
}

Expected<void> CheckQuestion(const Scene& scene, const ManifoldQuestion& question) {
  if (auto checked = RequireTether(scene); !checked) return checked;
  if (question.connectivity && *question.connectivity != 4 && *question.connectivity != 8) {
    return InvalidInput("the connectivity must be 4 or 8", "--connectivity");
  }
  if (question.literal && question.connectivity == 8) {
    return InvalidInput("the printed construction is 4-connected: leave out --connectivity 8", "--literal");
  }
  if (question.literal && (question.sheets || question.field || question.deadlocks || question.prepared)) {
    return InvalidInput("the printed construction has no words, fields or files: leave out the other options",
                        "--literal");
  }
  if (question.field) return RequireTetherAndGoal(scene);
  return {};
}

}  // namespace

Expected<ManifoldAnswer> AnswerManifold(const Scene& scene, const ManifoldQuestion& question) {
  if (const auto checked = CheckQuestion(scene, question); !checked) return tl::unexpected(checked.error());
  if (question.watch) question.watch("cells", 0);
  auto ground = MakeCellGround(scene.world, question.cells);
  if (!ground) return tl::unexpected(ground.error());
  ManifoldAnswer answer;
  answer.json["command"] = "manifold";
  answer.explanation = BaseFault(*ground, scene.tether->base);
  if (!answer.explanation.empty()) {
    SetStatus("infeasible", "start_blocked", answer);
    AddGround(*ground, answer.json);
    return answer;
  }
  const int connectivity = question.connectivity.value_or(question.literal ? 4 : 8);
  const ManifoldOptions options{.base = *ground->CellAt(scene.tether->base),
                                .length_m = scene.tether->length,
                                .connectivity = connectivity == 8 ? Connectivity::kEight : Connectivity::kFour,
                                .max_vertices = question.max_vertices,
                                .max_bytes = question.max_bytes,
                                .keep_going = {},
                                .parallel = question.parallel};
  if (question.literal) {
    AddLiteral(*ground, options, answer);
    return answer;
  }
  if (auto added = AddManifold(scene, question, *std::move(ground), options, answer); !added) {
    return tl::unexpected(added.error());
  }
  return answer;
}

}  // namespace tautline
