#include "tautline/draw/draw_manifold.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "tautline/draw/cell_shapes.h"
#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

constexpr int kMostShades = 6;

/// From light to dark blue, by the share of the way.
std::string ShadeOf(double share) {
  const auto mix = [share](double light, double dark) {
    return static_cast<int>(std::lround(light + (dark - light) * share));
  };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", mix(222, 8), mix(235, 69), mix(247, 148));
  return text;
}

/// Counts from 1 on that share a shade: `from` to `to`.
struct Band {
  std::uint32_t from = 1, to = 1;
  std::string colour;
};

/// One shade for each count while there are few, for doubling ranges when there are many.
std::vector<Band> BandsOf(std::uint32_t most) {
  std::vector<Band> bands;
  const bool single = most <= kMostShades;
  for (std::uint32_t from = 1; from <= most; from = bands.back().to + 1) {
    const double width = single ? 1 : std::pow(most, 1.0 / kMostShades);
    const auto to = single ? from : static_cast<std::uint32_t>(std::max<double>(from, std::floor(from * width)));
    bands.push_back({from, std::min(to, most), ""});
  }
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].colour =
        ShadeOf(bands.size() == 1 ? 0.25 : static_cast<double>(i) / static_cast<double>(bands.size() - 1));
  }
  return bands;
}

/// The outlines of the cells whose count is in a range, as curves in pixels.
std::vector<SvgCurve> CellsWith(const GridManifold& manifold, const std::vector<std::uint32_t>& counts,
                                const Band& band, const View& view) {
  std::vector<bool> in(counts.size());
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = counts[i] >= band.from && counts[i] <= band.to;
  return CellCurves(manifold.ground().grid(), in, view);
}

std::vector<LegendEntry> LegendOf(const std::vector<Band>& bands) {
  std::vector<LegendEntry> legend;
  for (const Band& band : bands) {
    std::string text = std::to_string(band.from);
    if (band.to > band.from) text += " to " + std::to_string(band.to);
    legend.push_back({GroundSwatch{.fill = band.colour}, text + (band.to == 1 ? " class of the tether" : " classes")});
  }
  return legend;
}

std::string TitleOf(const ManifoldPicture& picture, std::uint32_t most) {
  if (picture.manifold == nullptr) return "No manifold";
  return "Up to " + std::to_string(most) + (most == 1 ? " class" : " classes") + " of the tether in a cell";
}

}  // namespace

std::string DrawManifold(const Scene& scene, const ManifoldPicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  std::vector<std::uint32_t> counts;
  if (picture.manifold != nullptr) counts = picture.manifold->Multiplicity();
  const std::uint32_t most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  const std::vector<Band> bands = BandsOf(most);
  FigureContent content{.title = TitleOf(picture, most), .legend = LegendOf(bands)};
  if (!picture.explanation.empty()) content.notes.push_back(picture.explanation);
  content.shown.push_back(scene.tether->base);
  Figure figure(scene, *space, content);
  for (const Band& band : bands) {
    figure.Shape("classes", CellsWith(*picture.manifold, counts, band, figure.view()), {.fill = band.colour});
  }
  if (most > 0) {
    figure.Shape("reached", CellsWith(*picture.manifold, counts, {1, most, ""}, figure.view()),
                 {.stroke = "#08306b", .width = 1});
  }
  figure.Mark(Marker::kBase, scene.tether->base, "base");
  if (scene.goal) figure.Mark(Marker::kGoal, *scene.goal, "goal");
  return figure.Finish();
}

}  // namespace tautline
