#include "apps/pictures/learn_pictures.h"

#include "tautline/draw/draw_learning.h"
#include "tautline/draw/draw_policy_run.h"
#include "tautline/draw/draw_visits.h"

namespace tautline {
namespace {

PolicyRunPicture PictureOf(const LearnAnswer& answer) {
  return {.frames = answer.run.frames,
          .reference = answer.reference ? answer.reference->path : Polyline(),
          .robot_radius_m = answer.robot_radius_m,
          .success = answer.run.totals.success,
          .length_m = answer.run.totals.length_m,
          .explanation = answer.explanation};
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const LearnAnswer& answer) {
  return DrawPolicyRun(scene, PictureOf(answer));
}

std::string AnimateAnswer(const Scene& scene, const LearnAnswer& answer) {
  return AnimatePolicyRun(scene, PictureOf(answer));
}

std::string DrawCurves(const std::vector<std::unique_ptr<TrainingRun>>& runs) {
  std::vector<LearningCurve> curves;
  curves.reserve(runs.size());
  for (const auto& run : runs) curves.push_back({.episodes = run->episodes(), .evaluations = run->evaluations()});
  return DrawLearning(curves);
}

std::string DrawVisits(const Scene& scene, const LearnSetup& setup,
                       const std::vector<std::unique_ptr<TrainingRun>>& runs) {
  VisitMap visits = runs.front()->visits();
  auto counts = visits.counts();
  for (std::size_t run = 1; run < runs.size(); ++run) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += runs[run]->visits().counts()[i];
  }
  visits.set_counts(std::move(counts));
  return tautline::DrawVisits(scene, visits, setup.selection.reference ? setup.selection.reference->path : Polyline());
}

}  // namespace tautline
