// A deep Q-network: learns what each action is worth from what it has seen.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_DQN_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_DQN_H_

#include <cstdint>
#include <span>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/base/rng.h"
#include "tautline/network/adam.h"
#include "tautline/network/mlp.h"
#include "tautline/planners/contact_free/replay_buffer.h"

namespace tautline {

/// How it learns. The defaults are those of [Shimada2024, Table 1], and where that is silent, of the library that was
/// used there.
struct DqnOptions {
  std::vector<int> hidden = {256, 256};  ///< Widths of the hidden layers.
  std::int64_t steps = 300'000;          ///< Of the environment, in all; exploration is planned over them.
  double learning_rate = 1e-3;           ///< Of Adam.
  double discount = 0.9;                 ///< Of the next step's worth, 0 to 1.
  int buffer = 10'000;                   ///< Transitions that are remembered.
  int batch = 32;                        ///< Transitions in a gradient step.
  int target_interval = 30;              ///< Steps of the environment after which the target network is renewed.
  int learning_starts = 5'000;           ///< Steps at random before the first gradient step.
  int train_frequency = 4;               ///< Steps of the environment between those of the gradient.
  int gradient_steps = 1;                ///< So many then.
  double exploration_fraction = 0.6;     ///< Share of all steps over which exploration falls, 0 to 1.
  double exploration_initial = 0.9;      ///< Share of random actions at first.
  double exploration_final = 0.05;       ///< And in the end.
  double max_gradient_norm = 10;         ///< Longer gradients are made this long.
};

/// InvalidInput where a number makes no sense, with the name of the field's option as where.
[[nodiscard]] Expected<void> CheckDqnOptions(const DqnOptions& options);

/// What it learns on: observations of so many numbers, so many actions.
struct DqnTask {
  int inputs = 0;   ///< Numbers of an observation.
  int actions = 0;  ///< To choose among.
};

/// The learner. Everything random comes from its seed: the same seed, kernels and transitions give the same bytes.
/// [Mnih2015] [Shimada2024, Sec. 6.1]
class Dqn {
 public:
  /// Draws the network. Keeps a reference to the kernels. Requires options that CheckDqnOptions accepts.
  Dqn(const DqnTask& task, const DqnOptions& options, std::uint64_t seed, const Kernels& kernels);

  /// An action to learn from: at random in the beginning and now and then, else the greedy one. O(weights).
  int Explore(std::span<const float> observation);

  /// The action that seems to be worth most; the first of equal ones. O(weights).
  int Greedy(std::span<const float> observation);

  /// Remembers a step, and learns when it is time to. O(batch * weights) then.
  void Learn(const Transition& transition);

  /// Steps that it learned from, or only remembered.
  std::int64_t steps() const { return steps_; }
  /// Gradient steps.
  std::int64_t gradient_steps() const { return adam_.state().steps; }
  /// The share of random actions now.
  double exploration() const;
  /// The mean loss of the gradient steps since the last call; 0 where there were none.
  double TakeLoss();
  /// What it has learned.
  const Mlp& network() const { return network_; }
  /// What it was made with.
  const DqnOptions& options() const { return options_; }

  /// Writes all of its state.
  void Save(StateWriter& writer) const;
  /// Goes on from what was saved with the same task and options; false where it does not fit, and the learner is of no
  /// use then.
  bool Load(StateReader& reader);

 private:
  void GradientStep();

  DqnOptions options_;
  const Kernels* kernels_;
  Rng rng_;
  Mlp network_;
  Mlp target_;
  Adam adam_;
  ReplayBuffer buffer_;
  std::int64_t steps_ = 0;
  double loss_sum_ = 0;
  std::int64_t loss_count_ = 0;
  MlpPass pass_;  ///< The rest is scratch.
  MlpPass acting_;
  TransitionBatch batch_;
  std::vector<float> targets_;
  std::vector<float> slopes_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_DQN_H_
