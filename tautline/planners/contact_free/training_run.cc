#include "tautline/planners/contact_free/training_run.h"

#include <algorithm>

#include "tautline/base/check.h"

namespace tautline {
namespace {

/// Changes with the meaning of the bytes.
constexpr std::string_view kHeader = "tautline training 1\n";
/// Of a record.
constexpr std::size_t kRecordBytes = 72;
/// The starts and the learner draw from sequences of their own.
constexpr std::uint64_t kStartsSalt = 0x5ca1ab1e0ddba115U;

bool IsBetter(const EpisodeTotals& a, const EpisodeTotals& b) {
  return a.success != b.success ? a.success : a.reward > b.reward;
}

void Save(const std::vector<EpisodeRecord>& records, StateWriter& writer) {
  writer.Whole(static_cast<std::int64_t>(records.size()));
  for (const EpisodeRecord& record : records) {
    writer.Whole(record.step);
    writer.Real(record.totals.reward);
    writer.Whole(record.totals.success ? 1 : 0);
    writer.Whole(record.totals.hit ? 1 : 0);
    writer.Whole(record.totals.steps);
    writer.Whole(record.totals.cable_robot);
    writer.Whole(record.totals.cable_obstacle);
    writer.Real(record.totals.length_m);
    writer.Real(record.loss);
  }
}

std::vector<EpisodeRecord> LoadRecords(StateReader& reader) {
  std::vector<EpisodeRecord> records(reader.Count(kRecordBytes));
  for (EpisodeRecord& record : records) {
    record.step = reader.Whole();
    record.totals.reward = reader.Real();
    record.totals.success = reader.Whole() != 0;
    record.totals.hit = reader.Whole() != 0;
    record.totals.steps = static_cast<int>(reader.Whole());
    record.totals.cable_robot = static_cast<int>(reader.Whole());
    record.totals.cable_obstacle = static_cast<int>(reader.Whole());
    record.totals.length_m = reader.Real();
    record.loss = reader.Real();
  }
  return records;
}

}  // namespace

TrainingRun::TrainingRun(const TetherEnv& env, const TrainingOptions& options, const Kernels& kernels)
    : options_(options),
      kernels_(&kernels),
      env_(env),
      rng_(options.seed ^ kStartsSalt),
      learner_({.inputs = static_cast<int>(Observation().size()), .actions = kTetherActions}, options.dqn, options.seed,
               kernels),
      visits_(env.map().box(), options.visit_cell_m),
      best_(learner_.network()) {
  TAUTLINE_CHECK(options.evaluate_every > 0);
}

const EpisodeRecord* TrainingRun::best_evaluation() const {
  return evaluations_.empty() ? nullptr : &evaluations_[best_index_];
}

void TrainingRun::RunEpisode() {
  TAUTLINE_CHECK(!done());
  EpisodeTotals totals;
  Observation before = env_.Reset(rng_.Next());
  for (bool ended = false; !ended && !done();) {
    const int action = learner_.Explore(before);
    const Point from = env_.pose().at;
    const EnvStep step = env_.Step(static_cast<TetherAction>(action));
    const Observation after = env_.Observe();
    learner_.Learn({.before = before,
                    .action = action,
                    .reward = step.reward,
                    .after = after,
                    .terminal = step.robot_obstacle || step.at_goal});
    totals.Add(step, Distance(from, env_.pose().at));
    visits_.Add(env_.pose().at);
    before = after;
    ended = step.ends();
    if (steps() % options_.evaluate_every == 0 || done()) Evaluate();
  }
  episodes_.push_back({.step = steps(), .totals = totals, .loss = learner_.TakeLoss()});
}

void TrainingRun::Evaluate() {
  const PolicyRun run = RunPolicy(env_, learner_.network(), *kernels_, false);
  const bool better = evaluations_.empty() || IsBetter(run.totals, evaluations_[best_index_].totals);
  evaluations_.push_back({.step = steps(), .totals = run.totals});
  if (!better) return;
  best_ = learner_.network();
  best_index_ = evaluations_.size() - 1;
}

std::string TrainingRun::Save() const {
  StateWriter writer;
  writer.Text(kHeader);
  writer.Text(kernels_->name);
  writer.Whole(static_cast<std::int64_t>(rng_.state()));
  learner_.Save(writer);
  writer.Whole(static_cast<std::int64_t>(visits_.counts().size()));
  for (const std::int64_t count : visits_.counts()) writer.Whole(count);
  tautline::Save(episodes_, writer);
  tautline::Save(evaluations_, writer);
  writer.Floats(best_.parameters());
  writer.Whole(static_cast<std::int64_t>(best_index_));
  return writer.Take();
}

bool TrainingRun::LoadFields(StateReader& reader) {
  rng_ = Rng(static_cast<std::uint64_t>(reader.Whole()));
  if (!learner_.Load(reader)) return false;
  std::vector<std::int64_t> visits(reader.Count(8));
  for (std::int64_t& count : visits) count = reader.Whole();
  if (visits.size() != visits_.counts().size()) return false;
  visits_.set_counts(std::move(visits));
  episodes_ = LoadRecords(reader);
  evaluations_ = LoadRecords(reader);
  const auto best = reader.Floats();
  if (best.size() != best_.parameters().size()) return false;
  std::copy(best.begin(), best.end(), best_.parameters().begin());
  best_index_ = static_cast<std::size_t>(reader.Whole());
  return reader.whole() && reader.at_end() && best_index_ < std::max<std::size_t>(1, evaluations_.size());
}

Expected<void> TrainingRun::Load(std::string_view bytes, const std::string& name) {
  StateReader reader(bytes);
  if (reader.Text() != kHeader) {
    return InvalidInput("is no checkpoint of this version of tautline: remove it to train anew", name);
  }
  if (const std::string_view kernels = reader.Text(); kernels != kernels_->name) {
    return InvalidInput("was written with --kernels " + std::string(kernels) + ", and this run has " + kernels_->name +
                            ": they round differently; give those",
                        name);
  }
  if (!LoadFields(reader)) {
    return InvalidInput("does not fit this run, or is not whole: remove it to train anew", name);
  }
  return {};
}

}  // namespace tautline
