#include "apps/cli/option_checks.h"

#include <cmath>
#include <cstdint>
#include <string>

namespace tautline::cli {

CLI::Validator NonNegative() {
  const auto check = [](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0) return "";
    return "'" + text + "' is not a number of 0 or more";
  };
  return CLI::Validator(check, "");
}

CLI::Validator Positive() {
  const auto check = [](const std::string& text) -> std::string {
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0) return "";
    return "'" + text + "' is not a number larger than 0";
  };
  return CLI::Validator(check, "");
}

CLI::Validator AtLeastOne() {
  const auto check = [](const std::string& text) -> std::string {
    std::int64_t value = 0;
    if (CLI::detail::lexical_cast(text, value) && value >= 1) return "";
    return "'" + text + "' is not a whole number of 1 or more";
  };
  return CLI::Validator(check, "");
}

CLI::Validator FourOrEight() {
  const auto check = [](const std::string& text) -> std::string {
    return text == "4" || text == "8" ? "" : "'" + text + "' is neither 4 nor 8";
  };
  // Completions read the choices from here.
  return CLI::Validator(check, "{4,8}");
}

CLI::Validator FileName() {
  const auto check = [](const std::string& text) -> std::string {
    if (text.empty()) return "the name of the file is empty";
    return text[0] == '-' ? "'" + text + "' is an option, not the name of a file; write ./" + text + " if it is" : "";
  };
  return CLI::Validator(check, "");
}

CLI::Validator InputName() {
  const auto check = [](const std::string& text) -> std::string {
    std::string name = text;
    return text == "-" ? "" : FileName()(name);
  };
  return CLI::Validator(check, "");
}

}  // namespace tautline::cli
