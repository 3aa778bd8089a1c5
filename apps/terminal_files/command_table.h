// The commands and options of a command line as plain data, from which completions and manual are made.
#ifndef APPS_TERMINAL_FILES_COMMAND_TABLE_H_
#define APPS_TERMINAL_FILES_COMMAND_TABLE_H_

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace tautline::terminal_files {

/// What a shell can offer for a value.
enum class ValueKind {
  kNone,    ///< A flag: there is no value.
  kFile,    ///< The name of a file: the type name is FILE.
  kFolder,  ///< The name of a folder: the type name is FOLDER.
  kScene,   ///< A scene, YAML or JSON: the type name is SCENE.
  kChoice,  ///< One of a few words: CLI::IsMember.
  kFree,    ///< Anything else: nothing can be offered.
};

/// An option, or an argument that is told by its place.
struct OptionRow {
  std::vector<std::string> names;  ///< "-h", "--help"; none: told by its place.
  std::string description;         ///< One line, as in --help.
  std::string placeholder;         ///< What stands for the value: "FILE", "blocked|free"; empty for a flag.
  std::vector<std::string> choices;
  ValueKind kind = ValueKind::kNone;
  std::string default_value;          ///< Empty where none is printed.
  std::vector<std::string> excludes;  ///< The long names of options that cannot stand beside this one.
  bool repeatable = false;
};

/// The program, a command or a command of a command.
struct CommandRow {
  std::string name;    ///< As it is called: "tautline", "plan".
  std::string called;  ///< The whole call: "tautline", "tautline plan".
  std::string description;
  std::string footer;  ///< The lines below the options in --help.
  std::vector<OptionRow> arguments;
  std::vector<OptionRow> options;
  std::vector<CommandRow> commands;
};

/// Reads a command line. Options and commands with an empty group are hidden and left out, as in --help; option groups
/// count as their options. O(size of the table).
CommandRow ReadCommandLine(const CLI::App& app, const std::string& caller = "");

/// The command and all commands below it, each before its own.
std::vector<const CommandRow*> AllCommands(const CommandRow& top);

}  // namespace tautline::terminal_files

#endif  // APPS_TERMINAL_FILES_COMMAND_TABLE_H_
