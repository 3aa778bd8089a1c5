// Completion of a command line in zsh.
#ifndef APPS_TERMINAL_FILES_ZSH_COMPLETION_H_
#define APPS_TERMINAL_FILES_ZSH_COMPLETION_H_

#include <string>

#include "apps/terminal_files/command_table.h"

namespace tautline::terminal_files {

/// A script that completes commands, options, words of options and file names, with what --help says about each. To be
/// installed as `_program` in a folder of zsh's $fpath, such as share/zsh/vendor-completions.
std::string ZshCompletion(const CommandRow& program);

}  // namespace tautline::terminal_files

#endif  // APPS_TERMINAL_FILES_ZSH_COMPLETION_H_
