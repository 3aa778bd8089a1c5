#include "apps/cli/nested_commands.h"

#include <algorithm>

#include "apps/answers/exit_status.h"

namespace tautline::cli {
namespace {

/// "plan, reach and show". Requires a command.
std::string NamesOf(const std::vector<const CLI::App*>& commands) {
  std::string names = commands[0]->get_name();
  if (commands.size() == 1) return names;
  for (std::size_t i = 1; i + 1 < commands.size(); ++i) names += ", " + commands[i]->get_name();
  return names + " and " + commands.back()->get_name();
}

}  // namespace

Run AddNested(CLI::App& command, std::initializer_list<Run (*)(CLI::App&)> adders) {
  command.require_subcommand(1);
  std::vector<Run> runs;
  for (const auto add : adders) runs.push_back(add(command));
  return [&command, runs]() -> Expected<int> {
    const auto commands = command.get_subcommands({});
    for (std::size_t i = 0; i < commands.size(); ++i) {
      if (commands[i]->parsed()) return runs[i]();
    }
    return kExitBadInput;
  };
}

std::optional<std::string> UnknownCommand(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* at = &app;
  std::string called;
  for (const std::string& word : words) {
    const auto commands = at->get_subcommands([](const CLI::App*) { return true; });
    if (commands.empty() || word.empty() || word[0] == '-') return std::nullopt;
    const auto next = std::find_if(commands.begin(), commands.end(),
                                   [&word](const CLI::App* command) { return command->check_name(word); });
    if (next == commands.end()) {
      called += word;
      return "there is no command '" + called + "'; there are " + NamesOf(commands);
    }
    called += word + " ";
    at = *next;
  }
  return std::nullopt;
}

}  // namespace tautline::cli
