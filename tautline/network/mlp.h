// A multi-layer perceptron of floats: values, and gradients of a loss with respect to all parameters.
#ifndef TAUTLINE_NETWORK_MLP_H_
#define TAUTLINE_NETWORK_MLP_H_

#include <cstddef>
#include <span>
#include <vector>

#include "tautline/base/rng.h"
#include "tautline/network/kernels.h"

namespace tautline {

/// Layers of weights and biases, with a ReLU after each but the last. A plain value.
class Mlp {
 public:
  /// All parameters zero. `widths` are those of the input, of each hidden layer and of the output: {3, 256, 256, 3} has
  /// three layers of weights. Requires two widths or more, all positive.
  explicit Mlp(std::vector<int> widths);

  /// Weights and biases uniform in +-1 / sqrt(inputs of the layer), drawn layer by layer, weights first.
  static Mlp Random(std::vector<int> widths, Rng& rng);

  /// As given.
  const std::vector<int>& widths() const { return widths_; }
  /// How many layers of weights there are.
  int layers() const { return static_cast<int>(widths_.size()) - 1; }
  /// Of one sample.
  int inputs() const { return widths_.front(); }
  /// Of one sample.
  int outputs() const { return widths_.back(); }

  /// All parameters: for each layer the weights, one row for each output, and then the biases.
  std::span<float> parameters() { return parameters_; }
  /// The same.
  std::span<const float> parameters() const { return parameters_; }
  /// The weights of a layer, outputs x inputs by rows. Requires 0 <= layer < layers().
  std::span<const float> weights(int layer) const;
  /// The biases of a layer.
  std::span<const float> bias(int layer) const;
  /// Where the parameters of a layer begin in parameters().
  std::size_t offset(int layer) const { return offsets_[static_cast<std::size_t>(layer)]; }

 private:
  std::vector<int> widths_;
  std::vector<std::size_t> offsets_;  ///< Of each layer, and the end.
  std::vector<float> parameters_;
};

/// One batch on its way through networks of one shape, forward and back. Keeps what both ways share, so it is made once
/// and used again; not for two threads at a time.
class MlpPass {
 public:
  /// For networks of these widths and up to `max_batch` samples. Keeps a reference to the kernels.
  MlpPass(const std::vector<int>& widths, int max_batch, const Kernels& kernels);

  /// The outputs of a batch, one row for each sample; valid until the next call. `x` has as many rows of inputs.
  /// Requires a network of these widths and 1 to max_batch rows. 2 flops a weight and sample.
  std::span<const float> Forward(const Mlp& network, std::span<const float> x);

  /// The gradient of a loss with respect to all parameters, laid out as Mlp::parameters, from its gradient with respect
  /// to the outputs of the last Forward, which was of the same network; valid until the next call. 4 flops a weight and
  /// sample.
  std::span<const float> Backward(const Mlp& network, std::span<const float> d_outputs);

 private:
  std::size_t Row(std::size_t level) const { return static_cast<std::size_t>(widths_[level]); }

  std::vector<int> widths_;
  int max_batch_;
  const Kernels* kernels_;
  int batch_ = 0;                           ///< Of the last Forward.
  std::vector<std::vector<float>> values_;  ///< Of each level: the input, after each layer.
  std::vector<std::vector<float>> slopes_;  ///< Of the loss, of each level but the first.
  std::vector<float> gradient_;
};

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_MLP_H_
