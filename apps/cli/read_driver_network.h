// The file of a policy for all maps.
#ifndef APPS_CLI_READ_DRIVER_NETWORK_H_
#define APPS_CLI_READ_DRIVER_NETWORK_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/network/mlp.h"

namespace tautline::cli {

/// The network of a policy that `learn imitate` wrote. Errors: the file cannot be read, is larger than 64 MiB, or is no
/// such policy.
[[nodiscard]] Expected<Mlp> ReadDriverNetwork(const std::string& path);

}  // namespace tautline::cli

#endif  // APPS_CLI_READ_DRIVER_NETWORK_H_
