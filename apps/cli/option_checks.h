// What option values may be, with messages that fit a line.
#ifndef APPS_CLI_OPTION_CHECKS_H_
#define APPS_CLI_OPTION_CHECKS_H_

#include <CLI/App.hpp>

namespace tautline::cli {

/// A finite number, 0 or more.
CLI::Validator NonNegative();

/// A whole number, 1 or more.
CLI::Validator AtLeastOne();

/// A finite number larger than 0.
CLI::Validator Positive();

/// The number 4 or 8: to how many neighbours a cell has steps.
CLI::Validator FourOrEight();

/// A FileName, or `-` for standard input.
CLI::Validator InputName();

/// The name of a file: not empty, and not an option that the name was forgotten before.
CLI::Validator FileName();

}  // namespace tautline::cli

#endif  // APPS_CLI_OPTION_CHECKS_H_
