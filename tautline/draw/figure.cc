#include "tautline/draw/figure.h"

#include <algorithm>

#include "tautline/draw/ground.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

constexpr double kPlotHeight = 240;
constexpr double kPlotGap = 14;               // Above each plot.
constexpr std::size_t kManyVertices = 5'000;  // From here on coordinates have one decimal.

/// Somewhat larger: lines beside each other stand out at their bends.
Box Grown(const Box& box) {
  const Box shown = WithoutFlatSides(box);
  const double margin = 0.02 * std::max(shown.size().x, shown.size().y);
  return {shown.low - Point{margin, margin}, shown.high + Point{margin, margin}};
}

/// What the map shows: the world, and points near it; in the open plane, the points alone.
Box ShownWorld(const Scene& scene, const FreeSpace& space, std::span<const Point> points) {
  if (IsOpenPlane(scene.world)) return Grown(BoundingBox(points));
  Box box = space.box;
  if (box.empty()) box = BoundingBox(scene.world.outline);
  const Box world = WithoutFlatSides(box);
  const double extent = std::max(world.size().x, world.size().y);
  for (const Point p : points) {
    // A point far away would shrink the world to a dot.
    const bool near = p.x > world.low.x - 0.3 * extent && p.x < world.high.x + 0.3 * extent &&
                      p.y > world.low.y - 0.3 * extent && p.y < world.high.y + 0.3 * extent;
    if (near) box.Add(p);
  }
  return box;
}

PageContent MakePage(const Scene& scene, const FreeSpace& space, const FigureContent& content) {
  PageContent page{.world = ShownWorld(scene, space, content.shown),
                   .title = content.title,
                   .notes = content.notes,
                   .legend = content.legend,
                   .below = static_cast<double>(content.plots.size()) * (kPlotHeight + kPlotGap)};
  if (IsOpenPlane(scene.world)) return page;
  for (LegendEntry& entry : GroundLegend(space, LengthDecimals(space))) page.legend.push_back(std::move(entry));
  return page;
}

SvgWriter::Options WriterOptions(const Page& page, const FreeSpace& space, const std::string& title) {
  return {.width = page.width(),
          .height = page.height(),
          .decimals = BoundarySize(space) > kManyVertices ? 1 : 2,
          .title = title};
}

}  // namespace

std::string SceneRemark(const Scene& scene, const FreeSpace& space) {
  std::string file = scene.path.substr(scene.path.find_last_of('/') + 1);
  if (IsOpenPlane(scene.world)) return file;
  const int decimals = std::min(LengthDecimals(space), 3);
  const Point size = space.box.empty() ? Point{} : space.box.size();
  const std::string extent = CompactText(size.x, decimals) + " × " + CompactText(size.y, decimals) + " m";
  return file.empty() ? extent : file + ", " + extent;
}

int LengthDecimals(const FreeSpace& space) {
  return space.box.empty() ? 2 : LengthDecimals(std::max(space.box.size().x, space.box.size().y));
}

Figure::Figure(const Scene& scene, const FreeSpace& space, const FigureContent& content)
    : scene_(scene),
      space_(space),
      page_(MakePage(scene, space, content)),
      svg_(StartPicture(WriterOptions(page_, space, content.title))),
      map_(svg_,
           {.world = scene.world,
            .space = space,
            .view = page_.view(),
            .options = {.frame = page_.map(), .tints = content.tints, .outline_obstacles = content.outline_obstacles}}),
      plots_(content.plots) {}

std::string Figure::Finish() {
  map_.Finish();
  page_.DrawAround(svg_, SceneRemark(scene_, space_));
  DrawPlots();
  return svg_.Finish();
}

void Figure::DrawPlots() {
  Box frame = page_.strip();
  for (const PlotContent& plot : plots_) {
    frame.low.y += kPlotGap;
    frame.high.y = frame.low.y + kPlotHeight;
    DrawPlot(svg_, frame, plot);
    frame.low.y = frame.high.y;
  }
}

}  // namespace tautline
