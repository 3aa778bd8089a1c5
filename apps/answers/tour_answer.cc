#include "apps/answers/tour_answer.h"

#include <algorithm>
#include <utility>

#include "apps/answers/verification.h"
#include "tautline/homotopy/curve_faults.h"
#include "tautline/scene/check_tether.h"

namespace tautline {
namespace {

void AddTour(const Tour& tour, const JsonValues& values, Json& json) {
  json["order"] = tour.order;
  json["path"] = values.Of(tour.path.points);
  json["length"] = tour.path.length;
  json["optimal"] = tour.optimal;
  json["bound"] = tour.bound;
  json["gap"] = tour.bound > 0 ? tour.path.length / tour.bound - 1 : 0.0;
  if (tour.stopped) json["stopped"] = true;
  if (tour.outside) json["leaves_workspace_at"] = values.Of(*tour.outside);
  json["legs"] = Json::array();
  for (const TautPath& leg : tour.legs) json["legs"].push_back(values.Of(leg, "path"));
}

void Verify(TourAnswer& answer) {
  std::vector<std::string> faults = BoundaryFaults(answer.setup, *answer.boundary);
  const Tour& tour = **answer.tour;
  for (const TautPath& leg : tour.legs) {
    for (const std::string& fault : CurveFaults(answer.setup.ground.space().free_space(), leg)) {
      faults.push_back("a leg " + fault);
    }
  }
  std::vector<std::size_t> visited = tour.order;
  std::sort(visited.begin(), visited.end());
  for (std::size_t i = 0; i < answer.stops.tasks.size(); ++i) {
    if (i >= visited.size() || visited[i] != i) faults.push_back("task " + std::to_string(i + 1) + " is left out");
  }
  if (tour.bound > tour.path.length) faults.emplace_back("the tour is shorter than the bound");
  const auto count = static_cast<int>(answer.boundary->sides.size() + tour.legs.size());
  answer.verified_curves = ReportVerification(faults, count, answer.json);
}

void Fill(const TourQuestion& question, const JsonValues& values, TourAnswer& answer) {
  const WorkspaceRegion region(answer.setup.ground, answer.setup.anchors, *answer.boundary);
  Rng rng(question.seed);
  answer.tour = PlanTour(region, answer.stops, question.options, rng);
  if (!*answer.tour) {
    AddOutside(answer.tour->error(), answer.json);
    answer.explanation = answer.tour->error().explanation;
    answer.status = kExitInfeasible;
    return;
  }
  answer.json["status"] = "solved";
  AddTour(**answer.tour, values, answer.json);
  if (MustVerify(question.verify)) Verify(answer);
}

Expected<TourStops> StopsOf(const Scene& scene, const TourQuestion& question) {
  if (question.to && question.round) return InvalidInput("a tour back to the start has no --to; leave one of them out");
  const auto from = RobotInWorkspace(scene, question.from);
  if (!from) return tl::unexpected(from.error());
  TourStops stops{.start = *from, .tasks = scene.tasks, .goal = question.to ? question.to : scene.goal};
  if (question.round) stops.goal.reset();
  if (stops.goal) {
    if (const auto checked = CheckGoal(*stops.goal); !checked) return tl::unexpected(checked.error());
  }
  return stops;
}

}  // namespace

Expected<TourAnswer> AnswerTour(const Scene& scene, const TourQuestion& question) {
  auto setup = SetUpWorkspace(scene);
  if (!setup) return tl::unexpected(setup.error());
  auto boundary = LayCables(scene, *setup);
  if (!boundary) return tl::unexpected(boundary.error());
  auto stops = StopsOf(scene, question);
  if (!stops) return tl::unexpected(stops.error());
  TourAnswer answer{.setup = std::move(*setup), .boundary = std::move(*boundary), .stops = std::move(*stops)};
  const JsonValues values(answer.setup.ground.space().free_space());
  answer.json["command"] = "workspace tour";
  answer.json["status"] = "infeasible";
  if (answer.boundary) {
    Fill(question, values, answer);
  } else {
    answer.explanation = answer.boundary.error().explanation;
    AddFault(answer.setup, answer.boundary.error(), values, answer.json);
    answer.status = kExitInfeasible;
  }
  return answer;
}

}  // namespace tautline
