#include "tautline/network/mlp.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/base/check.h"

namespace tautline {

Mlp::Mlp(std::vector<int> widths) : widths_(std::move(widths)) {
  TAUTLINE_CHECK(widths_.size() >= 2);
  for (const int width : widths_) TAUTLINE_CHECK(width > 0);
  offsets_.push_back(0);
  for (std::size_t i = 1; i < widths_.size(); ++i) {
    const auto inputs = static_cast<std::size_t>(widths_[i - 1]);
    offsets_.push_back(offsets_.back() + (inputs + 1) * static_cast<std::size_t>(widths_[i]));
  }
  parameters_.assign(offsets_.back(), 0);
}

Mlp Mlp::Random(std::vector<int> widths, Rng& rng) {
  Mlp network(std::move(widths));
  for (int layer = 0; layer < network.layers(); ++layer) {
    const double bound = 1 / std::sqrt(static_cast<double>(network.widths_[static_cast<std::size_t>(layer)]));
    for (std::size_t i = network.offset(layer); i < network.offset(layer + 1); ++i) {
      network.parameters_[i] = static_cast<float>(rng.Uniform(-bound, bound));
    }
  }
  return network;
}

std::span<const float> Mlp::weights(int layer) const {
  const auto i = static_cast<std::size_t>(layer);
  return parameters().subspan(offsets_[i],
                              static_cast<std::size_t>(widths_[i]) * static_cast<std::size_t>(widths_[i + 1]));
}

std::span<const float> Mlp::bias(int layer) const {
  const auto i = static_cast<std::size_t>(layer);
  const auto outputs = static_cast<std::size_t>(widths_[i + 1]);
  return parameters().subspan(offsets_[i + 1] - outputs, outputs);
}

MlpPass::MlpPass(const std::vector<int>& widths, int max_batch, const Kernels& kernels)
    : widths_(widths), max_batch_(max_batch), kernels_(&kernels), gradient_(Mlp(widths).parameters().size()) {
  TAUTLINE_CHECK(max_batch > 0);
  for (std::size_t level = 0; level < widths_.size(); ++level) {
    values_.emplace_back(Row(level) * static_cast<std::size_t>(max_batch));
    slopes_.emplace_back(level == 0 ? 0 : values_.back().size());
  }
}

std::span<const float> MlpPass::Forward(const Mlp& network, std::span<const float> x) {
  TAUTLINE_CHECK(network.widths() == widths_);
  TAUTLINE_CHECK(!x.empty() && x.size() % Row(0) == 0 && x.size() <= values_[0].size());
  batch_ = static_cast<int>(x.size() / Row(0));
  std::copy(x.begin(), x.end(), values_[0].begin());
  for (int layer = 0; layer < network.layers(); ++layer) {
    const auto level = static_cast<std::size_t>(layer);
    kernels_->layer({.inputs = widths_[level],
                     .outputs = widths_[level + 1],
                     .batch = batch_,
                     .weights = network.weights(layer).data(),
                     .bias = network.bias(layer).data(),
                     .x = values_[level].data(),
                     .y = values_[level + 1].data(),
                     .relu = layer + 1 < network.layers()});
  }
  return std::span<const float>(values_.back()).first(Row(widths_.size() - 1) * static_cast<std::size_t>(batch_));
}

std::span<const float> MlpPass::Backward(const Mlp& network, std::span<const float> d_outputs) {
  TAUTLINE_CHECK(network.widths() == widths_);
  TAUTLINE_CHECK(batch_ > 0 && d_outputs.size() == Row(widths_.size() - 1) * static_cast<std::size_t>(batch_));
  std::copy(d_outputs.begin(), d_outputs.end(), slopes_.back().begin());
  for (int layer = network.layers() - 1; layer >= 0; --layer) {
    const auto level = static_cast<std::size_t>(layer);
    float* const d_weights = gradient_.data() + network.offset(layer);
    kernels_->layer_gradient({.inputs = widths_[level],
                              .outputs = widths_[level + 1],
                              .batch = batch_,
                              .weights = network.weights(layer).data(),
                              .x = values_[level].data(),
                              .d_y = slopes_[level + 1].data(),
                              .d_weights = d_weights,
                              .d_bias = d_weights + network.weights(layer).size(),
                              .d_x = layer == 0 ? nullptr : slopes_[level].data()});
  }
  return gradient_;
}

}  // namespace tautline
