#include "tautline/scene/movingai_scen.h"

#include <optional>

#include "tautline/scene/number_fault.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/text_lines.h"

namespace tautline {
namespace {

/// bucket, map, width, height, start column and row, goal column and row, length.
std::optional<ScenProblem> ReadProblem(const std::vector<std::string_view>& words) {
  constexpr std::size_t kColumns = 9;
  if (words.size() != kColumns) return std::nullopt;
  const auto bucket = ParseCount(words[0]), width = ParseCount(words[2]), height = ParseCount(words[3]);
  const auto start_column = ParseCount(words[4]), start_row = ParseCount(words[5]);
  const auto goal_column = ParseCount(words[6]), goal_row = ParseCount(words[7]);
  const auto length = ParseNumber(words[8]);
  if (!bucket || !width || !height || !start_column || !start_row || !goal_column || !goal_row) return std::nullopt;
  if (!length || NonNegativeFault(*length)) return std::nullopt;
  if (*start_column >= *width || *goal_column >= *width || *start_row >= *height || *goal_row >= *height) {
    return std::nullopt;
  }
  ScenProblem problem;
  problem.bucket = *bucket;
  problem.map = std::string(words[1]);
  problem.width = *width;
  problem.height = *height;
  problem.start = {*start_column, *start_row};
  problem.goal = {*goal_column, *goal_row};
  problem.octile_length = *length;
  return problem;
}

}  // namespace

Expected<std::vector<ScenProblem>> ParseMovingAiScen(std::string_view text, const std::string& file) {
  TextLines lines(text);
  const auto first = lines.Next();
  const auto words = SplitWords(first.value_or(""));
  if (words.size() != 2 || words[0] != "version" || (words[1] != "1" && words[1] != "1.0")) {
    return InvalidInput("a scen file starts with 'version 1'", file + ":1");
  }
  std::vector<ScenProblem> problems;
  for (auto line = lines.Next(); line; line = lines.Next()) {
    const auto columns = SplitWords(*line);
    if (columns.empty()) continue;
    auto problem = ReadProblem(columns);
    if (!problem) {
      return InvalidInput(
          "a problem needs nine columns: bucket map width height x y x y length, with cells inside the "
          "map and a finite length",
          file + ":" + std::to_string(lines.number()));
    }
    problems.push_back(std::move(*problem));
  }
  return problems;
}

}  // namespace tautline
