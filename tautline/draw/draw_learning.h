// Learning curves: what episodes were worth over the steps of a training, with the spread of several seeds.
#ifndef TAUTLINE_DRAW_DRAW_LEARNING_H_
#define TAUTLINE_DRAW_DRAW_LEARNING_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/planners/contact_free/training_run.h"

namespace tautline {

/// One training.
struct LearningCurve {
  std::vector<EpisodeRecord> episodes;     ///< In order.
  std::vector<EpisodeRecord> evaluations;  ///< Greedy ones, in order.
};

/// The picture, as SVG: the returns of episodes, averaged over stretches of the training, and of greedy ones; the mean
/// of the seeds as a line, from the worst to the best one as a band. Requires a curve. Deterministic. O(records).
std::string DrawLearning(std::span<const LearningCurve> curves);

}  // namespace tautline

#endif  // TAUTLINE_DRAW_DRAW_LEARNING_H_
