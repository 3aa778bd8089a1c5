// One training from its first step to its last, episode by episode, which can be kept and gone on with.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_TRAINING_RUN_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_TRAINING_RUN_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tautline/planners/contact_free/dqn.h"
#include "tautline/planners/contact_free/policy_run.h"
#include "tautline/planners/contact_free/tether_env.h"
#include "tautline/planners/contact_free/visit_map.h"

namespace tautline {

/// How to train.
struct TrainingOptions {
  DqnOptions dqn;                        ///< The learner.
  std::uint64_t seed = 1;                ///< Of everything random.
  std::int64_t evaluate_every = 10'000;  ///< Steps between greedy episodes. Positive.
  double visit_cell_m = 0.2;             ///< Of the map of visits. Positive.
};

/// What an episode or a greedy episode came to, and when.
struct EpisodeRecord {
  std::int64_t step = 0;  ///< Of the training, when it ended.
  EpisodeTotals totals;   ///< Of the episode.
  double loss = 0;        ///< The mean of its gradient steps; 0 for greedy episodes.
};

/// A training. Its policy is the best one that a greedy episode has shown: the goal reached first, then the larger
/// return, then the earlier one. The same environment, options and kernels give the same bytes. [Shimada2024, Sec. 4.3]
class TrainingRun {
 public:
  /// At step 0. Keeps a reference to the kernels. Requires options that CheckDqnOptions accepts.
  TrainingRun(const TetherEnv& env, const TrainingOptions& options, const Kernels& kernels);

  /// Whether all steps are made.
  bool done() const { return learner_.steps() >= options_.dqn.steps; }

  /// One episode to its end or that of the training. Requires a training that is not done. At most as long as the
  /// environment lets an episode be.
  void RunEpisode();

  /// Steps made.
  std::int64_t steps() const { return learner_.steps(); }
  /// Gradient steps made.
  std::int64_t gradient_steps() const { return learner_.gradient_steps(); }
  /// All episodes, the last one unfinished where the training ended in it.
  const std::vector<EpisodeRecord>& episodes() const { return episodes_; }
  /// All greedy ones, after each `evaluate_every` steps and in the end.
  const std::vector<EpisodeRecord>& evaluations() const { return evaluations_; }
  /// Where the robot was.
  const VisitMap& visits() const { return visits_; }
  /// The best policy. Without any evaluation, the network as it is.
  const Mlp& best() const { return best_; }
  /// The evaluation that showed the best policy; none before the first.
  const EpisodeRecord* best_evaluation() const;
  /// How it trains.
  const TrainingOptions& options() const { return options_; }

  /// All that is needed to go on. Requires that no episode is running, as between calls.
  std::string Save() const;
  /// Goes on from what was saved with the same environment, options and kernels, to the same bytes. InvalidInput where
  /// the bytes are not that; the run is of no use then.
  [[nodiscard]] Expected<void> Load(std::string_view bytes, const std::string& name);

 private:
  void Evaluate();
  bool LoadFields(StateReader& reader);

  TrainingOptions options_;
  const Kernels* kernels_;
  TetherEnv env_;
  Rng rng_;  ///< Of the starts.
  Dqn learner_;
  VisitMap visits_;
  std::vector<EpisodeRecord> episodes_;
  std::vector<EpisodeRecord> evaluations_;
  Mlp best_;
  std::size_t best_index_ = 0;  ///< Of its evaluation.
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_TRAINING_RUN_H_
