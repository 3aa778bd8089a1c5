// The program `tautline`: parses the call, runs one command, turns errors into one line and an exit status.
#include <CLI/App.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <sstream>
#include <string>
#include <vector>

#include "apps/answers/exit_status.h"
#include "apps/cli/add_commands.h"
#include "apps/cli/nested_commands.h"
#include "apps/cli/output_file.h"

namespace tautline::cli {
namespace {

int Complain(const std::string& what, int status) {
  std::fprintf(stderr, "tautline: %s\n", what.c_str());
  return status;
}

/// What is wrong with the call; an option that nobody knows comes before anything that is missing.
std::string WhatIsWrong(const CLI::App& app, const CLI::ParseError& error) {
  std::string command = "tautline";
  const CLI::App* at = &app;
  for (bool deeper = true; deeper;) {
    deeper = false;
    for (const CLI::App* sub : at->get_subcommands([](const CLI::App* called) { return called->parsed(); })) {
      command += " " + sub->get_name();
      at = sub;
      deeper = true;
      break;
    }
  }
  std::string what = error.what();
  for (const std::string& unknown : app.remaining(true)) {
    if (unknown[0] == '-') what = "there is no option " + unknown;
  }
  return what + "; see `" + command + " --help`";
}

int Main(int argc, char** argv) {
  HandleSignals();
  CLI::App app;
  const Run run = AddCommands(app);
  if (const auto unknown = UnknownCommand(app, {argv + std::min(argc, 1), argv + argc})) {
    return Complain(*unknown, kExitBadInput);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    app.exit(help, text, text);
    const auto written = WriteStandardOutput(text.str());
    return written ? kExitSolved : Complain(ToString(written.error()), kExitBadInput);
  } catch (const CLI::ParseError& error) {
    return Complain(WhatIsWrong(app, error), kExitBadInput);
  }
  const auto status = run();
  return status ? *status : Complain(ToString(status.error()), kExitBadInput);
}

}  // namespace
}  // namespace tautline::cli

int main(int argc, char** argv) {
  try {
    return tautline::cli::Main(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "tautline: out of memory: the scene is too large for this machine\n");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "tautline: a fault of tautline's own, please report it with the scene: %s\n", fault.what());
  }
  return tautline::kExitFault;
}
