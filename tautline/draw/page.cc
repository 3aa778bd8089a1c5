#include "tautline/draw/page.h"

#include <algorithm>

#include "tautline/draw/length_text.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kPageWidth = 1000;
constexpr double kMargin = 20;
constexpr double kGap = 18;          // Between map and legend.
constexpr double kSideLegend = 280;  // Width of a legend beside the map.
constexpr double kTallestMap = 840;
constexpr double kWideAspect = 1.55;  // From here on the legend stands below.
constexpr double kLeastMapWidth = 190;
constexpr double kLeastMapHeight = 90;
constexpr double kMapPadding = 16;  // Room for symbols on the rim of the world.
constexpr double kFooterHeight = 34;
constexpr double kTitleSize = 17;
constexpr double kTitleLine = 22;
constexpr double kNoteSize = 13;
constexpr double kNoteLine = 17.5;

double Aspect(const Box& world) { return world.size().x / world.size().y; }

bool LegendBelow(const Box& world) { return Aspect(world) >= kWideAspect; }

/// Width and height of the map's frame.
Point MapSize(const Box& world) {
  const double widest = kPageWidth - 2 * kMargin - (LegendBelow(world) ? 0 : kSideLegend + kGap);
  const Point inner{widest - 2 * kMapPadding, kTallestMap - 2 * kMapPadding};
  const double scale = std::min(inner.x / world.size().x, inner.y / world.size().y);
  const Point size = scale * world.size() + Point{2 * kMapPadding, 2 * kMapPadding};
  return {std::max(size.x, kLeastMapWidth), std::max(size.y, kLeastMapHeight)};
}

Legend MakeLegend(const PageContent& content) {
  const bool below = LegendBelow(WithoutFlatSides(content.world));
  return {content.legend, {.width = below ? kPageWidth - 2 * kMargin : kSideLegend, .columns = below ? 3 : 1}};
}

}  // namespace

Page::Page(const PageContent& content) : world_(WithoutFlatSides(content.world)), legend_(MakeLegend(content)) {
  const Point size = MapSize(world_);
  const bool below = LegendBelow(world_);
  width_ = below ? kPageWidth : 2 * kMargin + size.x + kGap + kSideLegend;
  const double text_width = width_ - 2 * kMargin;
  title_lines_ = Wrap(content.title, {.size = kTitleSize, .width = text_width, .max_lines = 4, .bold = true});
  for (const std::string& note : content.notes) {
    for (std::string& line : Wrap(note, {.size = kNoteSize, .width = text_width, .max_lines = 4})) {
      note_lines_.push_back(std::move(line));
    }
  }
  PlaceMap(size);
  strip_height_ = content.below;
  height_ += strip_height_;
}

Box Page::strip() const {
  const double low = height_ - 0.5 * kMargin;
  return {{kMargin, low - strip_height_}, {width_ - kMargin, low}};
}

void Page::PlaceMap(Point size) {
  title_height_ =
      kTitleLine * static_cast<double>(title_lines_.size()) + kNoteLine * static_cast<double>(note_lines_.size());
  const Point corner{kMargin, kMargin + title_height_ + 6};
  map_ = {corner, corner + size};
  if (LegendBelow(world_)) {
    legend_corner_ = {kMargin, map_.high.y + kFooterHeight + 10};
    height_ = legend_corner_.y + legend_.height() + kMargin;
  } else {
    legend_corner_ = {map_.high.x + kGap, map_.low.y};
    height_ = std::max(map_.high.y + kFooterHeight, legend_corner_.y + legend_.height()) + 0.5 * kMargin;
  }
}

View Page::view() const {
  const Point padding{kMapPadding, kMapPadding};
  return {world_, {map_.low + padding, map_.high - padding}};
}

void Page::DrawAround(SvgWriter& svg, const std::string& remark) const {
  svg.OpenGroup("title");
  double y = kMargin;
  for (const std::string& line : title_lines_) {
    svg.Text({.at = {kMargin, y + 15}, .text = line, .size = kTitleSize, .bold = true});
    y += kTitleLine;
  }
  for (const std::string& line : note_lines_) {
    svg.Text({.at = {kMargin, y + 12}, .text = line, .size = kNoteSize, .fill = "#333333"});
    y += kNoteLine;
  }
  svg.CloseGroup();
  DrawScaleBar(svg, remark);
  legend_.Draw(svg, legend_corner_);
}

void Page::DrawScaleBar(SvgWriter& svg, const std::string& remark) const {
  const double scale = view().pixels_per_metre();
  const double length = RoundLengthBelow(std::max(40.0, 0.25 * map_.size().x) / scale);
  const Point left{map_.low.x + 1, map_.high.y + 20}, right = left + Point{length * scale, 0};
  const Polyline bar = {left - Point{0, 5}, left, right, right - Point{0, 5}};
  svg.OpenGroup("scale-bar");
  svg.Polyline(bar, {.stroke = kInkColour, .width = 1.8});
  const std::string text = RoundLengthText(length);
  svg.Text({.at = right + Point{8, 1}, .text = text, .size = 12});
  const double room = map_.high.x - right.x - TextWidth(text, 12) - 30;
  if (!remark.empty() && room > 60) {
    svg.Text({.at = {map_.high.x, right.y + 1},
              .text = Ellipsize(remark, 11, room),
              .size = 11,
              .anchor = TextAnchor::kEnd,
              .fill = kSecondaryInkColour});
  }
  svg.CloseGroup();
}

}  // namespace tautline
