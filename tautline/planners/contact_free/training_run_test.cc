#include "tautline/planners/contact_free/training_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tautline/base/test_scale.h"
#include "tautline/planners/contact_free/reference_path.h"

namespace tautline {
namespace {

/// A room of 6 m x 6 m and a robot that shall go to its other side, and looks aside.
struct SmallRoom {
  FreeSpace space = BuildFreeSpace(World{.outline = Ring{{0, 0}, {6, 0}, {6, 6}, {0, 6}}}).value();
  ContactMap map{space, 0.125};
  TetherEnv env = *TetherEnv::Create(map,
                                     {.laid = {{1.5, 3}},
                                      .heading_rad = 1.5,
                                      .cable_length_m = 8,
                                      .goal = {4, 3},
                                      .waypoints = Waypoints({{1.5, 3}, {4, 3}}, 0.5)},
                                     {.max_steps = 200});
};

TrainingOptions SmallTraining(std::int64_t steps) {
  return {.dqn = {.hidden = {32, 32}, .steps = steps, .buffer = 2000, .learning_starts = 500},
          .seed = 7,
          .evaluate_every = 1000};
}

TEST(TrainingRun, LearnsToCrossARoom) {
  const SmallRoom room;
  TrainingOptions options = SmallTraining(20'000);
  options.dqn.hidden = {64, 64};
  options.seed = 2;
  TrainingRun run(room.env, options, PortableKernels());
  const PolicyRun untrained = RunPolicy(room.env, run.best(), PortableKernels(), false);
  EXPECT_FALSE(untrained.totals.success);
  while (!run.done()) run.RunEpisode();
  const PolicyRun trained = RunPolicy(room.env, run.best(), PortableKernels(), true);
  EXPECT_TRUE(trained.totals.success);
  EXPECT_LT(trained.totals.length_m, 2.5);
  EXPECT_GE(std::count_if(run.evaluations().begin(), run.evaluations().end(),
                          [](const EpisodeRecord& evaluation) { return evaluation.totals.success; }),
            4);
  ASSERT_NE(run.best_evaluation(), nullptr);
  EXPECT_EQ(trained.totals.reward, run.best_evaluation()->totals.reward);
  EXPECT_EQ(trained.frames.size(), static_cast<std::size_t>(trained.totals.steps) + 1);
}

TEST(TrainingRun, CountsWhatItDid) {
  const SmallRoom room;
  TrainingRun run(room.env, SmallTraining(3'500), PortableKernels());
  while (!run.done()) run.RunEpisode();
  EXPECT_EQ(run.steps(), 3'500);
  EXPECT_EQ(run.gradient_steps(), 3000 / 4);
  EXPECT_EQ(run.episodes().back().step, 3'500);
  std::int64_t steps = 0;
  for (const EpisodeRecord& episode : run.episodes()) {
    steps += episode.totals.steps;
    EXPECT_EQ(episode.step, steps);
  }
  const auto& visits = run.visits();
  EXPECT_EQ(visits.columns(), 30);
  EXPECT_EQ(std::accumulate(visits.counts().begin(), visits.counts().end(), std::int64_t{0}), 3'500);
  std::vector<std::int64_t> when;
  for (const EpisodeRecord& evaluation : run.evaluations()) when.push_back(evaluation.step);
  EXPECT_THAT(when, testing::ElementsAre(1000, 2000, 3000, 3500));
  for (const EpisodeRecord& evaluation : run.evaluations()) {
    const EpisodeTotals& best = run.best_evaluation()->totals;
    EXPECT_TRUE(best.success >= evaluation.totals.success);
    EXPECT_TRUE(best.success > evaluation.totals.success || best.reward >= evaluation.totals.reward);
  }
}

TEST(TrainingRun, GoesOnToTheSameBytesFromAnyEpisode) {
  const SmallRoom room;
  const TrainingOptions options = SmallTraining(2'500);
  TrainingRun whole(room.env, options, PortableKernels());
  std::vector<std::string> kept;
  while (!whole.done()) {
    kept.push_back(whole.Save());
    whole.RunEpisode();
  }
  const std::string end = whole.Save();
  for (std::size_t i = 0; i < kept.size(); i += std::max<std::size_t>(1, kept.size() / 4)) {
    TrainingRun resumed(room.env, options, PortableKernels());
    ASSERT_TRUE(resumed.Load(kept[i], "checkpoint").has_value());
    while (!resumed.done()) resumed.RunEpisode();
    EXPECT_EQ(resumed.Save(), end) << i;
  }
}

TEST(TrainingRun, OtherSeedsTrainOtherwise) {
  const SmallRoom room;
  TrainingOptions options = SmallTraining(600);
  TrainingRun a(room.env, options, PortableKernels());
  options.seed = 8;
  TrainingRun b(room.env, options, PortableKernels());
  while (!a.done()) a.RunEpisode();
  while (!b.done()) b.RunEpisode();
  EXPECT_NE(a.Save(), b.Save());
}

TEST(TrainingRun, WhatIsNoCheckpointIsRefused) {
  const SmallRoom room;
  const TrainingOptions options = SmallTraining(600);
  TrainingRun run(room.env, options, PortableKernels());
  run.RunEpisode();
  const std::string bytes = run.Save();
  const auto refused = [&](std::string_view text) {
    TrainingRun other(room.env, options, PortableKernels());
    return !other.Load(text, "checkpoint").has_value();
  };
  EXPECT_FALSE(refused(bytes));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("no checkpoint at all"));
  EXPECT_TRUE(refused(bytes + "x"));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 50) {
    EXPECT_TRUE(refused(std::string_view(bytes).substr(0, size))) << size;
  }
  TrainingOptions wider = options;
  wider.dqn.hidden = {40};
  TrainingRun other(room.env, wider, PortableKernels());
  EXPECT_FALSE(other.Load(bytes, "checkpoint").has_value());
  // Bytes that were changed are refused or harmless.
  Rng rng(9);
  const auto trials = ScaledTestCount(200);
  for (std::int64_t i = 0; i < trials; ++i) {
    std::string changed = bytes;
    changed[static_cast<std::size_t>(rng.UniformInt(0, static_cast<int>(changed.size()) - 1))] =
        static_cast<char>(rng.Next());
    refused(changed);
  }
  // The actions that were done, a byte each, are before the visits, the records and the best network.
  std::string changed = bytes;
  const std::size_t behind = 8 + 8 * run.visits().counts().size() + 8 + 72 * run.episodes().size() + 8 +
                             72 * run.evaluations().size() + 8 + 4 * run.best().parameters().size() + 8;
  char& last_action = changed[bytes.size() - behind - 1];
  EXPECT_LT(last_action, 3);
  last_action = 3;
  EXPECT_TRUE(refused(changed));
}

}  // namespace
}  // namespace tautline
