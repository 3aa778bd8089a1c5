#include "tautline/homotopy/taut_strings.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"
#include "tautline/geometry/predicates.h"
#include "tautline/homotopy/pin_grid.h"
#include "tautline/homotopy/string_line.h"

namespace tautline {
namespace {

bool IsToward(Point p, Point a, Point b) { return Orientation(p, a, b) == 0 && Dot(a - p, b - p) > 0; }

/// A string's image while a pin moves from a to b. The motion drags along what it meets, within a tube around ab that
/// is as thin as one likes: an edge that crosses ab becomes a finger around the pin at b, and a string that passes the
/// pin at a follows it there and comes back, except when the pin leaves it through the gap between its two arms.
class Pusher {
 public:
  Pusher(PinId pin, Point a, Point b, bool leaves_base, const PinsNear& pins_near)
      : pin_(pin), a_(a), b_(b), leaves_base_(leaves_base), pins_near_(pins_near) {}

  /// The image, not yet taut; false when the string is not met.
  bool Push(const StringLine& line, StringLine& image) {
    image_.clear();
    met_ = false;
    StringVertex next = line[0];
    for (std::size_t i = 0; i < line.size(); ++i) {
      const StringVertex vertex = next;
      if (i + 1 < line.size()) next = line[i + 1];
      const Point before = i > 0 ? line[i - 1].at : vertex.at;
      if (vertex.at != a_) {
        image_.push_back(vertex);
      } else if (i == 0 || i + 1 == line.size()) {
        Lead(i == 0);
      } else {
        Pass(vertex, before, next.at);
      }
      if (i + 1 < line.size() && vertex.at != a_ && next.at != a_) Cross(line, i, next);
    }
    if (met_) image = std::move(image_);
    return met_;
  }

 private:
  StringVertex Moved(int turns) const { return {pin_, b_, turns}; }

  /// The string begins or ends at the pin.
  void Lead(bool begins) {
    TAUTLINE_CHECK(!leaves_base_);
    met_ = true;
    if (begins) image_.push_back(Moved(0));
    image_.push_back({PinId(), a_});
    if (!begins) image_.push_back(Moved(0));
  }

  /// The string passes a, where the pin was or where it is tied.
  void Pass(const StringVertex& at_a, Point before, Point after) {
    const bool left = HeldSide(at_a, before, after) == Side::kLeft;
    const int sign = left ? 1 : -1;
    if (sign * Orientation(a_, after, b_) > 0 && sign * Orientation(a_, b_, before) > 0) {
      if (leaves_base_) return image_.push_back(at_a);
      met_ = true;
      return image_.push_back({PinId(), a_});
    }
    met_ = true;
    const bool back = IsToward(a_, before, b_), ahead = IsToward(a_, after, b_);
    const int beside = left ? 0 : -1;
    if (leaves_base_) return PassBase(at_a, before, after, left);
    if (back && ahead) return image_.push_back(Moved(sign));
    if (back) image_.push_back(Moved(beside));
    image_.push_back({PinId(), a_});
    if (ahead) image_.push_back(Moved(beside));
    if (back || ahead) return;
    image_.push_back(Moved(sign));
    image_.push_back({PinId(), a_});
  }

  void PassBase(const StringVertex& base, Point before, Point after, bool left) {
    const bool back = IsToward(a_, before, b_), ahead = IsToward(a_, after, b_);
    const int beside = left ? 0 : -1;
    if (back) image_.push_back(Moved(beside));
    if (back || ahead) image_.push_back(base);
    if (ahead) image_.push_back(Moved(beside));
    if (back || ahead) return;
    image_.push_back({base.pin, a_, Part(before, b_, left)});
    image_.push_back(Moved(left ? 1 : -1));
    image_.push_back({base.pin, a_, Part(b_, after, left)});
  }

  /// The turns of a sweep around a from one direction to another, to one side, that is less than a whole turn.
  int Part(Point from, Point to, bool left) const {
    const int angle = AngleAt(a_, from, to);
    if (left) return angle < 0 ? 1 : 0;
    return angle > 0 ? -1 : 0;
  }

  /// The edge from line[i] to `next`, where `next` may know already that the edge before it was bent.
  void Cross(const StringLine& line, std::size_t i, StringVertex& next) {
    const Point u = line[i].at, w = line[i + 1].at;
    if (std::max(u.x, w.x) < std::min(a_.x, b_.x) || std::min(u.x, w.x) > std::max(a_.x, b_.x)) return;
    const int side = Orientation(u, w, b_);
    if (side == 0) {
      if (!OnSegment(u, w, b_)) return;
      met_ = true;
      const bool left = Orientation(u, w, a_) > 0;
      return image_.push_back(Moved(left ? 0 : -1));
    }
    if (!CrossProperly(u, w, a_, b_)) return;
    met_ = true;
    StringLine there = ChainAround(u, b_, side, Swept(u, w, u));
    StringLine back = ChainAround(b_, w, side, Swept(u, w, w));
    const Point first = there.empty() ? b_ : there.front().at, last = back.empty() ? b_ : back.back().at;
    const Point entry = there.empty() ? u : there.back().at, exit = back.empty() ? w : back.front().at;
    if (i > 0) {
      // What stands in the image before this vertex is where it comes from now.
      ExchangeNext(image_.back(), image_[image_.size() - 2].at, w, first);
    }
    StringVertex tip = Moved(side > 0 ? -1 : 1);
    ExchangePrevious(tip, a_, a_, entry);
    ExchangeNext(tip, entry, a_, exit);
    image_.insert(image_.end(), there.begin(), there.end());
    image_.push_back(tip);
    image_.insert(image_.end(), back.begin(), back.end());
    if (i + 2 < line.size()) ExchangePrevious(next, line[i + 2].at, u, last);
  }

  /// The pins in the triangle of `end`, which is u or w, of b, and of the point X where uw crosses ab. X has no exact
  /// coordinates, but its three sides do: uw, ab, and the line from the end to b.
  std::vector<StringVertex> Swept(Point u, Point w, Point end) const {
    const int of_b = Orientation(u, w, b_), of_end = Orientation(a_, b_, end), of_a = Orientation(end, b_, a_);
    std::vector<StringVertex> swept;
    pins_near_(u, w, b_, [&](PinId pin, Point p) {
      if (Orientation(u, w, p) == of_b && Orientation(a_, b_, p) == of_end && of_a * Orientation(end, b_, p) >= 0) {
        swept.push_back({pin, p});
      }
    });
    return swept;
  }

  PinId pin_;
  Point a_, b_;
  bool leaves_base_;
  const PinsNear& pins_near_;
  StringLine image_;
  bool met_ = false;
};

}  // namespace

/// Pins, strings, and where both are.
class TautStrings::Tangle {
 public:
  Tangle(std::span<const Point> pins, std::span<const Point> places)
      : pins_(pins.begin(), pins.end()), base_of_(pins.size()), grid_(pins, places), pins_near_(NearPins()) {}
  Tangle(const Tangle&) = delete;
  Tangle& operator=(const Tangle&) = delete;

  StringId Tie(PinId tied, PinId holder) {
    const StringId id(lines_.size());
    const Point at = pins_[tied.index()];
    TAUTLINE_CHECK(tied != holder && pins_[holder.index()] == at && !base_of_[holder.index()].valid());
    // Until it leaves, the pin that it is tied to stands for both.
    grid_.Remove(holder, at);
    base_of_[holder.index()] = id;
    lines_.push_back({{tied, at}, {holder, at}});
    bends_.push_back({{tied}, {holder}});
    grid_.Place(id, {});
    return id;
  }

  tl::expected<void, PinCollision> Move(PinId pin, Point to) {
    const Point from = pins_[pin.index()];
    if (from == to) return {};
    const StringId own = base_of_[pin.index()];
    const PinId base = own.valid() ? lines_[own.index()].front().pin : PinId();
    PinId met;
    grid_.ForEachPin(from, to, to, [&](PinId other) {
      if (other != pin && other != base && !met.valid() && OnSegment(from, to, pins_[other.index()])) met = other;
    });
    if (met.valid()) return tl::unexpected(PinCollision{pin, met});
    const std::vector<StringId> near = grid_.StringsAlong(from, to);
    if (!own.valid()) grid_.Remove(pin, from);
    grid_.Add(pin, to);
    pins_[pin.index()] = to;
    Pusher pusher(pin, from, to, own.valid(), pins_near_);
    StringLine image;
    for (const StringId id : near) {
      if (pusher.Push(lines_[id.index()], image)) Settle(id, std::move(image));
    }
    if (own.valid()) {
      base_of_[pin.index()] = StringId();
      Settle(own, {{base, from}, {pin, to}});
    }
    return {};
  }

  Point point(PinId pin) const { return pins_[pin.index()]; }
  std::size_t pin_count() const { return pins_.size(); }
  std::size_t size() const { return lines_.size(); }
  const StringLine& line(StringId id) const { return lines_[id.index()]; }
  std::span<const StringBend> bends(StringId id) const { return bends_[id.index()]; }

 private:
  PinsNear NearPins() {
    return [this](Point a, Point b, Point c, const std::function<void(PinId, Point)>& visit) {
      grid_.ForEachPin(a, b, c, [&](PinId pin) { visit(pin, pins_[pin.index()]); });
    };
  }

  void Settle(StringId id, StringLine line) {
    PullTaut(line, pins_near_);
    auto& bends = bends_[id.index()];
    bends.clear();
    Polyline points;
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool is_end = i == 0 || i + 1 == line.size();
      bends.push_back({line[i].pin, is_end ? Side::kNone : HeldSide(line[i], line[i - 1].at, line[i + 1].at)});
      points.push_back(line[i].at);
    }
    grid_.Place(id, points);
    lines_[id.index()] = std::move(line);
  }

  std::vector<Point> pins_;
  std::vector<StringId> base_of_;  ///< By PinId: the string of length zero that it holds, where it stands on its base.
  std::vector<StringLine> lines_;
  std::vector<std::vector<StringBend>> bends_;
  PinGrid grid_;
  PinsNear pins_near_;
};

TautStrings::TautStrings(std::span<const Point> pins, std::span<const Point> places)
    : tangle_(std::make_unique<Tangle>(pins, places)) {}
TautStrings::~TautStrings() = default;
TautStrings::TautStrings(TautStrings&&) noexcept = default;
TautStrings& TautStrings::operator=(TautStrings&&) noexcept = default;

StringId TautStrings::Tie(PinId tied, PinId holder) { return tangle_->Tie(tied, holder); }

tl::expected<void, PinCollision> TautStrings::Move(PinId pin, Point to) { return tangle_->Move(pin, to); }

Point TautStrings::point(PinId pin) const { return tangle_->point(pin); }

std::span<const StringBend> TautStrings::bends(StringId string) const { return tangle_->bends(string); }

double TautStrings::length(StringId string) const {
  double length = 0;
  const StringLine& line = tangle_->line(string);
  for (std::size_t i = 1; i < line.size(); ++i) length += Distance(line[i - 1].at, line[i].at);
  return length;
}

Polyline TautStrings::points(StringId string) const {
  Polyline points;
  for (const StringVertex& vertex : tangle_->line(string)) points.push_back(vertex.at);
  return points;
}

std::size_t TautStrings::size() const { return tangle_->size(); }

std::size_t TautStrings::pin_count() const { return tangle_->pin_count(); }

}  // namespace tautline
