#include "tautline/draw/svg_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tautline/base/check.h"
#include "tautline/draw/length_text.h"

namespace tautline {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

/// Coordinates beyond this many pixels are far outside of any picture; renderers lose precision
/// there.
constexpr double kFarAway = 1e6;

/// The length in bytes of the well-formed UTF-8 character at the start of `text` that XML 1.0
/// allows, or 0.
std::size_t CharacterLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7F ? 1 : 0;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool surrogate = lead == 0xED && byte(1) >= 0xA0;
  const bool too_large = lead == 0xF4 && byte(1) >= 0x90;
  const bool not_a_character = lead == 0xEF && byte(1) == 0xBF && byte(2) >= 0xBE;
  return overlong || surrogate || too_large || not_a_character ? 0 : length;
}

/// Builds the `d` attribute from points on a grid of 10^-decimals pixels, with relative moves, so
/// that rounding does not add up and shared digits are not repeated.
class PathData {
 public:
  explicit PathData(int decimals) : decimals_(decimals), scale_(std::pow(10, decimals)) {}

  void Add(std::span<const Point> points, bool closed) {
    bool started = false;
    std::int64_t moves = 0;
    for (const Point p : points) {
      if (!IsFinite(p)) continue;
      const Cell cell{Snap(p.x), Snap(p.y)};
      if (!started) {
        Start(cell);
        started = true;
      } else if (cell.x != last_.x || cell.y != last_.y) {
        LineTo(cell);
        ++moves;
      }
    }
    if (started && moves == 0) text_ += "h0";  // A dot, by the round caps.
    if (started && moves > 0 && closed) text_ += 'z';
    if (closed) last_ = first_;
  }

  void Add(const SvgCurve& curve) {
    Start({Snap(curve.start.x), Snap(curve.start.y)});
    const std::size_t before = text_.size();
    for (const SvgCurve::Step& step : curve.steps) {
      const Cell cell{Snap(step.to.x), Snap(step.to.y)};
      if (cell.x == last_.x && cell.y == last_.y) continue;
      if (step.radius > 0) {
        ArcTo(cell, step);
      } else {
        LineTo(cell);
      }
    }
    if (text_.size() == before) text_ += "h0";  // A dot, by the round caps.
    if (!curve.closed) return;
    text_ += 'z';
    last_ = first_;
  }

  const std::string& text() const { return text_; }

 private:
  struct Cell {
    std::int64_t x = 0;
    std::int64_t y = 0;
  };

  std::int64_t Snap(double v) const { return std::llround(std::clamp(v, -kFarAway, kFarAway) * scale_); }
  std::string Number(std::int64_t cells) const { return CompactText(static_cast<double>(cells) / scale_, decimals_); }

  void Start(Cell cell) {
    text_ += 'M' + Number(cell.x) + ' ' + Number(cell.y);
    first_ = last_ = cell;
  }

  void LineTo(Cell cell) {
    const std::int64_t dx = cell.x - last_.x, dy = cell.y - last_.y;
    if (dy == 0) {
      text_ += 'h' + Number(dx);
    } else if (dx == 0) {
      text_ += 'v' + Number(dy);
    } else {
      text_ += 'l' + Number(dx) + (dy < 0 ? "" : " ") + Number(dy);
    }
    last_ = cell;
  }

  void ArcTo(Cell cell, const SvgCurve::Step& step) {
    const std::int64_t dx = cell.x - last_.x, dy = cell.y - last_.y;
    const std::string radius = CompactText(std::min(step.radius, kFarAway), decimals_ + 1);
    text_ += 'a' + radius + ' ' + radius + " 0 0 " + (step.anticlockwise ? "0 " : "1 ") + Number(dx) +
             (dy < 0 ? "" : " ") + Number(dy);
    last_ = cell;
  }

  int decimals_;
  double scale_;
  std::string text_;
  Cell first_;
  Cell last_;
};

}  // namespace

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t length = CharacterLength(text);
    switch (length == 1 ? text[0] : '\0') {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += length > 0 ? text.substr(0, length) : kReplacement;
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return escaped;
}

SvgWriter::SvgWriter(const Options& options) : decimals_(options.decimals) {
  const std::string width = Number(options.width), height = Number(options.height);
  out_ =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "width=\"" +
      width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
      "\" font-family=\"sans-serif\" stroke-linejoin=\"round\" stroke-linecap=\"round\" "
      "role=\"img\">\n";
  if (!options.title.empty()) out_ += "<title>" + EscapeXml(options.title) + "</title>\n";
  Rectangle({{0, 0}, {options.width, options.height}}, {.fill = "#ffffff"});
}

void SvgWriter::OpenGroup(std::string_view layer) {
  out_ += "<g class=\"" + EscapeXml(layer) + "\">\n";
  ++open_;
}

void SvgWriter::CloseGroup() {
  TAUTLINE_CHECK(open_ > 0);
  out_ += "</g>\n";
  --open_;
}

void SvgWriter::OpenWindow(std::string_view layer, const Box& window) {
  const std::string size = Number(window.size().x) + "\" height=\"" + Number(window.size().y);
  const std::string corner = Number(window.low.x) + "\" y=\"" + Number(window.low.y);
  // A nested viewport clips without an id, so that several pictures can stand in one page. Its own
  // coordinates are those of the page.
  out_ += "<svg class=\"" + EscapeXml(layer) + "\" x=\"" + corner + "\" width=\"" + size + "\" viewBox=\"" +
          Number(window.low.x) + " " + Number(window.low.y) + " " + Number(window.size().x) + " " +
          Number(window.size().y) + "\" overflow=\"hidden\">\n";
  ++open_;
}

void SvgWriter::CloseWindow() {
  TAUTLINE_CHECK(open_ > 0);
  out_ += "</svg>\n";
  --open_;
}

void SvgWriter::DefineHatch(std::string_view ground, std::string_view line) {
  out_ +=
      "<defs><pattern id=\"tautline-hatch\" width=\"6\" height=\"6\" "
      "patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"" +
      EscapeXml(ground) + "\"/><path d=\"M0 0v6\" stroke=\"" + EscapeXml(line) +
      "\" stroke-width=\"2\"/></pattern></defs>\n";
}

void SvgWriter::Polygon(std::span<const Ring> rings, const SvgStyle& style) {
  PathData data(decimals_);
  for (const Ring& ring : rings) data.Add(ring, true);
  Path(data.text(), style, true);
}

void SvgWriter::Polylines(std::span<const tautline::Polyline> lines, const SvgStyle& style) {
  PathData data(decimals_);
  for (const tautline::Polyline& line : lines) data.Add(line, false);
  Path(data.text(), style, false);
}

void SvgWriter::Polyline(std::span<const Point> line, const SvgStyle& style) {
  PathData data(decimals_);
  data.Add(line, false);
  Path(data.text(), style, false);
}

void SvgWriter::Curves(std::span<const SvgCurve> curves, const SvgStyle& style) {
  PathData data(decimals_);
  for (const SvgCurve& curve : curves) data.Add(curve);
  Path(data.text(), style, true);
}

void SvgWriter::Smooth(std::span<const Point> points, const SvgStyle& style) {
  if (points.size() < 3) return Polyline(points, style);
  std::string data = 'M' + Pair(points[0]);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const bool last = i + 2 == points.size();
    data += 'Q' + Pair(points[i]) + ' ' + Pair(last ? points[i + 1] : Lerp(points[i], points[i + 1], 0.5));
  }
  Path(data, style, false);
}

void SvgWriter::Circle(Point centre, double radius, const SvgStyle& style) {
  if (!IsFinite(centre) || !std::isfinite(radius)) return;
  out_ += "<circle cx=\"" + Number(centre.x) + "\" cy=\"" + Number(centre.y) + "\" r=\"" + Number(radius) + "\"";
  AppendStyle(style);
}

void SvgWriter::Rectangle(const Box& box, const SvgStyle& style, double corner_radius) {
  out_ += "<rect x=\"" + Number(box.low.x) + "\" y=\"" + Number(box.low.y) + "\" width=\"" + Number(box.size().x) +
          "\" height=\"" + Number(box.size().y) + "\"";
  if (corner_radius > 0) out_ += " rx=\"" + Number(corner_radius) + "\"";
  AppendStyle(style);
}

void SvgWriter::ArrowHead(Point middle, Point direction, double size, const SvgStyle& style) {
  const double norm = Norm(direction);
  if (!(norm > 0) || !std::isfinite(norm)) return;
  const Point along = 0.5 * size / norm * direction;
  const Point across{-0.9 * along.y, 0.9 * along.x};
  const Ring head = {middle + along, middle - along + across, middle - 0.55 * along, middle - along - across};
  Polygon({&head, 1}, style);
}

void SvgWriter::Text(const SvgText& text) {
  if (!IsFinite(text.at)) return;
  OpenText(text);
  out_ += EscapeXml(text.text) + "</text>\n";
}

void SvgWriter::MovingPolyline(std::span<const tautline::Polyline> keyframes, const SvgMotion& motion,
                               const SvgStyle& style) {
  TAUTLINE_CHECK(keyframes.size() == motion.times.size() && !keyframes.empty());
  std::vector<std::string> values;
  for (const tautline::Polyline& line : keyframes) {
    TAUTLINE_CHECK(line.size() == keyframes[0].size());
    std::string value;
    for (const Point p : line) value += (value.empty() ? "" : " ") + Pair(p);
    values.push_back(std::move(value));
  }
  out_ += "<polyline points=\"" + values.back() + "\"";
  AppendStyle(style, true);
  Animate("points", motion, "linear", values);
  out_ += "</polyline>\n";
}

void SvgWriter::MovingCircle(std::span<const Point> centres, double radius, const SvgMotion& motion,
                             const SvgStyle& style) {
  TAUTLINE_CHECK(centres.size() == motion.times.size() && !centres.empty());
  std::vector<std::string> x, y;
  for (const Point p : centres) {
    x.push_back(Number(p.x));
    y.push_back(Number(p.y));
  }
  out_ += "<circle cx=\"" + x.back() + "\" cy=\"" + y.back() + "\" r=\"" + Number(radius) + "\"";
  AppendStyle(style, true);
  Animate("cx", motion, "linear", x);
  Animate("cy", motion, "linear", y);
  out_ += "</circle>\n";
}

void SvgWriter::TextInTurns(const SvgText& text, std::span<const std::string> turns, const SvgMotion& motion) {
  TAUTLINE_CHECK(turns.size() == motion.times.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const bool last = i + 1 == turns.size();
    SvgMotion turn{.times = {0}, .duration_s = motion.duration_s};
    std::vector<std::string> values = {i == 0 ? "visible" : "hidden"};
    if (i > 0) {
      turn.times.push_back(motion.times[i]);
      values.emplace_back("visible");
    }
    if (!last) {
      turn.times.push_back(motion.times[i + 1]);
      values.emplace_back("hidden");
    }
    OpenText(text, last ? "" : " visibility=\"hidden\"");
    out_ += EscapeXml(turns[i]);
    Animate("visibility", turn, "discrete", values);
    out_ += "</text>\n";
  }
}

void SvgWriter::Animate(std::string_view attribute, const SvgMotion& motion, std::string_view mode,
                        std::span<const std::string> values) {
  out_ += "<animate attributeName=\"" + EscapeXml(attribute) + "\" dur=\"" + CompactText(motion.duration_s, 3) +
          "s\" repeatCount=\"indefinite\" calcMode=\"" + EscapeXml(mode) + "\" keyTimes=\"";
  for (std::size_t i = 0; i < motion.times.size(); ++i) {
    out_ += (i == 0 ? "" : ";") + CompactText(motion.times[i], 5);
  }
  out_ += "\" values=\"";
  for (std::size_t i = 0; i < values.size(); ++i) out_ += (i == 0 ? "" : ";") + values[i];
  out_ += "\"/>\n";
}

void SvgWriter::OpenText(const SvgText& text, std::string_view more) {
  out_ += "<text x=\"" + Number(text.at.x) + "\" y=\"" + Number(text.at.y) + "\" font-size=\"" + Number(text.size) +
          "\" fill=\"" + EscapeXml(text.fill) + "\"";
  if (text.anchor == TextAnchor::kMiddle) out_ += " text-anchor=\"middle\"";
  if (text.anchor == TextAnchor::kEnd) out_ += " text-anchor=\"end\"";
  if (text.bold) out_ += " font-weight=\"bold\"";
  if (text.italic) out_ += " font-style=\"italic\"";
  if (!text.halo.empty()) {
    out_ += " stroke=\"" + EscapeXml(text.halo) + "\" stroke-width=\"3\" paint-order=\"stroke\"";
  }
  out_ += more;
  out_ += '>';
}

std::string SvgWriter::Finish() {
  TAUTLINE_CHECK(open_ == 0);
  out_ += "</svg>\n";
  return std::move(out_);
}

void SvgWriter::Path(const std::string& data, const SvgStyle& style, bool even_odd) {
  if (data.empty()) return;
  out_ += "<path d=\"" + data + "\"";
  if (even_odd && style.fill != "none") out_ += " fill-rule=\"evenodd\"";
  AppendStyle(style);
}

void SvgWriter::AppendStyle(const SvgStyle& style, bool open_element) {
  out_ += " fill=\"" + EscapeXml(style.fill) + "\"";
  if (style.opacity < 1) out_ += " fill-opacity=\"" + CompactText(style.opacity, 4) + "\"";
  if (style.stroke != "none") {
    out_ += " stroke=\"" + EscapeXml(style.stroke) + "\"";
    if (style.width != 1) out_ += " stroke-width=\"" + Number(style.width) + "\"";
    // Round caps would close short gaps.
    if (!style.dashes.empty()) out_ += " stroke-dasharray=\"" + EscapeXml(style.dashes) + "\" stroke-linecap=\"butt\"";
  }
  out_ += open_element ? ">\n" : "/>\n";
}

std::string SvgWriter::Number(double value) const { return CompactText(std::clamp(value, -kFarAway, kFarAway), 2); }

std::string SvgWriter::Pair(Point p) const {
  return CompactText(std::clamp(p.x, -kFarAway, kFarAway), decimals_) + ' ' +
         CompactText(std::clamp(p.y, -kFarAway, kFarAway), decimals_);
}

}  // namespace tautline
