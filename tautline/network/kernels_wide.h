// The tables of the kernels for wide vectors; only where TAUTLINE_WIDE_KERNELS is defined, and only to be called where
// the processor has those vectors.
#ifndef TAUTLINE_NETWORK_KERNELS_WIDE_H_
#define TAUTLINE_NETWORK_KERNELS_WIDE_H_

#include "tautline/network/kernels.h"

namespace tautline {

/// For AVX2 with FMA.
extern const Kernels kAvx2Kernels;
/// For AVX-512 (F, BW, DQ, VL).
extern const Kernels kAvx512Kernels;

}  // namespace tautline

#endif  // TAUTLINE_NETWORK_KERNELS_WIDE_H_
