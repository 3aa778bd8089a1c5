#include "apps/terminal_files/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace tautline::terminal_files {
namespace {

/// Text that roff prints as it is; hyphens as those that are typed, so that options can be copied from the page.
std::string Roff(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      // A dot or a quote that begins a line would be a request.
      if (escaped.empty() && (c == '.' || c == '\'')) escaped += "\\&";
      escaped += c;
    }
  }
  return escaped;
}

char Capital(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// As a sentence, with a full stop unless it has one.
std::string Sentence(const std::string& text) {
  const bool ends = !text.empty() && text.find_first_of(".!?", text.size() - 1) != std::string::npos;
  return Roff(text.empty() ? "" : Capital(text[0]) + text.substr(1)) + (ends ? "" : ".");
}

bool IsOfAll(const OptionRow& row, const std::vector<const CommandRow*>& commands) {
  return std::all_of(commands.begin(), commands.end(), [&](const CommandRow* command) {
    return std::any_of(command->options.begin(), command->options.end(), [&](const OptionRow& option) {
      return option.names == row.names && option.description == row.description;
    });
  });
}

std::string OptionParagraph(const OptionRow& option) {
  std::string text = ".TP\n";
  for (std::size_t i = 0; i < option.names.size(); ++i) {
    text += fmt::format("{}\\fB{}\\fR", i > 0 ? ", " : "", Roff(option.names[i]));
  }
  if (!option.placeholder.empty()) text += fmt::format(" \\fI{}\\fR", Roff(option.placeholder));
  text += "\n" + Sentence(option.description) + "\n";
  if (!option.default_value.empty()) text += fmt::format("Default: {}.\n", Roff(option.default_value));
  if (option.repeatable) text += "Can be given several times.\n";
  if (!option.excludes.empty()) {
    text += fmt::format("Not with {}.\n", Roff(fmt::format("{}", fmt::join(option.excludes, ", "))));
  }
  return text;
}

/// The lines below the options of --help: indented ones are examples, which stand as they are.
std::string Footer(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text;
  bool in_example = false;
  for (std::string line; std::getline(lines, line);) {
    const bool is_example = line.rfind("  ", 0) == 0;
    if (is_example && !in_example) text += ".PP\n.RS 4\n.nf\n";
    if (!is_example && in_example) text += ".fi\n.RE\n";
    if (!is_example) text += ".PP\n";
    text += Roff(is_example ? line.substr(2) : line) + "\n";
    in_example = is_example;
  }
  return text + (in_example ? ".fi\n.RE\n" : "");
}

/// A command's call, meaning, own options and example.
std::string CommandSection(const CommandRow& command, const std::vector<const CommandRow*>& leaves) {
  std::string text = fmt::format(".SS {}\n.B {}\n", Roff(command.called), Roff(command.called));
  for (const OptionRow& argument : command.arguments) text += fmt::format(".I {}\n", Roff(argument.placeholder));
  text += fmt::format(".RI [ options ]\n.PP\n{}\n", Sentence(command.description));
  for (const OptionRow& argument : command.arguments) {
    text += fmt::format(".TP\n.I {}\n{}\n", Roff(argument.placeholder), Sentence(argument.description));
  }
  for (const OptionRow& option : command.options) {
    if (!IsOfAll(option, leaves)) text += OptionParagraph(option);
  }
  return text + Footer(command.footer);
}

std::string Synopsis(const CommandRow& program) {
  std::string text = ".SH SYNOPSIS\n";
  text += fmt::format(".B {0}\n.I COMMAND SCENE\n.RI [ options ]\n.br\n", program.name);
  text += fmt::format(".B {0}\n.I COMMAND\n.B \\-\\-help\n", program.name);
  for (const OptionRow& option : program.options) {
    const auto is_long = [](const std::string& name) { return name.rfind("--", 0) == 0; };
    const auto name = std::find_if(option.names.begin(), option.names.end(), is_long);
    if (name == option.names.end()) continue;
    text += fmt::format(".br\n.B {} {}\n", program.name, Roff(*name));
    if (!option.placeholder.empty()) text += fmt::format(".I {}\n", Roff(option.placeholder));
  }
  return text;
}

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
.B 0
The question is answered.
.TP
.B 1
A fault of the program's own.
.TP
.B 2
The scene or the call is wrong: one line on standard error says what, where
and how to mend it.
Nothing is written.
.TP
.B 3
The question is well posed and has no solution, or the search was stopped:
the answer says why.
.TP
.B 130
Interrupted by Ctrl-C.
No unfinished file is left behind.
)";

}  // namespace

std::string ManPage(const CommandRow& program, const ManPageOptions& options) {
  std::vector<const CommandRow*> leaves;
  for (const CommandRow* command : AllCommands(program)) {
    if (command->commands.empty()) leaves.push_back(command);
  }
  // "Plans for robots: exact ..." is named by its first part.
  std::string subject = program.description.substr(0, program.description.find_first_of(":."));
  if (!subject.empty() && 'A' <= subject[0] && subject[0] <= 'Z') {
    subject[0] = static_cast<char>(subject[0] - 'A' + 'a');
  }
  std::string title = program.name;
  for (char& c : title) c = Capital(c);
  std::string text = fmt::format(".TH {} 1 {} \"{} {}\" \"User Commands\"\n", Roff(title), options.date, program.name,
                                 options.version);
  text += fmt::format(".SH NAME\n{} \\- {}\n", Roff(program.name), Roff(subject));
  text += Synopsis(program);
  text += fmt::format(".SH DESCRIPTION\n{}\n", Sentence(program.description));
  text += "Each command reads a scene, a YAML or JSON file, and answers one question.\n.PP\n";
  text += "The options that all commands share are listed first.\n.SH OPTIONS OF ALL COMMANDS\n";
  for (const OptionRow& option : leaves.front()->options) {
    if (IsOfAll(option, leaves)) text += OptionParagraph(option);
  }
  text += ".SH OPTIONS OF THE PROGRAM\n";
  for (const OptionRow& option : program.options) {
    if (!IsOfAll(option, leaves)) text += OptionParagraph(option);
  }
  text += ".SH COMMANDS\n";
  for (const CommandRow* leaf : leaves) text += CommandSection(*leaf, leaves);
  return text + kEnd;
}

}  // namespace tautline::terminal_files
