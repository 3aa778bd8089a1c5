#define TAUTLINE_KERNEL_LANES 4
#include "tautline/network/kernel_loops.inc"

namespace tautline {

const Kernels& PortableKernels() {
  static constexpr Kernels kKernels{"portable", Layer, LayerGradient, Adam, SquareSum};
  return kKernels;
}

}  // namespace tautline
