#include "tautline/draw/draw_visits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "tautline/draw/cell_shapes.h"
#include "tautline/draw/figure.h"

namespace tautline {
namespace {

const LineStyle kReferenceLine = {.colour = "#00684c", .width = 1.8, .dashes = "7 4"};
constexpr int kShades = 7;

/// From light yellow to dark red, by the share of the way.
std::string ShadeOf(double share) {
  const auto mix = [share](double light, double dark) {
    return static_cast<int>(std::lround(light + (dark - light) * share));
  };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", mix(255, 110), mix(236, 1), mix(160, 20));
  return text;
}

/// Visits from `from` on, below the next one's.
struct Band {
  std::int64_t from = 1;
  std::string colour;
};

/// Bounds that grow by one factor, at least 2.
std::vector<Band> BandsOf(std::int64_t most) {
  const double factor = std::max(2.0, std::pow(static_cast<double>(most), 1.0 / kShades));
  std::vector<Band> bands;
  for (double from = 1; from <= static_cast<double>(most) && bands.size() < kShades; from *= factor) {
    const auto whole = static_cast<std::int64_t>(std::ceil(from));
    if (bands.empty() || whole > bands.back().from) bands.push_back({whole, ""});
  }
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].colour = ShadeOf(bands.size() == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(bands.size() - 1));
  }
  return bands;
}

OccupancyGrid GridOf(const VisitMap& visits) {
  OccupancyGrid grid = MakeGrid(visits.columns(), visits.rows(), CellState::kFree);
  grid.cell_m = visits.cell_m();
  grid.origin = visits.low();
  return grid;
}

}  // namespace

std::string DrawVisits(const Scene& scene, const VisitMap& visits, const Polyline& reference) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  const auto& counts = visits.counts();
  const std::int64_t most = *std::max_element(counts.begin(), counts.end());
  const std::int64_t sum = std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  const std::vector<Band> bands = BandsOf(most);
  FigureContent content{.title = "Where the robot was in " + std::to_string(sum) + " steps"};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const bool last = i + 1 == bands.size();
    const std::int64_t to = last ? most : bands[i + 1].from - 1;
    std::string text = std::to_string(bands[i].from);
    if (to > bands[i].from) text += " to " + std::to_string(to);
    content.legend.push_back({GroundSwatch{.fill = bands[i].colour}, text + (to == 1 ? " visit" : " visits")});
  }
  if (reference.size() > 1) content.legend.push_back({kReferenceLine, "the reference path"});
  Figure figure(scene, *space, content);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    std::vector<bool> in(counts.size());
    for (std::size_t k = 0; k < in.size(); ++k) {
      in[k] = counts[k] >= bands[i].from && (i + 1 == bands.size() || counts[k] < bands[i + 1].from);
    }
    figure.Shape("visits", CellCurves(GridOf(visits), in, figure.view()), {.fill = bands[i].colour});
  }
  if (reference.size() > 1) figure.Line("reference", reference, kReferenceLine);
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  if (scene.goal) figure.Mark(Marker::kGoal, *scene.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
