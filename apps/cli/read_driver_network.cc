#include "apps/cli/read_driver_network.h"

#include "tautline/network/kernels.h"
#include "tautline/planners/contact_free/driver_policy.h"
#include "tautline/scene/text_file.h"

namespace tautline::cli {

Expected<Mlp> ReadDriverNetwork(const std::string& path) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 26;
  const auto text = ReadTextFile(path, kMostBytes);
  if (!text) return tl::unexpected(text.error());
  const auto policy = DriverPolicy::Read(*text, path, PortableKernels());
  if (!policy) return tl::unexpected(policy.error());
  return policy->network();
}

}  // namespace tautline::cli
