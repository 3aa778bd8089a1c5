#include "apps/terminal_files/zsh_completion.h"

#include <fmt/format.h>

#include <algorithm>

namespace tautline::terminal_files {
namespace {

/// In single quotes.
std::string Quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

/// A text within a specification, where brackets and colons have a meaning.
std::string Escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// ":message:action" for a value.
std::string ValueSpec(const OptionRow& row) {
  const std::string message = ":" + Escaped(row.placeholder) + ":";
  switch (row.kind) {
    case ValueKind::kNone:
      return "";
    case ValueKind::kFile:
      return message + "_files";
    case ValueKind::kFolder:
      return message + "_files -/";
    case ValueKind::kScene:
      return message + "_files -g \"*.(yaml|yml|json)(-.)\"";
    case ValueKind::kChoice:
      return fmt::format("{}({})", message, fmt::join(row.choices, " "));
    case ValueKind::kFree:
      break;
  }
  return message + " ";
}

/// The arguments that tell _arguments of an option, one for each of its names.
std::string OptionSpecs(const OptionRow& option) {
  const bool ends_the_call = std::any_of(option.names.begin(), option.names.end(), [](const std::string& name) {
    return name == "--help" || name == "--version";
  });
  std::string text;
  for (const std::string& name : option.names) {
    std::string excluded = option.repeatable ? "" : fmt::format("{}", fmt::join(option.names, " "));
    if (ends_the_call) excluded = "- :";
    for (const std::string& other : option.excludes) excluded += (excluded.empty() ? "" : " ") + other;
    std::string spec = excluded.empty() ? "" : "(" + excluded + ")";
    if (option.repeatable) spec += "*";
    spec += name;
    if (option.kind != ValueKind::kNone && name.rfind("--", 0) == 0) spec += "=";
    spec += "[" + Escaped(option.description) + "]" + ValueSpec(option);
    text += " \\\n    " + Quoted(spec);
  }
  return text;
}

std::string FunctionName(const CommandRow& command) {
  std::string name = "_" + command.called;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// The function of a command that has no commands of its own.
std::string LeafFunction(const CommandRow& command) {
  std::string text = FunctionName(command) + "() {\n  _arguments -S";
  for (const OptionRow& option : command.options) text += OptionSpecs(option);
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const OptionRow& argument = command.arguments[i];
    const std::string place = argument.repeatable ? "*" : std::to_string(i + 1);
    text += " \\\n    " + Quoted(place + ValueSpec(argument));
  }
  return text + "\n}\n\n";
}

/// The function of a command that leads to others.
std::string BranchFunction(const CommandRow& command) {
  std::string text = FunctionName(command) +
                     "() {\n  local curcontext=$curcontext state line\n  local -A opt_args\n"
                     "  _arguments -C";
  for (const OptionRow& option : command.options) text += OptionSpecs(option);
  text += " \\\n    '1: :->command' \\\n    '*:: :->rest'\n  case $state in\n    command)\n      local -a commands=(";
  for (const CommandRow& sub : command.commands) {
    text += "\n        " + Quoted(Escaped(sub.name) + ":" + Escaped(sub.description));
  }
  text +=
      fmt::format("\n      )\n      _describe -t commands {} commands\n      ;;\n    rest)\n      case $words[1] in\n",
                  Quoted(command.called + " command"));
  for (const CommandRow& sub : command.commands) {
    text += fmt::format("        {}) {} ;;\n", sub.name, FunctionName(sub));
  }
  return text + "      esac\n      ;;\n  esac\n}\n\n";
}

}  // namespace

std::string ZshCompletion(const CommandRow& program) {
  std::string text =
      fmt::format("#compdef {0}\n# Completion of {0} in zsh, made from the program's own options.\n\n", program.name);
  for (const CommandRow* command : AllCommands(program)) {
    text += command->commands.empty() ? LeafFunction(*command) : BranchFunction(*command);
  }
  return text + FunctionName(program) + " \"$@\"\n";
}

}  // namespace tautline::terminal_files
