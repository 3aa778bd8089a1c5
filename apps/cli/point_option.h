// A point on the command line: X,Y.
#ifndef APPS_CLI_POINT_OPTION_H_
#define APPS_CLI_POINT_OPTION_H_

#include <string>

#include "tautline/base/error.h"
#include "tautline/geometry/point.h"

namespace tautline::cli {

/// Reads "X,Y", metres. Errors name the option.
[[nodiscard]] Expected<Point> ParsePoint(const std::string& text, const std::string& option);

}  // namespace tautline::cli

#endif  // APPS_CLI_POINT_OPTION_H_
