// Completion of a command line in bash.
#ifndef APPS_TERMINAL_FILES_BASH_COMPLETION_H_
#define APPS_TERMINAL_FILES_BASH_COMPLETION_H_

#include <string>

#include "apps/terminal_files/command_table.h"

namespace tautline::terminal_files {

/// A script that completes commands, options, words of options and file names; it needs nothing but bash 4.4. To be
/// installed under the program's name in share/bash-completion/completions, or read by `source`.
std::string BashCompletion(const CommandRow& program);

}  // namespace tautline::terminal_files

#endif  // APPS_TERMINAL_FILES_BASH_COMPLETION_H_
