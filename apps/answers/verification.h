// Verified answers: what every command does with the faults that a check found.
#ifndef APPS_ANSWERS_VERIFICATION_H_
#define APPS_ANSWERS_VERIFICATION_H_

#include <string>
#include <vector>

#include "apps/answers/json_values.h"

namespace tautline {

/// Whether to verify: where asked for, and always in builds that verify (TAUTLINE_VERIFY).
bool MustVerify(bool asked);

/// Adds to the answer how many curves were checked, and returns it; a fault is one of tautline's own and throws
/// std::logic_error.
int ReportVerification(const std::vector<std::string>& faults, int curves, Json& json);

}  // namespace tautline

#endif  // APPS_ANSWERS_VERIFICATION_H_
