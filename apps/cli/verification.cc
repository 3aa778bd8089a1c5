#include "apps/cli/verification.h"

#include <fmt/format.h>

#include <stdexcept>

namespace tautline::cli {

bool MustVerify(const CommonOptions& options) {
#ifdef TAUTLINE_VERIFY
  return true;
#else
  return options.verify;
#endif
}

void ReportVerification(const std::vector<std::string>& faults, int curves, Json& json, std::string& text) {
  if (!faults.empty()) {
    throw std::logic_error(fmt::format("the answer failed verification: {} ({} faults)", faults[0], faults.size()));
  }
  json["verified"] = {{"curves", curves}};
  if (curves > 0) {
    text += fmt::format("  verified {} taut curves: free, taut, with the words and lengths claimed\n", curves);
  }
}

}  // namespace tautline::cli
