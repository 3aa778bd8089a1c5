#include "bench/peers/boundary_loops.h"

#include <utility>

#include "tautline/homotopy/classes.h"

namespace tautline {
namespace {

std::vector<TautPath> Classes(const CableGround& ground, const Anchors& anchors, std::size_t side,
                              const ClassOptions& options) {
  return FindClasses(ground.space(), anchors[side].exit.point, anchors[NextAnchor(side, anchors.size())].exit.point,
                     options)
      .classes;
}

class Loops {
 public:
  Loops(const CableGround& ground, const Anchors& anchors, const std::vector<std::vector<TautPath>>& sides,
        double limit, Multiply multiply, std::int64_t most)
      : ground_(ground), anchors_(anchors), sides_(sides), limit_(limit), multiply_(multiply), most_(most) {}

  LoopedBoundaries Run() {
    Loop(0, Word());
    return std::move(result_);
  }

 private:
  void Loop(std::size_t side, const Word& product) {
    if (side == sides_.size()) {
      Try(product);
      return;
    }
    for (const TautPath& path : sides_[side]) {
      if (result_.gave_up) return;
      chosen_.push_back(&path);
      Loop(side + 1, multiply_ == Multiply::kPartial ? product * path.word : Word());
      chosen_.pop_back();
    }
  }

  void Try(const Word& product) {
    if (++result_.combinations > most_) {
      result_.gave_up = true;
      return;
    }
    if (multiply_ == Multiply::kPartial) {
      if (product.empty()) Close();
      return;
    }
    Word whole;
    for (const TautPath* path : chosen_) whole.Append(path->word);
    if (whole.empty()) Close();
  }

  void Close() {
    double length = 0;
    std::vector<Walk> walks;
    std::vector<TautPath> paths;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      length += chosen_[i]->length + 2 * anchors_[i].stub_length;
      walks.push_back(WalkBetween(ground_, anchors_[i], anchors_[NextAnchor(i, anchors_.size())], *chosen_[i]));
      paths.push_back(*chosen_[i]);
    }
    if (length > limit_ * (1 + kLengthTolerance)) return;
    auto boundary = CloseBoundary(ground_, anchors_, std::move(walks), std::move(paths));
    if (boundary) result_.boundaries.push_back(*std::move(boundary));
  }

  const CableGround& ground_;
  const Anchors& anchors_;
  const std::vector<std::vector<TautPath>>& sides_;
  double limit_;
  Multiply multiply_;
  std::int64_t most_;
  std::vector<const TautPath*> chosen_;
  LoopedBoundaries result_;
};

}  // namespace

std::vector<std::vector<TautPath>> ListSides(const CableGround& ground, const Anchors& anchors, double max_boundary) {
  std::vector<double> least;
  double left = max_boundary * (1 + kLengthTolerance);
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    least.push_back(Classes(ground, anchors, i, {.max_length = {}, .max_count = 1})[0].length);
    left -= least.back() + 2 * anchors[i].stub_length;
  }
  std::vector<std::vector<TautPath>> sides;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    sides.push_back(Classes(ground, anchors, i, {.max_length = least[i] + left, .max_count = {}}));
  }
  return sides;
}

LoopedBoundaries LoopOverSides(const CableGround& ground, const Anchors& anchors,
                               const std::vector<std::vector<TautPath>>& sides, double max_boundary, Multiply multiply,
                               std::int64_t max_combinations) {
  return Loops(ground, anchors, sides, max_boundary, multiply, max_combinations).Run();
}

}  // namespace tautline
