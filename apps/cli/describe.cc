#include "apps/cli/describe.h"

#include <fmt/format.h>

#include "tautline/scene/number_text.h"

namespace tautline::cli {
namespace {

/// Points shown before a long list is cut.
constexpr std::size_t kMostPoints = 12;

}  // namespace

std::string Describe(std::span<const Point> points) {
  std::string text;
  const std::size_t head = points.size() > kMostPoints ? kMostPoints - 3 : points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == head) {
      text += fmt::format(" ... {} more ...", points.size() - kMostPoints);
      i = points.size() - 3;
    }
    text += (i == 0 ? "" : " ") + ShortText(points[i]);
  }
  return text;
}

std::string Describe(const Word& word, const std::vector<std::string>& names) {
  return word.empty() ? "'' (the empty word)" : "'" + ToString(word, names) + "'";
}

std::string SquareMetres(double value) { return Metres(value) + "\u00b2"; }

std::string Counted(std::size_t count, const std::string& singular, const std::string& plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

std::string DescribeVerification(int curves) {
  if (curves == 0) return "";
  return fmt::format("  verified {} taut curves: free, taut, with the words and lengths claimed\n", curves);
}

}  // namespace tautline::cli
