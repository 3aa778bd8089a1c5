#include "apps/answers/verification.h"

#include <stdexcept>

namespace tautline {

bool MustVerify(bool asked) {
#ifdef TAUTLINE_VERIFY
  static_cast<void>(asked);
  return true;
#else
  return asked;
#endif
}

int ReportVerification(const std::vector<std::string>& faults, int curves, Json& json) {
  if (!faults.empty()) {
    throw std::logic_error("the answer failed verification: " + faults[0] + " (" + std::to_string(faults.size()) +
                           " faults)");
  }
  json["verified"] = {{"curves", curves}};
  return curves;
}

}  // namespace tautline
