// Many goals from a file.
#ifndef APPS_CLI_GOALS_FILE_H_
#define APPS_CLI_GOALS_FILE_H_

#include <string>
#include <string_view>
#include <vector>

#include "tautline/base/error.h"
#include "tautline/geometry/point.h"

namespace tautline::cli {

/// The goals of a text, one in a line: `x y` or `x,y`, metres; blank lines and what follows a `#` are ignored. `name`
/// is what errors call the text. Errors, with name and line: what is no point, is not finite or is too large; no goal
/// at all; more than a million. O(length).
[[nodiscard]] Expected<std::vector<Point>> ParseGoals(std::string_view text, const std::string& name);

/// The goals of a file; `-` is standard input. Errors: those of ParseGoals, a file that cannot be read or is too large.
[[nodiscard]] Expected<std::vector<Point>> ReadGoals(const std::string& path);

}  // namespace tautline::cli

#endif  // APPS_CLI_GOALS_FILE_H_
