// Results in words, for people at a terminal.
#ifndef APPS_CLI_DESCRIBE_H_
#define APPS_CLI_DESCRIBE_H_

#include <span>
#include <string>
#include <vector>

#include "tautline/geometry/point.h"
#include "tautline/homotopy/word.h"

namespace tautline::cli {

/// "(1, 2) (3.5, 4) ...": numbers by ShortNumber; long lists are cut in the middle.
std::string Describe(std::span<const Point> points);

/// "'a b^-1'", or "'' (the empty word)".
std::string Describe(const Word& word, const std::vector<std::string>& names);

/// "12.34 m²".
std::string SquareMetres(double value);

/// "1 class", "3 classes".
std::string Counted(std::size_t count, const std::string& singular, const std::string& plural);

/// The line that tells of verified curves; nothing where there are none.
std::string DescribeVerification(int curves);

}  // namespace tautline::cli

#endif  // APPS_CLI_DESCRIBE_H_
