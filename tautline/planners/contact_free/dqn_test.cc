#include "tautline/planners/contact_free/dqn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tautline/base/test_scale.h"

namespace tautline {
namespace {

TEST(ReplayBuffer, HoldsTheLastOnes) {
  ReplayBuffer buffer(3, 1);
  for (int i = 0; i < 5; ++i) {
    const float before[] = {static_cast<float>(i)}, after[] = {static_cast<float>(i + 1)};
    buffer.Add({.before = before, .action = i, .reward = 10.0 * i, .after = after, .terminal = i == 4});
  }
  EXPECT_EQ(buffer.size(), 3U);
  Rng rng(1);
  TransitionBatch batch;
  buffer.Sample(200, rng, batch);
  std::set<int> seen;
  for (std::size_t i = 0; i < 200; ++i) {
    const int action = batch.actions[i];
    seen.insert(action);
    EXPECT_EQ(batch.before[i], static_cast<float>(action));
    EXPECT_EQ(batch.after[i], static_cast<float>(action + 1));
    EXPECT_EQ(batch.rewards[i], 10.0F * static_cast<float>(action));
    EXPECT_EQ(batch.goes_on[i], action == 4 ? 0 : 1);
  }
  EXPECT_THAT(seen, testing::ElementsAre(2, 3, 4));
}

TEST(Dqn, OptionsThatMakeNoSenseAreRefusedByName) {
  EXPECT_TRUE(CheckDqnOptions({}).has_value());
  const auto where = [](const DqnOptions& options) {
    const auto checked = CheckDqnOptions(options);
    return checked ? std::string() : checked.error().where;
  };
  EXPECT_EQ(where({.hidden = {0}}), "--hidden");
  EXPECT_EQ(where({.steps = 0}), "--steps");
  EXPECT_EQ(where({.learning_rate = 0}), "--learning-rate");
  EXPECT_EQ(where({.discount = 1.1}), "--discount");
  EXPECT_EQ(where({.buffer = 0}), "--buffer");
  EXPECT_EQ(where({.exploration_final = -1}), "--exploration-final");
}

TEST(Dqn, ExplorationFallsToItsEnd) {
  Dqn learner({.inputs = 1, .actions = 2}, {.hidden = {2}, .steps = 100, .learning_starts = 100}, 1, PortableKernels());
  const float at[] = {0};
  EXPECT_DOUBLE_EQ(learner.exploration(), 0.9);
  for (int i = 0; i < 30; ++i) learner.Learn({.before = at, .after = at});
  EXPECT_DOUBLE_EQ(learner.exploration(), 0.9 - 0.85 / 2);
  for (int i = 0; i < 70; ++i) learner.Learn({.before = at, .after = at});
  EXPECT_NEAR(learner.exploration(), 0.05, 1e-12);
  EXPECT_EQ(learner.gradient_steps(), 0);
}

/// A corridor of five places; moving right from the last one pays 1 and ends.
class Corridor {
 public:
  explicit Corridor(Dqn& learner) : learner_(&learner) {}

  void Step() {
    const float before[] = {Seen(at_)};
    const int action = learner_->Explore(before);
    const bool out = action == 1 && at_ == 4;
    const int next = action == 1 ? std::min(at_ + 1, 4) : std::max(at_ - 1, 0);
    const float after[] = {Seen(next)};
    learner_->Learn({.before = before, .action = action, .reward = out ? 1.0 : 0, .after = after, .terminal = out});
    at_ = out ? 0 : next;
  }
  static float Seen(int at) { return static_cast<float>(at) / 2 - 1; }

 private:
  Dqn* learner_;
  int at_ = 0;
};

TEST(Dqn, FindsWhatPlacesAreWorth) {
  const DqnOptions options{
      .hidden = {32, 32}, .steps = 6000, .learning_rate = 3e-3, .buffer = 2000, .learning_starts = 500};
  Dqn learner({.inputs = 1, .actions = 2}, options, 3, PortableKernels());
  Corridor corridor(learner);
  while (learner.steps() < options.steps) corridor.Step();
  EXPECT_EQ(learner.gradient_steps(), (6000 - 500) / 4);
  MlpPass pass(learner.network().widths(), 1, PortableKernels());
  double worth = 1;
  for (int at = 4; at >= 0; --at, worth *= 0.9) {
    const float seen[] = {Corridor::Seen(at)};
    EXPECT_EQ(learner.Greedy(seen), 1) << at;
    EXPECT_NEAR(pass.Forward(learner.network(), seen)[1], worth, 0.05) << at;
  }
}

TEST(Dqn, TheTargetsLookBeyondACutAndNotBeyondTheEnd) {
  // Every step pays 1 and leads to where it was. Where it may end, that is all; where it goes on, 1 / (1 - 0.9).
  for (const bool terminal : {true, false}) {
    const DqnOptions options{.hidden = {16}, .steps = 8000, .learning_rate = 3e-3, .learning_starts = 100};
    Dqn learner({.inputs = 1, .actions = 1}, options, 4, PortableKernels());
    const float at[] = {0.5F};
    while (learner.steps() < options.steps)
      learner.Learn({.before = at, .reward = 1, .after = at, .terminal = terminal});
    MlpPass pass(learner.network().widths(), 1, PortableKernels());
    EXPECT_NEAR(pass.Forward(learner.network(), at)[0], terminal ? 1 : 10, 0.2);
  }
}

TEST(Dqn, GoesOnToTheSameBytes) {
  const DqnOptions options{.hidden = {16, 16}, .steps = 1000, .buffer = 200, .learning_starts = 50};
  const DqnTask task{.inputs = 1, .actions = 2};
  Dqn whole(task, options, 5, PortableKernels());
  Corridor first(whole);
  for (int i = 0; i < 333; ++i) first.Step();
  StateWriter half;
  whole.Save(half);
  const std::string bytes = half.Take();
  Dqn resumed(task, options, 99, PortableKernels());
  StateReader reader(bytes);
  ASSERT_TRUE(resumed.Load(reader));
  const float at[] = {0.25F};
  for (int i = 0; i < 500; ++i) {
    EXPECT_EQ(whole.Explore(at), resumed.Explore(at));
    for (Dqn* learner : {&whole, &resumed})
      learner->Learn({.before = at, .action = i % 2, .reward = 0.1 * i, .after = at});
  }
  StateWriter a, b;
  whole.Save(a);
  resumed.Save(b);
  EXPECT_EQ(a.Take(), b.Take());
}

}  // namespace
}  // namespace tautline
