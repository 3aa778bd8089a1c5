#include "apps/terminal_files/command_table.h"

#include <algorithm>

namespace tautline::terminal_files {
namespace {

/// The words of "TEXT:{blocked,free}", the type name of an option whose values are checked by CLI::IsMember.
std::vector<std::string> ChoicesOf(const std::string& type) {
  const std::size_t open = type.find(":{");
  if (open == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 2, type.find('}', open) - open - 2), ',');
}

ValueKind KindOf(const std::string& placeholder) {
  if (placeholder == "FILE") return ValueKind::kFile;
  if (placeholder == "FOLDER") return ValueKind::kFolder;
  if (placeholder == "SCENE") return ValueKind::kScene;
  return ValueKind::kFree;
}

/// What the library calls its types, in the words of the manual.
std::string PlaceholderOf(const std::string& type) {
  std::string name = type.substr(0, type.find(':'));
  if (name == "INT" || name == "UINT") return "N";
  if (name == "FLOAT") return "NUMBER";
  return name;
}

OptionRow ReadOption(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  row.description = option.get_description();
  row.default_value = option.get_default_str();
  for (const CLI::Option* other : option.get_excludes()) {
    for (const std::string& name : other->get_lnames()) row.excludes.push_back("--" + name);
  }
  // The set of the excluded is ordered by addresses, which no two runs share.
  std::sort(row.excludes.begin(), row.excludes.end());
  if (option.get_items_expected_max() == 0) return row;
  const std::string type = option.get_type_name();
  row.choices = ChoicesOf(type);
  row.placeholder = row.choices.empty() ? PlaceholderOf(type) : CLI::detail::join(row.choices, "|");
  row.kind = row.choices.empty() ? KindOf(row.placeholder) : ValueKind::kChoice;
  row.repeatable = option.get_items_expected_max() > 1;
  return row;
}

void ReadInto(const CLI::App& app, CommandRow& row) {
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    const OptionRow read = ReadOption(*option);
    // A group brings a --help of its own.
    const auto is_same = [&](const OptionRow& other) { return !read.names.empty() && other.names == read.names; };
    if (std::any_of(row.options.begin(), row.options.end(), is_same)) continue;
    (option->get_positional() ? row.arguments : row.options).push_back(read);
  }
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (sub->get_name().empty()) {
      ReadInto(*sub, row);
    } else if (!sub->get_group().empty()) {
      row.commands.push_back(ReadCommandLine(*sub, row.called + " "));
    }
  }
}

void Collect(const CommandRow& row, std::vector<const CommandRow*>& all) {
  all.push_back(&row);
  for (const CommandRow& command : row.commands) Collect(command, all);
}

}  // namespace

CommandRow ReadCommandLine(const CLI::App& app, const std::string& caller) {
  CommandRow row{.name = app.get_name(),
                 .called = caller + app.get_name(),
                 .description = app.get_description(),
                 .footer = app.get_footer()};
  ReadInto(app, row);
  return row;
}

std::vector<const CommandRow*> AllCommands(const CommandRow& top) {
  std::vector<const CommandRow*> all;
  Collect(top, all);
  return all;
}

}  // namespace tautline::terminal_files
