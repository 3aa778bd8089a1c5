#include "tautline/draw/draw_best_base.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tautline/draw/figure.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

constexpr std::size_t kNumbered = 4;  ///< Besides the best one.
constexpr double kLargestDisc = 9;    ///< Pixels.

/// From the worst fifth to the best.
constexpr std::array<const char*, 5> kShades = {"#e6edf5", "#b5cde6", "#7aa9d6", "#3d7ebc", "#0b4a8f"};

double WorthOf(const BaseTrial& trial, BaseObjective objective) {
  return static_cast<double>(objective == BaseObjective::kArea ? trial.cells : trial.closed);
}

/// The discs of each shade, by where the worth lies between the best and the worst.
std::array<std::vector<SvgCurve>, kShades.size()> DiscsOf(const BestBasePicture& picture, const View& view) {
  std::array<std::vector<SvgCurve>, kShades.size()> discs;
  const auto by_worth = [&](const BaseTrial& a, const BaseTrial& b) {
    return WorthOf(a, picture.objective) < WorthOf(b, picture.objective);
  };
  const auto [least, most] = std::minmax_element(picture.ranked.begin(), picture.ranked.end(), by_worth);
  const double low = WorthOf(*least, picture.objective), range = WorthOf(*most, picture.objective) - low;
  const double spacing =
      view.pixels_per_metre() * picture.ground->cell_m() *
      std::sqrt(static_cast<double>(picture.ground->free_cells()) / static_cast<double>(picture.ranked.size()));
  const double radius = std::clamp(0.42 * spacing, 1.0, kLargestDisc);
  std::int64_t most_cells = 0;
  for (const BaseTrial& trial : picture.ranked) most_cells = std::max(most_cells, trial.cells);
  for (const BaseTrial& trial : picture.ranked) {
    const bool counts = static_cast<double>(trial.cells) >= kLeastReachShare * static_cast<double>(most_cells);
    const double share = range > 0 ? (WorthOf(trial, picture.objective) - low) / range : 1;
    const double least_closed = counts ? 1 - share : 0;
    const double good = picture.objective == BaseObjective::kArea || range <= 0 ? share : least_closed;
    const auto shade = std::min(kShades.size() - 1, static_cast<std::size_t>(good * kShades.size()));
    const Point at = view.ToPixels(picture.ground->CentreOf(trial.base));
    const Point right = at + Point{radius, 0}, left = at - Point{radius, 0};
    discs[shade].push_back({.start = right, .steps = {{left, radius}, {right, radius}}, .closed = true});
  }
  return discs;
}

std::string AreaOf(const BestBasePicture& picture, std::int64_t cells) {
  const double cell_m = picture.ground->cell_m();
  return AreaText(static_cast<double>(cells) * cell_m * cell_m);
}

FigureContent ContentOf(const BestBasePicture& picture) {
  FigureContent content{.title = "No best base"};
  if (!picture.explanation.empty()) content.notes.push_back(picture.explanation);
  if (picture.ranked.empty()) return content;
  const BaseTrial& best = picture.ranked.front();
  content.title =
      "The best of " + std::to_string(picture.ranked.size()) + " bases reaches " + AreaOf(picture, best.cells);
  if (picture.objective == BaseObjective::kDeadlock) {
    content.title += " and has " + AreaOf(picture, best.closed) + " in deadlocks";
    content.notes.emplace_back("Only bases that reach nine tenths of the most that any reaches can be the best.");
  }
  content.notes.emplace_back("Numbers are the next best ones.");
  content.legend = {{GroundSwatch{.fill = kShades.back()}, "near the best"},
                    {GroundSwatch{.fill = kShades.front()}, "near the worst, or out of the question"}};
  return content;
}

}  // namespace

std::string DrawBestBase(const Scene& scene, const BestBasePicture& picture) {
  const auto space = BuildFreeSpace(scene.world);
  if (!space) return "";
  Figure figure(scene, *space, ContentOf(picture));
  if (picture.ranked.empty()) return figure.Finish();
  const auto discs = DiscsOf(picture, figure.view());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    figure.Shape("candidates", discs[i], {.fill = kShades[i], .stroke = "#4b5057", .width = 0.5});
  }
  for (std::size_t i = std::min(kNumbered + 1, picture.ranked.size()); i-- > 1;) {
    const Point at = figure.view().ToPixels(picture.ground->CentreOf(picture.ranked[i].base));
    figure.Number(std::array{at, at}, std::to_string(i + 1), kShades.back());
  }
  figure.Mark(Marker::kBase, picture.ground->CentreOf(picture.ranked.front().base), "best base");
  return figure.Finish();
}

}  // namespace tautline
