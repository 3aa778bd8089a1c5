// What a network is trained for: losses with their gradients.
#ifndef TAUTLINE_NETWORK_LOSS_H_
#define TAUTLINE_NETWORK_LOSS_H_

#include <span>

namespace tautline {

/// Values that one output of each sample should have.
struct ChosenTargets {
  std::span<const int> chosen;     ///< For each sample, which output.
  std::span<const float> targets;  ///< For each sample, its value.
};

/// Huber's loss of the chosen outputs, with its corner at 1, as a mean over the samples [Huber1964]. `outputs` and
/// `slopes` have one row for each sample; `slopes` becomes the gradient with respect to the outputs. Requires a sample,
/// and choices within a row.
double HuberLoss(std::span<const float> outputs, const ChosenTargets& wanted, std::span<float> slopes);

/// The mean square difference over all outputs. Otherwise as HuberLoss.
double MeanSquareLoss(std::span<const float> outputs, std::span<const float> targets, std::span<float> slopes);

/// What to multiply a gradient by so that its norm is at most `max_norm`: 1 where it is, given the sum of its squares.
/// As torch.nn.utils.clip_grad_norm_ does, the norm is taken 1e-6 larger.
float ClipScale(double square_sum, double max_norm);

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_LOSS_H_
