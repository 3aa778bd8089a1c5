// What a learner has seen lately, to learn from again.
#ifndef TAUTLINE_PLANNERS_CONTACT_FREE_REPLAY_BUFFER_H_
#define TAUTLINE_PLANNERS_CONTACT_FREE_REPLAY_BUFFER_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/network/state_bytes.h"

namespace tautline {

/// One step of an environment, as a learner sees it.
struct Transition {
  std::span<const float> before;  ///< The observation that was acted on.
  int action = 0;                 ///< What was done.
  double reward = 0;              ///< What it was worth.
  std::span<const float> after;   ///< The observation that followed.
  bool terminal = false;          ///< Nothing can follow; false where the episode was merely cut.
};

/// A number of transitions side by side, one row of each field for one transition.
struct TransitionBatch {
  std::vector<float> before;   ///< What was observed.
  std::vector<int> actions;    ///< What was done.
  std::vector<float> rewards;  ///< What it was worth.
  std::vector<float> after;    ///< What was observed then.
  std::vector<float> goes_on;  ///< 0 where the transition is terminal, else 1.
};

/// The last transitions, a fixed number at most; a new one takes the place of the oldest. [Mnih2015]
class ReplayBuffer {
 public:
  /// For observations of so many numbers. Requires both positive.
  ReplayBuffer(std::size_t capacity, std::size_t inputs);

  /// Keeps a copy.
  void Add(const Transition& transition);

  /// Draws so many, uniformly and with repetition. Requires one in the buffer.
  void Sample(int count, Rng& rng, TransitionBatch& batch) const;

  /// How many there are.
  std::size_t size() const { return size_; }

  /// Writes all of it.
  void Save(StateWriter& writer) const;
  /// Goes on from what was saved; false where it does not fit, or has an action that is none of `actions`, and the
  /// buffer is of no use then.
  bool Load(StateReader& reader, int actions);

 private:
  std::size_t capacity_, inputs_;
  std::size_t size_ = 0;
  std::size_t next_ = 0;  ///< Where the next one goes.
  std::vector<float> before_, after_, rewards_, goes_on_;
  std::vector<std::uint8_t> actions_;
};

}  // namespace tautline

#endif  // TAUTLINE_PLANNERS_CONTACT_FREE_REPLAY_BUFFER_H_
