// The loops in which training spends its time, compiled for several widths of vectors.
#ifndef TAUTLINE_NETWORK_KERNELS_H_
#define TAUTLINE_NETWORK_KERNELS_H_

#include <cstddef>
#include <string_view>
#include <vector>

namespace tautline {

/// One layer applied to a batch: y = x W^T + b, and the negative set to zero where `relu`. Rows of `x` and `y` are
/// samples, rows of `weights` are outputs; all are without gaps.
struct LayerCall {
  int inputs = 0;                  ///< Of one sample.
  int outputs = 0;                 ///< Of one sample.
  int batch = 0;                   ///< Samples.
  const float* weights = nullptr;  ///< outputs x inputs.
  const float* bias = nullptr;     ///< outputs.
  const float* x = nullptr;        ///< batch x inputs.
  float* y = nullptr;              ///< batch x outputs; written.
  bool relu = false;               ///< Whether the negative is set to zero.
};

/// The gradients of one layer from that of its outputs (before the ReLU).
struct LayerGradientCall {
  int inputs = 0;                  ///< Of one sample.
  int outputs = 0;                 ///< Of one sample.
  int batch = 0;                   ///< Samples.
  const float* weights = nullptr;  ///< outputs x inputs.
  const float* x = nullptr;        ///< batch x inputs: what the layer was applied to.
  const float* d_y = nullptr;      ///< batch x outputs.
  float* d_weights = nullptr;      ///< outputs x inputs; written.
  float* d_bias = nullptr;         ///< outputs; written.
  float* d_x = nullptr;            ///< batch x inputs; written, zero where x is (a ReLU's output). Null: not wanted.
};

/// One step of Adam [Kingma2014] on `count` numbers.
struct AdamCall {
  std::size_t count = 0;            ///< How many numbers.
  const float* gradient = nullptr;  ///< Of the loss.
  float gradient_scale = 1;         ///< The gradient is multiplied by this.
  float* parameters = nullptr;      ///< Changed.
  float* mean = nullptr;            ///< Of gradients; changed.
  float* square = nullptr;          ///< Of gradients, the mean of squares; changed.
  float decay_mean = 0;             ///< beta 1.
  float decay_square = 0;           ///< beta 2.
  float rate = 0;                   ///< Learning rate / (1 - beta1^t).
  float root_scale = 1;             ///< 1 / sqrt(1 - beta2^t).
  float epsilon = 0;                ///< Added to the root.
};

/// The loops, for one width of vectors. Each gives the same bytes for the same input, whatever the addresses; tables
/// of different widths round differently. Safe to use from several threads.
struct Kernels {
  const char* name;                                              ///< "portable", "avx2" or "avx512".
  void (*layer)(const LayerCall& call);                          ///< y.
  void (*layer_gradient)(const LayerGradientCall& call);         ///< d_weights, d_bias, d_x.
  void (*adam)(const AdamCall& call);                            ///< parameters, mean, square.
  double (*square_sum)(const float* values, std::size_t count);  ///< The sum of squares.
};

/// For every processor; on x86-64, vectors of 4.
const Kernels& PortableKernels();

/// Those that this processor has, the widest last.
std::vector<const Kernels*> AvailableKernels();

/// "auto": the widest that this processor has; else the one of that name, or null where there is none or the processor
/// lacks it.
const Kernels* FindKernels(std::string_view name);

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_KERNELS_H_
