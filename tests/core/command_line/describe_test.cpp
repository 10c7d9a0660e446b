// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "core/command_line/command_line.h"
#include "core/command_line/description.h"

namespace galilean {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Returns what `line` prints for the arguments. Requires: it ends with exit code 0.
std::string printed(CommandLine& line, std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "program");
  testing::internal::CaptureStdout();
  const auto code = line.parse(static_cast<int>(arguments.size()), arguments.data());
  EXPECT_EQ(code, 0);
  return testing::internal::GetCapturedStdout();
}

CommandDescription described(CommandLine& line, std::vector<const char*> commands = {}) {
  commands.push_back(kDescribeCommandLine);
  auto read = description_from_json(printed(line, commands));
  EXPECT_TRUE(read) << read.error().message;
  return read ? std::move(read).value() : CommandDescription{};
}

/// Returns the option or argument of that name. Requires: there is one.
OptionDescription option_of(const CommandDescription& command, const std::string& name) {
  for (const auto& option : command.options)
    if (option.argument == name || std::ranges::find(option.names, name) != option.names.end())
      return option;
  ADD_FAILURE() << "there is no " << name;
  return {};
}

TEST(DescribeCommandLine, TellsWhatAnOptionTakes) {
  CommandLine line("Runs robots.", "galilean run");
  int robots = 3;
  bool as_json = false;
  std::string format = "dot";
  std::vector<std::string> names;
  line.option("-r,--robots", robots, "how many").between(1, 16).show_default();
  line.flag("--json", as_json, "as JSON");
  line.option("--format", format, "how").one_of({"dot", "svg"}).required();
  line.option("--name", names, "who").for_example({"io"}).describe_default("all");

  const auto told = described(line);
  EXPECT_EQ(told.name, "galilean run");
  EXPECT_EQ(told.help, "Runs robots.");
  const auto count = option_of(told, "--robots");
  EXPECT_THAT(count.names, ElementsAre("-r", "--robots"));
  EXPECT_EQ(count.help, "how many");
  EXPECT_EQ(count.value, "INT");
  EXPECT_EQ(count.range, "from 1 to 16");
  EXPECT_EQ(count.default_value, "3");
  EXPECT_EQ(count.most_values, 1);
  EXPECT_FALSE(count.required);
  EXPECT_EQ(option_of(told, "--json").most_values, 0);
  EXPECT_EQ(option_of(told, "--json").value, "");
  EXPECT_THAT(option_of(told, "--format").choices, ElementsAre("dot", "svg"));
  EXPECT_TRUE(option_of(told, "--format").required);
  EXPECT_THAT(option_of(told, "--name").examples, ElementsAre("io"));
  EXPECT_THAT(option_of(told, "--name").choices, IsEmpty());
  EXPECT_EQ(option_of(told, "--name").default_value, "all");
  EXPECT_GT(option_of(told, "--name").most_values, 1);
  EXPECT_THAT(option_of(told, "--help").names, ElementsAre("-h", "--help"));
}

TEST(DescribeCommandLine, TellsFilesAndFolders) {
  CommandLine line("A program.", "program");
  std::string program, scenario, data;
  std::filesystem::path any;
  line.option("FILE", program, "a program").names_file(".bhdl");
  line.option("--scenario", scenario, "a scenario").names_shipped_file("scenarios", ".json");
  line.option("--data", data, "a folder").names_folder();
  line.option("--any", any, "any file");

  const auto told = described(line);
  const auto argument = option_of(told, "FILE");
  EXPECT_THAT(argument.names, IsEmpty());
  EXPECT_EQ(argument.files.kind, ValueFiles::Kind::kFile);
  EXPECT_EQ(argument.files.extension, ".bhdl");
  EXPECT_EQ(option_of(told, "--scenario").files.shipped, "scenarios");
  EXPECT_EQ(option_of(told, "--data").files.kind, ValueFiles::Kind::kFolder);
  EXPECT_EQ(option_of(told, "--any").files.kind, ValueFiles::Kind::kFile);
  EXPECT_EQ(option_of(told, "--any").files.extension, "");
}

TEST(DescribeCommandLine, TellsCommandsAndOneOfThemAlone) {
  CommandLine line("Programs.", "galilean programs");
  std::string monitor, a;
  line.option("--monitor", monitor, "which");
  line.share_options();
  line.require_command();
  auto compare = line.command("diff", "compare them");
  compare.option("A", a, "a file").required();
  compare.footer("It takes a while.");
  compare.describe_exit(1, "They differ.");

  const auto all = described(line);
  EXPECT_TRUE(all.requires_command);
  ASSERT_EQ(all.commands.size(), 1u);
  const auto one = described(line, {"diff"});
  for (const auto& told : {all.commands[0], one}) {
    EXPECT_EQ(told.name, "galilean programs diff");
    EXPECT_EQ(told.help, "compare them");
    EXPECT_THAT(told.footer, HasSubstr("It takes a while."));
    EXPECT_TRUE(told.takes_outer_options);
    EXPECT_EQ(told.exit_codes.at("1"), "They differ.");
    EXPECT_TRUE(option_of(told, "A").required);
  }
}

TEST(DescribeCommandLine, IsNotReadFromAnotherText) {
  for (const char* text : {"", "usage: program", "[]", "{\"name\":\"galilean\"}"})
    EXPECT_FALSE(description_from_json(text)) << text;
}

TEST(DescribeCommandLine, IsHiddenFromHelp) {
  CommandLine line("A program.", "program");
  EXPECT_THAT(printed(line, {"--help"}), Not(HasSubstr("describe")));
}

TEST(DescribeCommandLine, IsNoRequestBehindAWordThatIsNoCommand) {
  CommandLine line("A program.", "program");
  testing::internal::CaptureStderr();
  const char* arguments[] = {"program", "xyzzy", kDescribeCommandLine};
  EXPECT_EQ(line.parse(3, arguments), kWrongUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("xyzzy"));
}

}  // namespace
}  // namespace galilean
