// Compiled with flags of its own; see kernel_loops.inc for why Eigen has another name here.
#define Eigen EigenAvx512
#define TAUTLINE_KERNEL_LANES 16
#include "tautline/network/kernel_loops.inc"
#include "tautline/network/kernels_wide.h"

namespace tautline {

const Kernels kAvx512Kernels{"avx512", Layer, LayerGradient, Adam, SquareSum};

}  // namespace tautline
