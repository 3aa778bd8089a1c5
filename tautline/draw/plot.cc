#include "tautline/draw/plot.h"

#include <algorithm>
#include <cmath>

#include "tautline/draw/curve.h"
#include "tautline/draw/length_text.h"
#include "tautline/draw/text_metrics.h"

namespace tautline {
namespace {

constexpr double kTitleHeight = 24;
constexpr double kTitleSize = 13.5;
constexpr double kTickSize = 11;
constexpr double kLabelSize = 12;
constexpr double kNameSize = 12;
constexpr double kNameLine = 14.5;
constexpr double kFooter = 38;          // Ticks and label of the x axis.
constexpr double kLeastTickWidth = 30;  // So that plots one below the other align.
constexpr double kMostNameWidth = 180;
constexpr double kTickRoom = 90;  // Pixels between ticks of the x axis, about.
constexpr double kTickRoomY = 38;
constexpr double kHeadroom = 0.06;  // Of the range of y, above and below.
constexpr double kDotRadius = 3;
constexpr double kBandOpacity = 0.18;
constexpr char kGridColour[] = "#e3e6e9";
constexpr char kEventColour[] = "#8a9097";

struct Range {
  double low = 0;
  double high = 1;

  double size() const { return high - low; }
};

/// A range that is empty becomes 0 to 1, a flat one is widened about its value.
Range MakeRange(double low, double high) {
  if (!(low <= high)) return {0, 1};
  const double least = std::max(1e-9 * std::max(std::fabs(low), std::fabs(high)), 1e-9);
  if (high - low >= least) return {low, high};
  const double half = std::max(0.05 * std::fabs(low), 0.5);
  return {low - half, high + half};
}

template <class Visit>
void ForEachPoint(const PlotContent& content, Visit visit) {
  for (const PlotSeries& series : content.series) {
    for (const Polyline& part : series.parts) {
      for (const Point p : part) {
        if (IsFinite(p)) visit(p);
      }
    }
  }
  for (const PlotBand& band : content.bands) {
    for (const Polyline* edge : {&band.low, &band.high}) {
      for (const Point p : *edge) {
        if (IsFinite(p)) visit(p);
      }
    }
  }
}

/// As many decimals as the step between ticks needs.
int DecimalsOf(const std::vector<double>& ticks) {
  if (ticks.size() < 2) return 3;
  return std::clamp(static_cast<int>(std::ceil(-std::log10(ticks[1] - ticks[0]) - 1e-9)), 0, 9);
}

/// A name beside the right end of its curve.
struct Name {
  double y;
  std::string text;
  std::string colour;
};

/// Moves names apart, from the middle of each crowd, and keeps them between low and high.
void Spread(std::vector<Name>& names, double low, double high) {
  std::stable_sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.y < b.y; });
  for (int round = 0; round < 100; ++round) {
    bool moved = false;
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
      const double lacking = kNameLine - (names[i + 1].y - names[i].y);
      if (lacking <= 1e-6) continue;
      names[i].y -= 0.5 * lacking;
      names[i + 1].y += 0.5 * lacking;
      moved = true;
    }
    if (!moved) break;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i].y = std::max(names[i].y, i == 0 ? low : names[i - 1].y + kNameLine);
  }
  for (std::size_t i = names.size(); i-- > 0;) {
    names[i].y = std::min(names[i].y, i + 1 == names.size() ? high : names[i + 1].y - kNameLine);
  }
}

class Plotter {
 public:
  Plotter(SvgWriter& svg, const Box& frame, const PlotContent& content) : svg_(svg), frame_(frame), content_(content) {
    double low_x = 1e300, high_x = -1e300, low_y = content.with_zero ? 0 : 1e300,
           high_y = content.with_zero ? 0 : -1e300;
    ForEachPoint(content, [&](Point p) {
      low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
    });
    for (const PlotLevel& level : content.levels) {
      low_y = std::min(low_y, level.y), high_y = std::max(high_y, level.y);
    }
    x_ = MakeRange(low_x, high_x);
    y_ = MakeRange(low_y, high_y);
    y_ = {y_.low - kHeadroom * y_.size(), y_.high + kHeadroom * y_.size()};
    LayOut();
  }

  void Draw() {
    svg_.OpenGroup("plot");
    svg_.Text({.at = {area_.low.x, frame_.low.y + 15}, .text = content_.title, .size = kTitleSize, .bold = true});
    DrawAxes();
    DrawEvents();
    DrawSeries();
    DrawNames();
    svg_.CloseGroup();
  }

 private:
  void LayOut() {
    const double height = frame_.size().y - kTitleHeight - kFooter;
    y_ticks_ = RoundTicks(y_.low, y_.high, std::max(2, static_cast<int>(height / kTickRoomY)));
    double tick_width = kLeastTickWidth, name_width = 0;
    for (const double tick : y_ticks_) tick_width = std::max(tick_width, TickWidth(tick));
    for (const PlotSeries& series : content_.series) {
      name_width = std::max(name_width, TextWidth(series.name, kNameSize));
    }
    area_.low = {frame_.low.x + 22 + tick_width, frame_.low.y + kTitleHeight};
    area_.high = {frame_.high.x - std::min(name_width, kMostNameWidth) - 14, frame_.high.y - kFooter};
    x_ticks_ = RoundTicks(x_.low, x_.high, std::max(2, static_cast<int>(area_.size().x / kTickRoom)));
  }

  double TickWidth(double tick) const { return TextWidth(CompactText(tick, DecimalsOf(y_ticks_)), kTickSize); }

  Point ToPixels(Point p) const {
    return {area_.low.x + (p.x - x_.low) / x_.size() * area_.size().x,
            area_.high.y - (p.y - y_.low) / y_.size() * area_.size().y};
  }

  void Segment(Point a, Point b, const SvgStyle& style) { svg_.Polyline(Polyline{a, b}, style); }

  void DrawAxes() {
    const SvgStyle grid{.stroke = kGridColour, .width = 0.9}, axis{.stroke = kInkColour, .width = 1.1};
    for (const double tick : y_ticks_) {
      const double y = ToPixels({x_.low, tick}).y;
      Segment({area_.low.x, y}, {area_.high.x, y}, grid);
      Segment({area_.low.x - 4, y}, {area_.low.x, y}, axis);
      svg_.Text({.at = {area_.low.x - 7, y + 4},
                 .text = CompactText(tick, DecimalsOf(y_ticks_)),
                 .size = kTickSize,
                 .anchor = TextAnchor::kEnd});
    }
    for (const double tick : x_ticks_) {
      const double x = ToPixels({tick, y_.low}).x;
      Segment({x, area_.low.y}, {x, area_.high.y}, grid);
      Segment({x, area_.high.y}, {x, area_.high.y + 4}, axis);
      svg_.Text({.at = {x, area_.high.y + 16},
                 .text = CompactText(tick, DecimalsOf(x_ticks_)),
                 .size = kTickSize,
                 .anchor = TextAnchor::kMiddle});
    }
    if (y_.low < 0 && y_.high > 0) {
      const double y = ToPixels({x_.low, 0}).y;
      Segment({area_.low.x, y}, {area_.high.x, y}, {.stroke = kSecondaryInkColour, .width = 0.9});
    }
    for (const PlotLevel& level : content_.levels) {
      const double y = ToPixels({x_.low, level.y}).y;
      Segment({area_.low.x, y}, {area_.high.x, y}, {.stroke = kWarningColour, .width = 1, .dashes = "7 4"});
    }
    svg_.Polyline(Polyline{area_.low, {area_.low.x, area_.high.y}, area_.high}, axis);
    svg_.Text({.at = {area_.high.x, area_.high.y + 32},
               .text = content_.x_label,
               .size = kLabelSize,
               .anchor = TextAnchor::kEnd});
    // Beside the title: turned letters are hard to read.
    const double title = TextWidth(content_.title, kTitleSize, true);
    svg_.Text({.at = {area_.low.x + title + 14, frame_.low.y + 15},
               .text = content_.y_label,
               .size = kLabelSize,
               .fill = kSecondaryInkColour});
  }

  void DrawEvents() {
    double free_from =
        area_.low.x + TextWidth(content_.title, kTitleSize, true) + TextWidth(content_.y_label, kLabelSize) + 30;
    for (const PlotEvent& event : content_.events) {
      const double x = ToPixels({event.x, y_.low}).x;
      Segment({x, area_.low.y}, {x, area_.high.y}, {.stroke = kEventColour, .width = 0.9, .dashes = "2 3"});
      const double width = TextWidth(event.text, kTickSize);
      if (event.text.empty() || x - 0.5 * width < free_from || x + 0.5 * width > area_.high.x) continue;
      svg_.Text({.at = {x, area_.low.y - 3},
                 .text = event.text,
                 .size = kTickSize,
                 .anchor = TextAnchor::kMiddle,
                 .fill = kSecondaryInkColour});
      free_from = x + 0.5 * width + 6;
    }
  }

  void DrawSeries() {
    svg_.OpenWindow("series", {{area_.low.x - 2, area_.low.y - 2}, {area_.high.x + 2, area_.high.y + 2}});
    for (const PlotBand& band : content_.bands) {
      Ring ring;
      for (const Point p : band.low) ring.push_back(ToPixels(p));
      for (std::size_t i = band.high.size(); i-- > 0;) ring.push_back(ToPixels(band.high[i]));
      svg_.Polygon(std::vector<Ring>{ring}, {.fill = band.colour, .opacity = kBandOpacity});
    }
    for (const PlotSeries& series : content_.series) {
      for (const Polyline& part : series.parts) {
        Polyline pixels;
        for (const Point p : part) {
          if (IsFinite(p)) pixels.push_back(ToPixels(p));
        }
        DrawCurve(svg_, pixels, series.style);
      }
    }
    for (const PlotSeries& series : content_.series) {
      for (const Point dot : series.dots) {
        svg_.Circle(ToPixels(dot), kDotRadius, {.fill = kFreeColour, .stroke = series.style.colour, .width = 1.6});
      }
    }
    svg_.CloseWindow();
  }

  void DrawNames() {
    for (const PlotLevel& level : content_.levels) {
      svg_.Text({.at = {area_.low.x + 6, ToPixels({x_.low, level.y}).y + 4},
                 .text = level.text,
                 .size = kTickSize,
                 .fill = kWarningColour,
                 .halo = kHaloColour});
    }
    std::vector<Name> names;
    for (const PlotSeries& series : content_.series) {
      if (series.name.empty() || series.parts.empty() || series.parts.back().empty()) continue;
      names.push_back({ToPixels(series.parts.back().back()).y, series.name, series.style.colour});
    }
    Spread(names, area_.low.y + 4, area_.high.y - 4);
    for (const Name& name : names) {
      svg_.Text({.at = {area_.high.x + 8, name.y + 4},
                 .text = Ellipsize(name.text, kNameSize, kMostNameWidth),
                 .size = kNameSize,
                 .fill = name.colour});
    }
  }

  SvgWriter& svg_;
  Box frame_;
  const PlotContent& content_;
  Range x_;
  Range y_;
  Box area_;
  std::vector<double> x_ticks_;
  std::vector<double> y_ticks_;
};

}  // namespace

std::vector<double> RoundTicks(double low, double high, int count) {
  // The next round length above would leave too few ticks: the largest below, doubled while there are too many.
  double step = RoundLengthBelow((high - low) / count);
  const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
  if ((high - low) / step > 1.5 * count) step *= mantissa > 1.5 && mantissa < 2.5 ? 2.5 : 2;
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    ticks.push_back(k == 0 ? 0 : k * step);
  }
  return ticks;
}

void DrawPlot(SvgWriter& svg, const Box& frame, const PlotContent& content) { Plotter(svg, frame, content).Draw(); }

}  // namespace tautline
