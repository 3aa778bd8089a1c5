#include "tautline/cable/cable.h"

#include <algorithm>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// More links than this is a mistake in the units.
constexpr double kMostLinks = 1e6;

std::optional<Error> FaultIn(const CableOptions& options) {
  const auto fault = [](std::string message, std::string where) {
    return Error{ErrorCode::kInvalidInput, std::move(message), std::move(where)};
  };
  if (!(options.length_m > 0) || !std::isfinite(options.length_m)) {
    return fault("the length of a cable must be a positive number of metres", "length_m");
  }
  if (!(options.link_length_m > 0) || !std::isfinite(options.link_length_m)) {
    return fault("the length of a link must be a positive number of metres", "link_length_m");
  }
  if (options.length_m / options.link_length_m > kMostLinks) {
    return fault("more than 1000000 links; choose longer ones", "link_length_m");
  }
  if (!(options.robot_radius_m >= 0) || !std::isfinite(options.robot_radius_m)) {
    return fault("the radius of a robot must be zero or a positive number of metres", "robot_radius_m");
  }
  return std::nullopt;
}

}  // namespace

Cable::Cable(const TautSpace& space, Place base, const CableOptions& options)
    : space_(&space), options_(options), nodes_{base, base}, links_{Strand(base.triangle)} {}

Expected<Cable> Cable::Create(const TautSpace& space, Point base, const CableOptions& options) {
  if (auto fault = FaultIn(options)) return tl::unexpected<Error>(*std::move(fault));
  const auto place = IsFinite(base) ? space.Locate(base) : std::nullopt;
  if (!place) return InvalidInput("the base of the cable is not in the free space", "base");
  return Cable(space, *place, options);
}

Expected<Cable> Cable::Lay(const TautSpace& space, std::span<const Point> polyline, const CableOptions& options) {
  if (polyline.empty()) return InvalidInput("a laid cable needs a point at least, its base", "cable");
  auto cable = Create(space, polyline[0], options);
  if (!cable) return cable;
  const double laid_m = Length(polyline);
  if (!(laid_m <= options.length_m * (1 + kLengthTolerance))) {
    return InvalidInput("the laid cable is longer than the cable; lay it shorter or lengthen the cable", "cable");
  }
  std::optional<Walk> walk;
  if (space.Follow(polyline, walk)) return InvalidInput("the laid cable leaves the free space", "cable");
  // From the robot, so that the first link has the length that is left over.
  const auto full_links = static_cast<std::size_t>(std::max(0.0, std::ceil(laid_m / options.link_length_m) - 1));
  double next_m = laid_m - static_cast<double>(full_links) * options.link_length_m;
  cable->first_link_m_ = next_m;
  cable->nodes_ = {Place{walk->from, walk->sleeve.front()}};
  cable->links_.clear();
  std::optional<Walk> link{Walk(cable->nodes_[0])};
  link->rooted = true;
  double passed_m = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const double piece = Distance(polyline[i - 1], polyline[i]);
    for (; next_m <= passed_m + piece && cable->links_.size() < full_links; next_m += options.link_length_m) {
      const Point node = Lerp(polyline[i - 1], polyline[i], piece > 0 ? (next_m - passed_m) / piece : 0);
      if (space.Follow(std::span<const Point>(&node, 1), link))
        return InvalidInput("the laid cable leaves the free space", "cable");
      cable->EndLinkAt(*link);
      link.emplace(cable->nodes_.back());
      link->rooted = true;
    }
    if (space.Follow(polyline.subspan(i, 1), link)) {
      return InvalidInput("the laid cable leaves the free space", "cable");
    }
    passed_m += piece;
  }
  cable->EndLinkAt(*link);
  if (options.reel == Reel::kRetracting) cable->LayTaut(cable->TautStrand(cable->ClassWalk()));
  StepResult unused;
  cable->FindContacts(unused);
  return cable;
}

void Cable::EndLinkAt(const Walk& walk) {
  links_.push_back(TautStrand(walk));
  nodes_.push_back({walk.at, walk.sleeve.back()});
}

StepResult Cable::Step(Point to, double dt_s) {
  TAUTLINE_CHECK(IsFinite(to) && dt_s >= 0);
  StepResult result;
  const auto way = WayTo(to);
  std::optional<Strand> taut;
  if (way && (options_.reel == Reel::kRetracting || MayEmptyReel(Distance(robot(), way->at)))) {
    Walk walk = IsUnused() ? Walk({robot(), way->sleeve.front()}) : ClassWalk();
    for (const TriangleId step : way->sleeve.triangles()) walk.sleeve.Step(step);
    walk.at = way->at;
    taut = TautStrand(walk);
  }
  if (!way || (taut && taut->length > options_.length_m * (1 + kLengthTolerance))) {
    result.outcome = way ? StepOutcome::kHeld : StepOutcome::kBlocked;
    result.touches_obstacle = !held_.empty();
    result.touches_robot = on_cable_;
    return result;
  }
  time_s_ += dt_s;
  Drive(*way, taut);
  FindContacts(result);
  return result;
}

void Cable::Drive(const Walk& way, const std::optional<Strand>& taut) {
  if (IsUnused()) {
    nodes_[0].triangle = way.sleeve.front();
    links_[0] = Strand(way.sleeve.front());
  }
  for (const TriangleId step : way.sleeve.triangles()) links_.back().StepSecond(step);
  nodes_.back() = {way.at, way.sleeve.back()};
  if (options_.reel == Reel::kRetracting) return LayTaut(*taut);
  const double pull_m = PullFromRobot();
  if (pull_m <= 0) return;
  const double given_m = std::min(pull_m, std::max(0.0, options_.length_m - paid_out_m()));
  PayOut(given_m);
  if (taut) Relax(pull_m - given_m, *taut);
}

std::optional<Walk> Cable::WayTo(Point to) const {
  Walk way(nodes_.back());
  way.rooted = !IsUnused();
  Walk nearly = way;
  if (!WalkStraight(space_->mesh(), to, way)) return way;
  // Rounding may have put the target, or a corner that the way grazes, on the wrong side.
  const auto place = space_->Locate(to);
  if (!place || WalkNearly(space_->mesh(), place->point, space_->tolerance(), nearly)) return std::nullopt;
  return nearly;
}

bool Cable::MayEmptyReel(double pull_m) const {
  // Each link passes on no more of a pull than it lacks slack for.
  for (std::size_t i = links_.size(); i-- > 0;) {
    pull_m += links_[i].length - RestLength(i);
    if (pull_m <= 0) return false;
  }
  return pull_m > options_.length_m - paid_out_m();
}

double Cable::paid_out_m() const {
  return first_link_m_ + static_cast<double>(links_.size() - 1) * options_.link_length_m;
}

double Cable::SlackM() const {
  double slack_m = 0;
  for (std::size_t i = 0; i < links_.size(); ++i) slack_m += std::max(0.0, RestLength(i) - links_[i].length);
  return slack_m;
}

Polyline Cable::Shape() const {
  Polyline shape{nodes_[0].point};
  for (std::size_t i = 0; i < links_.size(); ++i) {
    for (const TautPoint& bend : links_[i].bends) shape.push_back(bend.point);
    shape.push_back(nodes_[i + 1].point);
  }
  return shape;
}

Walk Cable::ClassWalk() const {
  Walk walk(nodes_[0]);
  for (const Strand& link : links_) {
    for (const TriangleId step : link.sleeve) walk.sleeve.Step(step);
  }
  walk.at = robot();
  walk.rooted = !IsUnused();
  return walk;
}

}  // namespace tautline
