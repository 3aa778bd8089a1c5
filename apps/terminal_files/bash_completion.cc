#include "apps/terminal_files/bash_completion.h"

#include <fmt/format.h>

#include <map>

namespace tautline::terminal_files {
namespace {

/// What stays the same for all programs; % is the program's name. The functions made from the table stand before it.
constexpr const char* kMachinery = R"(_%_reply() {  # _%_reply KIND CHOICES CURRENT: fills COMPREPLY
  local pattern
  case $1 in
    file) mapfile -t COMPREPLY < <(compgen -f -- "$3") ;;
    folder) mapfile -t COMPREPLY < <(compgen -d -- "$3") ;;
    scene)
      mapfile -t COMPREPLY < <(
        compgen -d -- "$3"
        for pattern in '!*.yaml' '!*.yml' '!*.json'; do compgen -f -X "$pattern" -- "$3"; done
      )
      ;;
    choice) mapfile -t COMPREPLY < <(compgen -W "$2" -- "$3") ;;
  esac
  # Marks folders with a slash and quotes blanks; bash knows it only while it completes.
  case $1 in file | folder | scene) compopt -o filenames 2>/dev/null ;; esac
}

_%() {
  local current=${COMP_WORDS[COMP_CWORD]} call=% word kind='' choices='' commands='' options=''
  local -a arguments=()
  local -i i place=0 only_arguments=0
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == '=' ]]; then continue; fi  # bash splits --option=value into three words.
    if [[ -n $kind ]]; then                   # This word is the value of the option before it.
      kind=''
    elif ((!only_arguments)) && [[ $word == -- ]]; then
      only_arguments=1
    elif ((!only_arguments)) && [[ $word == -* ]]; then
      _%_value "$call" "$word"
    else
      _%_command "$call"
      if [[ " $commands " == *" $word "* ]]; then call+=" $word"; else place+=1; fi
    fi
  done
  [[ $current == '=' ]] && current=''
  if [[ -n $kind ]]; then
    _%_reply "$kind" "$choices" "$current"
    return
  fi
  _%_command "$call"
  if ((!only_arguments)) && [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  elif [[ -n $commands ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
  elif ((place < ${#arguments[*]})); then
    _%_reply "${arguments[place]/:*/}" "${arguments[place]#*:}" "$current"
  elif ((!only_arguments)); then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
  fi
}

complete -F _% %
)";

std::string KindWord(ValueKind kind) {
  switch (kind) {
    case ValueKind::kNone:
      return "";
    case ValueKind::kFile:
      return "file";
    case ValueKind::kFolder:
      return "folder";
    case ValueKind::kScene:
      return "scene";
    case ValueKind::kChoice:
      return "choice";
    case ValueKind::kFree:
      break;
  }
  return "free";
}

/// `_x_command CALL` sets commands, options and arguments, each "kind:choices", of a call.
std::string CommandFunction(const CommandRow& program) {
  std::string text =
      fmt::format("_{}_command() {{\n  commands='' options='' arguments=()\n  case $1 in\n", program.name);
  for (const CommandRow* command : AllCommands(program)) {
    std::string commands, options, arguments;
    for (const CommandRow& sub : command->commands) commands += (commands.empty() ? "" : " ") + sub.name;
    for (const OptionRow& option : command->options) {
      for (const std::string& name : option.names) options += (options.empty() ? "" : " ") + name;
    }
    for (const OptionRow& argument : command->arguments) {
      arguments += fmt::format(" '{}:{}'", KindWord(argument.kind), fmt::join(argument.choices, " "));
    }
    text += fmt::format("    '{}')\n      commands='{}'\n      options='{}'\n", command->called, commands, options);
    if (!arguments.empty()) text += fmt::format("      arguments=({})\n", arguments.substr(1));
    text += "      ;;\n";
  }
  return text + "  esac\n}\n\n";
}

/// `_x_value CALL OPTION` sets kind and choices for the value of an option.
std::string ValueFunction(const CommandRow& program) {
  std::map<std::string, std::string> calls_of;  // From what is set to the calls for which it is.
  for (const CommandRow* command : AllCommands(program)) {
    for (const OptionRow& option : command->options) {
      if (option.kind == ValueKind::kNone) continue;
      std::string& calls =
          calls_of[fmt::format("kind={} choices='{}'", KindWord(option.kind), fmt::join(option.choices, " "))];
      for (const std::string& name : option.names) {
        calls += fmt::format("{}'{} {}'", calls.empty() ? "" : " | \\\n      ", command->called, name);
      }
    }
  }
  std::string text = fmt::format("_{}_value() {{\n  kind='' choices=''\n  case \"$1 $2\" in\n", program.name);
  for (const auto& [value, calls] : calls_of) text += fmt::format("    {})\n      {} ;;\n", calls, value);
  return text + "  esac\n}\n\n";
}

}  // namespace

std::string BashCompletion(const CommandRow& program) {
  std::string machinery;
  for (const char c : std::string_view(kMachinery)) machinery += c == '%' ? program.name : std::string(1, c);
  return fmt::format("# Completion of {} in bash, made from the program's own options.\n\n", program.name) +
         CommandFunction(program) + ValueFunction(program) + machinery;
}

}  // namespace tautline::terminal_files
