#include "tautline/network/kernels.h"

#ifdef TAUTLINE_WIDE_KERNELS
#include "tautline/network/kernels_wide.h"
#endif

namespace tautline {

std::vector<const Kernels*> AvailableKernels() {
  std::vector<const Kernels*> available{&PortableKernels()};
#ifdef TAUTLINE_WIDE_KERNELS
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) available.push_back(&kAvx2Kernels);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("fma")) {
    available.push_back(&kAvx512Kernels);
  }
#endif
  return available;
}

const Kernels* FindKernels(std::string_view name) {
  const std::vector<const Kernels*> available = AvailableKernels();
  if (name == "auto") return available.back();
  for (const Kernels* kernels : available) {
    if (kernels->name == name) return kernels;
  }
  return nullptr;
}

}  // namespace tautline
