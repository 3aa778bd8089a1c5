// terminal_files KIND: prints the bash or zsh completion or the manual page of tautline, made from its own options.
#include <CLI/App.hpp>
#include <cstdio>
#include <exception>
#include <string>

#include "apps/cli/add_commands.h"
#include "apps/terminal_files/bash_completion.h"
#include "apps/terminal_files/man_page.h"
#include "apps/terminal_files/zsh_completion.h"

namespace tautline::terminal_files {
namespace {

int Main(const std::string& kind) {
  CLI::App app;
  cli::AddCommands(app);
  const CommandRow program = ReadCommandLine(app);
  std::string text;
  if (kind == "bash") text = BashCompletion(program);
  if (kind == "zsh") text = ZshCompletion(program);
  if (kind == "man") text = ManPage(program, {.version = TAUTLINE_VERSION, .date = TAUTLINE_VERSION_DATE});
  if (text.empty()) return std::fputs("terminal_files bash|zsh|man\n", stderr), 2;
  return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0 ? 2 : 0;
}

}  // namespace
}  // namespace tautline::terminal_files

int main(int argc, char** argv) {
  try {
    return tautline::terminal_files::Main(argc == 2 ? argv[1] : "");
  } catch (const std::exception& fault) {
    return std::fprintf(stderr, "terminal_files: %s\n", fault.what()), 1;
  }
}
