// Compiled with flags of its own; see kernel_loops.inc for why Eigen has another name here.
#define Eigen EigenAvx2
#define TAUTLINE_KERNEL_LANES 8
#include "tautline/network/kernel_loops.inc"
#include "tautline/network/kernels_wide.h"

namespace tautline {

const Kernels kAvx2Kernels{"avx2", Layer, LayerGradient, Adam, SquareSum};

}  // namespace tautline
