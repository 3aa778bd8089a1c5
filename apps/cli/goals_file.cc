#include "apps/cli/goals_file.h"

#include <optional>

#include "tautline/scene/number_fault.h"
#include "tautline/scene/number_text.h"
#include "tautline/scene/text_file.h"
#include "tautline/scene/text_lines.h"

namespace tautline::cli {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr std::size_t kMostGoals = 1'000'000;

/// The two words of a line; nothing when there are not two.
std::optional<std::pair<std::string_view, std::string_view>> TwoWords(std::string_view line) {
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos) {
    const auto words = SplitWords(line);
    if (words.size() != 2) return std::nullopt;
    return std::pair{words[0], words[1]};
  }
  const auto before = SplitWords(line.substr(0, comma)), after = SplitWords(line.substr(comma + 1));
  if (before.size() != 1 || after.size() != 1) return std::nullopt;
  return std::pair{before[0], after[0]};
}

std::optional<Point> ParseGoal(std::string_view line) {
  const auto words = TwoWords(line);
  if (!words) return std::nullopt;
  const auto x = ParseNumber(words->first), y = ParseNumber(words->second);
  if (!x || !y) return std::nullopt;
  return Point{*x, *y};
}

/// A line as an error shows it: short, and of one line.
std::string Shown(std::string_view line) {
  constexpr std::size_t kMostShown = 60;
  std::string shown(line.substr(0, kMostShown));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line.size() > kMostShown ? shown + "..." : shown;
}

}  // namespace

Expected<std::vector<Point>> ParseGoals(std::string_view text, const std::string& name) {
  std::vector<Point> goals;
  TextLines lines(text);
  while (const auto line = lines.Next()) {
    const std::string_view content = line->substr(0, line->find('#'));
    if (SplitWords(content).empty()) continue;
    const std::string where = name + ":" + std::to_string(lines.number());
    const auto goal = ParseGoal(content);
    if (!goal) {
      return InvalidInput("'" + Shown(*line) + "' is not a goal; write two numbers in a line, such as `2 3.5`", where);
    }
    if (const auto fault = PointFault(*goal)) {
      return tl::unexpected<Error>(Error{fault->code, "'" + Shown(*line) + "'" + fault->text, where});
    }
    if (goals.size() == kMostGoals) {
      return tl::unexpected<Error>(Error{ErrorCode::kLimitExceeded, "more than 1000000 goals; part the file", where});
    }
    goals.push_back(*goal);
  }
  if (goals.empty()) return InvalidInput("no goal; write one in each line, such as `2 3.5`", name);
  return goals;
}

Expected<std::vector<Point>> ReadGoals(const std::string& path) {
  const bool standard_input = path == "-";
  auto text = ReadTextFile(standard_input ? "/dev/stdin" : path, kMostBytes);
  if (!text && standard_input) text.error().where = "standard input";
  if (!text) return tl::unexpected(text.error());
  return ParseGoals(*text, standard_input ? "standard input" : path);
}

}  // namespace tautline::cli
