#include "tautline/planners/cable_workspace/place_job.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "tautline/base/rng.h"

namespace tautline {
namespace {

/// The step at which a search has converged, as a share of the outline: far below what a winch can be mounted to, far
/// above the rounding of coordinates.
constexpr double kFinestStep = 1e-7;

/// The least gain that counts, as a share of the value: less is rounding, and following it would spend the budget on
/// moves that change nothing.
constexpr double kLeastGain = 1e-12;

/// Seeds that follow each other would give parts of one sequence; hashed ones do not.
Rng RngOf(std::uint64_t seed, std::size_t job) { return Rng(Rng(Rng(seed).Next() ^ job).Next()); }

template <class T>
void Shuffle(std::vector<T>& values, Rng& rng) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(i) - 1))]);
  }
}

std::vector<double> DrawStart(const PlacementGround& ground, std::size_t job, Rng& rng) {
  const OutlineWalk& outline = ground.outline();
  const std::size_t n = ground.options().anchors;
  std::vector<double> positions;
  if (job == 0) {
    for (std::size_t i = 0; i < n; ++i) {
      positions.push_back(outline.length() * static_cast<double>(i) / static_cast<double>(n));
    }
    return positions;
  }
  if (job % 2 == 1) {
    std::vector<double> corners(outline.corners().begin(), outline.corners().end());
    Shuffle(corners, rng);
    const int most = static_cast<int>(std::min(n, corners.size()));
    corners.resize(static_cast<std::size_t>(job == 1 ? most : rng.UniformInt(1, most)));
    positions = std::move(corners);
  }
  while (positions.size() < n) positions.push_back(rng.Uniform(0, outline.length()));
  std::sort(positions.begin(), positions.end());
  return positions;
}

/// One pattern search.
class PatternSearch {
 public:
  PatternSearch(const PlacementGround& ground, const PlaceJobOptions& options, std::size_t job)
      : ground_(ground), options_(options), rng_(RngOf(options.seed, job)), tasks_(ground.options().tasks) {
    found_.job = job;
    found_.start = DrawStart(ground, job, rng_);
    for (const Corner& corner : ground.ground().space().corners().all()) bends_.push_back(corner.point);
  }

  /// False when it was stopped.
  bool Run() {
    here_ = found_.start;
    Try(here_);
    const double length = ground_.outline().length();
    double step = length / static_cast<double>(2 * ground_.options().anchors);
    // Moves that do not depend on the step are tried once at each placement.
    bool first = true;
    while (GoesOn() && step > kFinestStep * length) {
      first = Poll(step, first);
      if (!first) step /= 2;
    }
    return !stopped_;
  }

  PlaceJob TakeResult() { return std::move(found_); }

 private:
  bool GoesOn() const { return !stopped_ && found_.evaluations < options_.evaluations; }

  /// Whether any move of this size was better, or, the first time at a placement, any to a corner or about a pivot.
  bool Poll(double step, bool first) {
    bool gained = false;
    std::vector<std::size_t> order(here_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Shuffle(order, rng_);
    for (const std::size_t i : order) gained = MoveOne(i, step) || gained;
    if (gained) return true;
    if (first) {
      for (const std::size_t i : order) gained = MoveToCorner(i) || gained;
      for (const std::size_t i : order) gained = Pivot(i, 0) || gained;
    }
    for (const std::size_t i : order) gained = Pivot(i, step) || Pivot(i, -step) || gained;
    return MoveAll(step) || gained;
  }

  bool MoveOne(std::size_t i, double step) {
    const double signed_step = rng_.Next() % 2 == 0 ? step : -step;
    return TryAt(i, here_[i] + signed_step) || TryAt(i, here_[i] - signed_step);
  }

  bool MoveToCorner(std::size_t i) {
    const OutlineWalk& outline = ground_.outline();
    return TryAt(i, outline.NextCorner(here_[i])) || TryAt(i, outline.PreviousCorner(here_[i]));
  }

  /// Moves an anchor, and with it a neighbour, so that the line between the two turns about what lies nearest to it: a
  /// task that it must not leave outside, or a corner that the cable touches. No move of one anchor alone can do so.
  bool Pivot(std::size_t i, double step) {
    const std::size_t n = here_.size();
    const OutlineWalk& outline = ground_.outline();
    for (const std::size_t k : {NextAnchor(i, n), (i + n - 1) % n}) {
      const Point from = outline.At(here_[i]), to = outline.At(here_[k]);
      for (const std::vector<Point>* pivots : {&tasks_, &bends_}) {
        if (pivots->empty()) continue;
        const Point pivot = *std::min_element(pivots->begin(), pivots->end(), [&](Point a, Point b) {
          return DistanceToSegment(a, from, to) < DistanceToSegment(b, from, to);
        });
        std::vector<double> positions = here_;
        positions[i] = outline.Wrapped(here_[i] + step);
        const auto turned = outline.Beyond(outline.At(positions[i]), pivot);
        if (!turned) continue;
        positions[k] = *turned;
        if (Try(std::move(positions))) return true;
      }
    }
    return false;
  }

  bool MoveAll(double step) {
    std::vector<double> ahead = here_, back = here_;
    for (std::size_t i = 0; i < here_.size(); ++i) {
      const double move = rng_.Uniform(-step, step);
      ahead[i] += move;
      back[i] -= move;
    }
    return Try(std::move(ahead)) || Try(std::move(back));
  }

  bool TryAt(std::size_t i, double position) {
    std::vector<double> positions = here_;
    positions[i] = position;
    return Try(std::move(positions));
  }

  /// Goes there if it is better.
  bool Try(std::vector<double> positions) {
    if (!GoesOn()) return false;
    if (options_.keep_going && !options_.keep_going()) {
      stopped_ = true;
      return false;
    }
    std::optional<PlacementWorth> to_beat;
    if (!found_.gains.empty()) to_beat = found_.gains.back().worth;
    const PlacementAnswer answer = ground_.Evaluate(std::move(positions), to_beat);
    ++found_.evaluations;
    if (!answer.complete) ++found_.incomplete;
    if (!answer.placement || !Gains(answer.placement->worth)) return false;
    here_ = answer.placement->positions;
    found_.positions = here_;
    found_.gains.push_back({found_.evaluations, answer.placement->worth});
    return true;
  }

  bool Gains(const PlacementWorth& worth) const {
    if (found_.gains.empty()) return true;
    const PlacementWorth& best = found_.gains.back().worth;
    if (!ground_.IsBetter(worth, best)) return false;
    if (worth.holds_all() != best.holds_all()) return true;
    const double before = best.holds_all() ? best.value : best.outside;
    const double after = best.holds_all() ? worth.value : worth.outside;
    return std::fabs(after - before) > kLeastGain * before;
  }

  const PlacementGround& ground_;
  const PlaceJobOptions& options_;
  Rng rng_;
  PlaceJob found_;
  std::vector<Point> tasks_;
  std::vector<Point> bends_;  ///< Where cables can bend.
  std::vector<double> here_;  ///< The best so far; the start while nothing is valid.
  bool stopped_ = false;
};

}  // namespace

std::vector<double> PlaceStart(const PlacementGround& ground, std::uint64_t seed, std::size_t job) {
  Rng rng = RngOf(seed, job);
  return DrawStart(ground, job, rng);
}

std::optional<PlaceJob> RunPlaceJob(const PlacementGround& ground, const PlaceJobOptions& options, std::size_t job) {
  PatternSearch search(ground, options, job);
  if (!search.Run()) return std::nullopt;
  return search.TakeResult();
}

}  // namespace tautline
