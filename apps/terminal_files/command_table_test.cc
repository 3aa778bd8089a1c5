#include "apps/terminal_files/command_table.h"

#include <gmock/gmock.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <string>

#include "apps/terminal_files/bash_completion.h"
#include "apps/terminal_files/zsh_completion.h"

namespace tautline::terminal_files {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A program with a command of a command, which tautline does not have yet.
class CommandTable : public ::testing::Test {
 protected:
  CommandTable() : app_("Does things.", "tool") {
    CLI::App* fleet = app_.add_subcommand("fleet", "many robots");
    fleet->require_subcommand(1);
    CLI::App* check = fleet->add_subcommand("check", "don't cross: [never]");
    CLI::Option* file = check->add_option("-o,--out", text_, "written")->type_name("FILE");
    check->add_option("--mode", text_, "how")->check(CLI::IsMember({"bent", "straight"}))->excludes(file);
    check->add_option("--many", texts_, "several");
    check->add_flag("--secret", flag_, "hidden")->group("");
    check->add_option_group("Grouped")->add_flag("--grouped", flag_, "in a group");
    check->add_option("folder", text_, "where")->type_name("FOLDER");
    app_.add_subcommand("internal", "hidden")->group("");
  }

  CLI::App app_;
  std::string text_;
  std::vector<std::string> texts_;
  bool flag_ = false;
};

TEST_F(CommandTable, HoldsCommandsOfCommandsAndLeavesOutWhatIsHidden) {
  const CommandRow program = ReadCommandLine(app_);
  std::vector<std::string> calls;
  for (const CommandRow* command : AllCommands(program)) calls.push_back(command->called);
  EXPECT_THAT(calls, ElementsAre("tool", "tool fleet", "tool fleet check"));
  const CommandRow& check = program.commands[0].commands[0];
  std::vector<std::string> names;
  for (const OptionRow& option : check.options) names.push_back(option.names.back());
  EXPECT_THAT(names, ElementsAre("--help", "--out", "--mode", "--many", "--grouped"));
}

TEST_F(CommandTable, TellsWhatAValueIs) {
  const CommandRow program = ReadCommandLine(app_);
  const CommandRow& check = program.commands[0].commands[0];
  EXPECT_EQ(check.options[0].kind, ValueKind::kNone);
  EXPECT_THAT(check.options[1].names, ElementsAre("-o", "--out"));
  EXPECT_EQ(check.options[1].kind, ValueKind::kFile);
  EXPECT_EQ(check.options[2].kind, ValueKind::kChoice);
  EXPECT_THAT(check.options[2].choices, ElementsAre("bent", "straight"));
  EXPECT_THAT(check.options[2].excludes, ElementsAre("--out"));
  EXPECT_EQ(check.options[3].kind, ValueKind::kFree);
  EXPECT_TRUE(check.options[3].repeatable);
  ASSERT_EQ(check.arguments.size(), 1U);
  EXPECT_EQ(check.arguments[0].kind, ValueKind::kFolder);
}

TEST_F(CommandTable, ReachesTheScriptsWithQuotes) {
  const CommandRow program = ReadCommandLine(app_);
  const std::string zsh = ZshCompletion(program);
  EXPECT_THAT(zsh, HasSubstr("'check:don'\\''t cross\\: \\[never\\]'"));
  EXPECT_THAT(zsh, HasSubstr("fleet) _tool_fleet ;;"));
  EXPECT_THAT(zsh, HasSubstr("'*--many=[several]"));
  const std::string bash = BashCompletion(program);
  EXPECT_THAT(bash, HasSubstr("'tool fleet check --out'"));
  EXPECT_THAT(bash, HasSubstr("arguments=('folder:')"));
  for (const std::string& script : {zsh, bash}) {
    EXPECT_THAT(script, Not(HasSubstr("secret")));
    EXPECT_THAT(script, Not(HasSubstr("internal")));
  }
}

}  // namespace
}  // namespace tautline::terminal_files
