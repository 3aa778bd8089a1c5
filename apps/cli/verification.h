// Verified answers: what every command does with the faults that a check found.
#ifndef APPS_CLI_VERIFICATION_H_
#define APPS_CLI_VERIFICATION_H_

#include <string>
#include <vector>

#include "apps/cli/common_options.h"
#include "apps/cli/json_values.h"

namespace tautline::cli {

/// With --verify, and always in builds that verify (TAUTLINE_VERIFY).
bool MustVerify(const CommonOptions& options);

/// Adds what was checked to the answer; a fault is one of tautline's own and throws std::logic_error.
void ReportVerification(const std::vector<std::string>& faults, int curves, Json& json, std::string& text);

}  // namespace tautline::cli

#endif  // APPS_CLI_VERIFICATION_H_
