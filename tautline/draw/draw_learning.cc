#include "tautline/draw/draw_learning.h"

#include <algorithm>
#include <cmath>

#include "tautline/draw/plot.h"
#include "tautline/draw/sheet.h"

namespace tautline {
namespace {

constexpr char kColour[] = "#0b4a8f";
constexpr char kGreedyColour[] = "#00684c";
constexpr double kPanelHeight = 250;
/// Into so many stretches a training is cut.
constexpr std::size_t kStretches = 60;

/// The means of a curve's values over stretches of the training; NaN where none ended there.
std::vector<double> MeansOf(const std::vector<EpisodeRecord>& records, double steps) {
  std::vector<double> sums(kStretches), counts(kStretches);
  for (const EpisodeRecord& record : records) {
    const double at = static_cast<double>(record.step) / steps * kStretches;
    const auto stretch = std::min(kStretches - 1, static_cast<std::size_t>(std::ceil(at)) - 1);
    sums[stretch] += record.totals.reward;
    counts[stretch] += 1;
  }
  for (std::size_t i = 0; i < kStretches; ++i) sums[i] /= counts[i];
  return sums;
}

/// The spread of several curves over a common axis.
struct Spread {
  Polyline low, mean, high;

  void Add(double x, std::span<const double> values) {
    double sum = 0, least = 1e300, most = -1e300, count = 0;
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      sum += value, count += 1;
      least = std::min(least, value), most = std::max(most, value);
    }
    if (count == 0) return;
    low.push_back({x, least});
    mean.push_back({x, sum / count});
    high.push_back({x, most});
  }
};

PlotContent PlotOf(const std::string& title, const Spread& spread, const std::string& colour) {
  return {.title = title,
          .x_label = "steps of the training",
          .y_label = "return",
          .series = {{.name = "", .style = {.colour = colour, .width = 1.8}, .parts = {spread.mean}}},
          .bands = {{.low = spread.low, .high = spread.high, .colour = colour}}};
}

PlotContent EpisodePlot(std::span<const LearningCurve> curves, double steps) {
  std::vector<std::vector<double>> means;
  means.reserve(curves.size());
  for (const LearningCurve& curve : curves) means.push_back(MeansOf(curve.episodes, steps));
  Spread spread;
  for (std::size_t i = 0; i < kStretches; ++i) {
    std::vector<double> values;
    values.reserve(means.size());
    for (const auto& curve : means) values.push_back(curve[i]);
    spread.Add((static_cast<double>(i) + 0.5) / kStretches * steps, values);
  }
  return PlotOf("Episodes while learning", spread, kColour);
}

PlotContent GreedyPlot(std::span<const LearningCurve> curves) {
  std::size_t most = 0;
  for (const LearningCurve& curve : curves) most = std::max(most, curve.evaluations.size());
  Spread spread;
  PlotContent plot;
  std::vector<Point> reached;
  for (std::size_t i = 0; i < most; ++i) {
    std::vector<double> values;
    double x = 0;
    for (const LearningCurve& curve : curves) {
      if (i >= curve.evaluations.size()) continue;
      const EpisodeRecord& evaluation = curve.evaluations[i];
      x = static_cast<double>(evaluation.step);
      values.push_back(evaluation.totals.reward);
      if (evaluation.totals.success) reached.push_back({x, evaluation.totals.reward});
    }
    spread.Add(x, values);
  }
  plot = PlotOf("Greedy episodes (a ring: the goal was reached)", spread, kGreedyColour);
  plot.series[0].dots = std::move(reached);
  return plot;
}

}  // namespace

std::string DrawLearning(std::span<const LearningCurve> curves) {
  double steps = 1;
  for (const LearningCurve& curve : curves) {
    if (!curve.episodes.empty()) steps = std::max(steps, static_cast<double>(curve.episodes.back().step));
  }
  SheetContent sheet{.title = curves.size() == 1 ? "A training" : std::to_string(curves.size()) + " trainings",
                     .rows = {}};
  if (curves.size() > 1) sheet.notes = {"Lines are means over the seeds; bands reach from the worst seed to the best."};
  for (const PlotContent& plot : {EpisodePlot(curves, steps), GreedyPlot(curves)}) {
    const auto draw = [plot](SvgWriter& svg, const Box& frame) { DrawPlot(svg, frame, plot); };
    sheet.rows.push_back({.panels = {{.title = "", .notes = {}, .draw = draw}}, .height = kPanelHeight});
  }
  return DrawSheet(sheet);
}

}  // namespace tautline
