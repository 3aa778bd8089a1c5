#include "tautline/planners/contact_free/dqn.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "tautline/base/check.h"
#include "tautline/network/loss.h"

namespace tautline {
namespace {

/// Layers wider than this are a slip of the pen.
constexpr int kMostUnits = 4096;
constexpr int kMostBuffered = 10'000'000;

std::vector<int> WidthsOf(const DqnTask& task, const DqnOptions& options) {
  std::vector<int> widths{task.inputs};
  widths.insert(widths.end(), options.hidden.begin(), options.hidden.end());
  widths.push_back(task.actions);
  return widths;
}

bool IsShare(double value) { return value >= 0 && value <= 1; }

std::ptrdiff_t ArgMax(std::span<const float> values) {
  return std::max_element(values.begin(), values.end()) - values.begin();
}

}  // namespace

Expected<void> CheckDqnOptions(const DqnOptions& options) {
  if (options.hidden.size() > 8) return InvalidInput("at most 8 hidden layers", "--hidden");
  for (const int width : options.hidden) {
    if (width < 1 || width > kMostUnits) return InvalidInput("1 to 4096 units a layer", "--hidden");
  }
  const struct {
    const char* name;
    std::int64_t value;
    std::int64_t least;
    std::int64_t most;
  } wholes[] = {{"--steps", options.steps, 1, std::int64_t{1} << 40},
                {"--buffer", options.buffer, 1, kMostBuffered},
                {"--batch", options.batch, 1, 65'536},
                {"--target-interval", options.target_interval, 1, 1 << 30},
                {"--learning-starts", options.learning_starts, 0, 1 << 30},
                {"--train-frequency", options.train_frequency, 1, 1 << 30},
                {"--gradient-steps", options.gradient_steps, 0, 1000}};
  for (const auto& whole : wholes) {
    if (whole.value >= whole.least && whole.value <= whole.most) continue;
    return InvalidInput("must be from " + std::to_string(whole.least) + " to " + std::to_string(whole.most),
                        whole.name);
  }
  if (!(options.learning_rate > 0) || !std::isfinite(options.learning_rate)) {
    return InvalidInput("must be positive", "--learning-rate");
  }
  if (!(options.max_gradient_norm > 0)) return InvalidInput("must be positive", "--max-gradient-norm");
  if (!IsShare(options.discount)) return InvalidInput("must be from 0 to 1", "--discount");
  if (!IsShare(options.exploration_fraction)) return InvalidInput("must be from 0 to 1", "--exploration-fraction");
  if (!IsShare(options.exploration_initial)) return InvalidInput("must be from 0 to 1", "--exploration-initial");
  if (!IsShare(options.exploration_final)) return InvalidInput("must be from 0 to 1", "--exploration-final");
  return {};
}

Dqn::Dqn(const DqnTask& task, const DqnOptions& options, std::uint64_t seed, const Kernels& kernels)
    : options_(options),
      kernels_(&kernels),
      rng_(seed),
      network_(Mlp::Random(WidthsOf(task, options), rng_)),
      target_(network_),
      adam_(network_.parameters().size(), {.learning_rate = options.learning_rate}, kernels),
      buffer_(static_cast<std::size_t>(options.buffer), static_cast<std::size_t>(task.inputs)),
      pass_(network_.widths(), options.batch, kernels),
      acting_(network_.widths(), 1, kernels),
      targets_(static_cast<std::size_t>(options.batch)),
      slopes_(static_cast<std::size_t>(options.batch) * static_cast<std::size_t>(task.actions)) {
  TAUTLINE_CHECK(task.inputs > 0 && task.actions > 0 && CheckDqnOptions(options).has_value());
}

double Dqn::exploration() const {
  const double end = options_.exploration_fraction * static_cast<double>(options_.steps);
  const double share = end > 0 ? std::min(1.0, static_cast<double>(steps_) / end) : 1;
  return options_.exploration_initial + share * (options_.exploration_final - options_.exploration_initial);
}

int Dqn::Explore(std::span<const float> observation) {
  const bool random = rng_.Uniform() < exploration() || steps_ < options_.learning_starts;
  return random ? rng_.UniformInt(0, network_.outputs() - 1) : Greedy(observation);
}

int Dqn::Greedy(std::span<const float> observation) {
  return static_cast<int>(ArgMax(acting_.Forward(network_, observation)));
}

void Dqn::Learn(const Transition& transition) {
  buffer_.Add(transition);
  ++steps_;
  if (steps_ % options_.target_interval == 0) target_ = network_;
  if (steps_ <= options_.learning_starts || steps_ % options_.train_frequency != 0) return;
  for (int i = 0; i < options_.gradient_steps; ++i) GradientStep();
}

void Dqn::GradientStep() {
  buffer_.Sample(options_.batch, rng_, batch_);
  const auto actions = static_cast<std::size_t>(network_.outputs());
  const auto next = pass_.Forward(target_, batch_.after);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const auto values = next.subspan(i * actions, actions);
    const float best = *std::max_element(values.begin(), values.end());
    targets_[i] = batch_.rewards[i] + batch_.goes_on[i] * static_cast<float>(options_.discount) * best;
  }
  const auto values = pass_.Forward(network_, batch_.before);
  loss_sum_ += HuberLoss(values, {.chosen = batch_.actions, .targets = targets_}, slopes_);
  ++loss_count_;
  const auto gradient = pass_.Backward(network_, slopes_);
  const double squares = kernels_->square_sum(gradient.data(), gradient.size());
  adam_.Step(network_.parameters(), gradient, ClipScale(squares, options_.max_gradient_norm));
}

double Dqn::TakeLoss() {
  const double mean = loss_count_ == 0 ? 0 : loss_sum_ / static_cast<double>(loss_count_);
  loss_sum_ = 0;
  loss_count_ = 0;
  return mean;
}

void Dqn::Save(StateWriter& writer) const {
  writer.Whole(static_cast<std::int64_t>(rng_.state()));
  writer.Whole(steps_);
  writer.Real(loss_sum_);
  writer.Whole(loss_count_);
  writer.Floats(network_.parameters());
  writer.Floats(target_.parameters());
  writer.Whole(adam_.state().steps);
  writer.Floats(adam_.state().mean);
  writer.Floats(adam_.state().square);
  buffer_.Save(writer);
}

bool Dqn::Load(StateReader& reader) {
  rng_ = Rng(static_cast<std::uint64_t>(reader.Whole()));
  steps_ = reader.Whole();
  loss_sum_ = reader.Real();
  loss_count_ = reader.Whole();
  for (Mlp* network : {&network_, &target_}) {
    const auto parameters = reader.Floats();
    if (parameters.size() != network->parameters().size()) return false;
    std::copy(parameters.begin(), parameters.end(), network->parameters().begin());
  }
  AdamState adam;
  adam.steps = reader.Whole();
  adam.mean = reader.Floats();
  adam.square = reader.Floats();
  const std::size_t count = network_.parameters().size();
  if (adam.mean.size() != count || adam.square.size() != count || adam.steps < 0) return false;
  adam_.set_state(std::move(adam));
  if (!buffer_.Load(reader, network_.outputs()) || steps_ < 0) return false;
  return static_cast<std::int64_t>(buffer_.size()) == std::min<std::int64_t>(steps_, options_.buffer);
}

}  // namespace tautline
