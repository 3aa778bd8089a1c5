// The manual page of a program.
#ifndef APPS_TERMINAL_FILES_MAN_PAGE_H_
#define APPS_TERMINAL_FILES_MAN_PAGE_H_

#include <string>

#include "apps/terminal_files/command_table.h"

namespace tautline::terminal_files {

/// What stands at the foot of the page.
struct ManPageOptions {
  std::string version;  ///< "0.1.0".
  std::string date;     ///< Of this version, "2026-11-22": pages of the same sources are the same bytes.
};

/// The page in section 1, in the man macros of roff. Options that all commands share stand once.
std::string ManPage(const CommandRow& program, const ManPageOptions& options);

}  // namespace tautline::terminal_files

#endif  // APPS_TERMINAL_FILES_MAN_PAGE_H_
