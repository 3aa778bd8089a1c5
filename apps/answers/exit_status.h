// The exit statuses of the program; see docs/formats.md.
#ifndef APPS_ANSWERS_EXIT_STATUS_H_
#define APPS_ANSWERS_EXIT_STATUS_H_

namespace tautline {

enum ExitStatus : int {
  kExitSolved = 0,
  kExitFault = 1,       ///< A fault of tautline's own.
  kExitBadInput = 2,    ///< The input or the call is wrong, or its output cannot be written.
  kExitInfeasible = 3,  ///< Well posed, and without a solution.
};

}  // namespace tautline

#endif  // APPS_ANSWERS_EXIT_STATUS_H_
