#include "tautline/planners/cable_workspace/cable_sections.h"

#include <algorithm>
#include <cmath>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"

namespace tautline {
namespace {

/// A straight way of positive length, or a robot that stays.
struct Way {
  Point from;
  Point to;
  double length;
  Point heading;
};

Way WayOf(const CableEnds& cables) {
  Way way{cables.before.back(), cables.after.back(), 0, {}};
  way.length = Distance(way.from, way.to);
  if (way.length > 0) way.heading = (1 / way.length) * (way.to - way.from);
  return way;
}

/// Where the edge from a to b, prolonged beyond b, hits the way. Where it runs nearly along the way, rounding moves the
/// place far, but not to the near side of b.
double HitBeyond(const Way& way, Point a, Point b) {
  const double foot = Dot(b - way.from, way.heading), turn = Cross(way.heading, b - a);
  const double hit = turn == 0 ? foot : Cross(a - way.from, b - a) / turn;
  return Dot(b - a, way.heading) >= 0 ? std::max(hit, foot) : std::min(hit, foot);
}

/// Foot and distance of the corner; exact where it lies on the line or at an end, so that slopes there are.
void PlaceCorner(const Way& way, CableSection& section) {
  section.along = section.corner == way.from ? 0
                  : section.corner == way.to ? way.length
                                             : Dot(section.corner - way.from, way.heading);
  const bool on_line = Orientation(way.from, way.to, section.corner) == 0;
  section.off = on_line ? 0 : std::fabs(Cross(way.heading, section.corner - way.from));
}

/// Collects sections whose ends do not decrease; empty ones are left out.
class Sections {
 public:
  explicit Sections(const Way& way) : way_(way) {}

  /// The cable bends last at the end of `via`.
  void Add(std::span<const Point> via, double to_corner, double end) {
    const double begin = sections_.empty() ? 0 : sections_.back().end;
    CableSection section{.via = {via.begin(), via.end()}, .corner = via.back(), .to_corner = to_corner, .begin = begin};
    section.end = std::clamp(end, begin, way_.length);
    if (section.end == begin) return;
    PlaceCorner(way_, section);
    if (section.off == 0 && section.along > section.begin && section.along < section.end) {
      CableSection first = section;
      section.begin = first.end = section.along;
      sections_.push_back(first);
    }
    sections_.push_back(section);
  }

  std::vector<CableSection> Finish() {
    TAUTLINE_CHECK(!sections_.empty());
    sections_.back().end = way_.length;
    return std::move(sections_);
  }

 private:
  const Way& way_;
  std::vector<CableSection> sections_;
};

/// Of a robot that stays.
CableSection Standing(const CableEnds& cables) {
  const std::span<const Point> via = cables.before.first(std::max<std::size_t>(cables.before.size(), 2) - 1);
  CableSection section{.via = {via.begin(), via.end()}, .corner = via.back()};
  section.to_corner = cables.stub_length + Length(via);
  section.off = Distance(section.corner, cables.before.back());
  return section;
}

}  // namespace

double CableSection::LengthAt(double distance) const { return to_corner + Norm({distance - along, off}); }

double CableSection::SlopeAt(double distance) const {
  if (off > 0) return (distance - along) / Norm({distance - along, off});
  return 0.5 * (begin + end) >= along ? 1 : -1;
}

std::vector<CableSection> CableSections(const CableEnds& cables) {
  const std::span<const Point> before = cables.before, after = cables.after;
  TAUTLINE_CHECK(!before.empty() && !after.empty() && before[0] == after[0]);
  const Way way = WayOf(cables);
  if (way.length == 0) return {Standing(cables)};
  std::size_t shared = 1;
  double to_apex = cables.stub_length;
  for (; shared < before.size() && shared < after.size() && before[shared] == after[shared]; ++shared) {
    to_apex += Distance(before[shared - 1], before[shared]);
  }
  Sections sections(way);
  // The last point of each is the robot; from the corner before it back to the apex, and from there on.
  std::vector<double> lengths{to_apex};
  for (std::size_t i = shared; i + 1 < before.size(); ++i) {
    lengths.push_back(lengths.back() + Distance(before[i - 1], before[i]));
  }
  for (std::size_t i = before.size() - 1; i-- > shared;) {
    sections.Add(before.first(i + 1), lengths[i - shared + 1], HitBeyond(way, before[i - 1], before[i]));
  }
  double length = to_apex;
  for (std::size_t i = shared - 1; i + 1 < after.size(); ++i) {
    if (i >= shared) length += Distance(after[i - 1], after[i]);
    const bool last = i + 2 >= after.size();
    sections.Add(after.first(i + 1), length, last ? way.length : HitBeyond(way, after[i], after[i + 1]));
  }
  // The robot has come to the apex itself.
  if (shared == after.size()) sections.Add(after, to_apex, way.length);
  return sections.Finish();
}

}  // namespace tautline
