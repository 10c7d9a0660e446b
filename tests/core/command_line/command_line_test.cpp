// SPDX-License-Identifier: BSD-3-Clause
#include "core/command_line/command_line.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "core/command_line/domain_option.h"
#include "core/secure_folder.h"

namespace galilean {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What came of reading arguments: the exit code, and what was printed.
struct Reading {
  std::optional<int> code;
  std::string out, errors;
};

Reading read(CommandLine& line, std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "program");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Reading reading;
  reading.code = line.parse(static_cast<int>(arguments.size()), arguments.data());
  reading.out = testing::internal::GetCapturedStdout();
  reading.errors = testing::internal::GetCapturedStderr();
  return reading;
}

TEST(CommandLine, WritesWhatIsGivenAndLeavesTheRest) {
  CommandLine line("A program.", "program");
  std::string file;
  int robots = 3;
  double rate_hz = 20;
  std::optional<double> duration_s;
  std::vector<std::string> names;
  bool as_json = false, quiet = false;
  line.option("file", file, "a file");
  line.option("--robots", robots, "how many");
  line.option("--rate", rate_hz, "ticks a second");
  line.option("--duration", duration_s, "seconds");
  line.option("--name", names, "names").divided_by(',');
  line.flag("--json", as_json, "as JSON");
  line.flag("--quiet", quiet, "say nothing");

  EXPECT_EQ(read(line, {"a.bhdl", "--robots", "5", "--name", "io,callisto", "--json"}).code,
            std::nullopt);
  EXPECT_EQ(file, "a.bhdl");
  EXPECT_EQ(robots, 5);
  EXPECT_EQ(rate_hz, 20);
  EXPECT_EQ(duration_s, std::nullopt);
  EXPECT_THAT(names, ElementsAre("io", "callisto"));
  EXPECT_TRUE(as_json);
  EXPECT_FALSE(quiet);
}

TEST(CommandLine, AnEmptyTextIsNotTakenForAnOptionThatIsNotGiven) {
  for (const char* option : {"--on", "--out", "--bhdl", "--folder", "--path", "--files"}) {
    CommandLine line("A program.", "program");
    std::string on, out, bhdl, folder;
    std::filesystem::path path;
    std::vector<std::string> files;
    line.option("--on", on, "a condition").not_empty();
    line.option("--out", out, "a file").names_file(".mcap");
    line.option("--bhdl", bhdl, "a program").names_shipped_file("programs", ".bhdl");
    line.option("--folder", folder, "a folder").names_folder();
    line.option("--path", path, "a file");
    line.option("--files", files, "files").names_file();
    const auto reading = read(line, {option, ""});
    EXPECT_EQ(reading.code, kWrongUsage) << option;
    EXPECT_THAT(reading.errors, HasSubstr(std::string(option) + ": the value is empty"));
    EXPECT_EQ(read(line, {"--on", "x", "--files", "a", "b"}).code, std::nullopt);
  }
}

TEST(CommandLine, HelpIsPrintedAndEndsWell) {
  CommandLine line("Runs robots.", "runner");
  int robots = 3;
  line.option("--robots", robots, "how many").between(1, 16).show_default();
  const auto reading = read(line, {"--help"});
  EXPECT_EQ(reading.code, 0);
  EXPECT_THAT(reading.out, HasSubstr("Runs robots."));
  EXPECT_THAT(reading.out, HasSubstr("Usage: runner"));
  EXPECT_THAT(reading.out, HasSubstr("INT:from 1 to 16=3"));
}

/// What is wrong with each of these arguments is said on stderr, and ends the program with a
/// failure.
TEST(CommandLine, RefusesWhatIsWrongAndSaysIt) {
  const auto refused = [](std::vector<const char*> arguments) {
    CommandLine line("A program.", "program");
    std::string file, format;
    int robots = 0;
    double timeout_s = 1, from_s = 0;
    bool team = false;
    line.option("file", file, "a file").required();
    line.option("--robots", robots, "how many").between(1, 16);
    line.option("--timeout", timeout_s, "seconds").positive();
    line.option("--from", from_s, "seconds").not_negative();
    line.option("--format", format, "which").one_of({"dot", "svg"});
    const auto everyone = line.flag("--team", team, "all");
    line.option("--robot", file, "one").excludes(everyone);
    line.option("--name", file, "a name").check([](const std::string& text) -> Result<void> {
      if (text == "io") return {};
      return Error{text + " is no moon"};
    });
    line.option(
        "--start",
        [](const std::string& text) -> Result<void> { return Error{text + " is no place"}; },
        "where");
    const auto reading = read(line, std::move(arguments));
    return reading.code == kWrongUsage ? reading.errors : "accepted";
  };
  EXPECT_THAT(refused({}), HasSubstr("file is required"));
  EXPECT_THAT(refused({"f", "--robots", "17"}),
              HasSubstr("--robots: the value must be from 1 to 16, and not '17'"));
  EXPECT_THAT(refused({"f", "--robots", "many"}), HasSubstr("--robots"));
  EXPECT_THAT(refused({"f", "--timeout", "0"}), HasSubstr("--timeout"));
  EXPECT_THAT(refused({"f", "--from", "-1"}), HasSubstr("--from"));
  for (const char* none : {"nan", "inf", "1e999", "", "3 s"}) {
    EXPECT_THAT(refused({"f", "--timeout", none}), HasSubstr("--timeout: ")) << none;
    EXPECT_THAT(refused({"f", "--from", none}), HasSubstr("--from: ")) << none;
  }
  EXPECT_THAT(refused({"f", "--format", "pdf"}), HasSubstr("pdf not in {dot,svg}"));
  EXPECT_THAT(refused({"f", "--team", "--robot", "io"}), HasSubstr("excludes"));
  EXPECT_THAT(refused({"f", "--name", "sun"}), HasSubstr("sun is no moon"));
  EXPECT_THAT(refused({"f", "--start", "there"}), HasSubstr("--start: there is no place"));
  EXPECT_THAT(refused({"f", "--unheard-of"}), HasSubstr("--unheard-of"));
  EXPECT_EQ(refused({"f", "--name", "io"}), "accepted");
}

TEST(CommandLine, EachTextOfARepeatedOptionIsRead) {
  CommandLine line("A program.", "program");
  std::vector<std::string> texts;
  line.options(
      "--start",
      [&texts](const std::string& text) -> Result<void> {
        texts.push_back(text);
        return {};
      },
      "where");
  EXPECT_EQ(read(line, {"--start", "a", "b", "--start", "c"}).code, std::nullopt);
  EXPECT_THAT(texts, ElementsAre("a", "b", "c"));
}

TEST(CommandLine, OneCommandIsChosen) {
  CommandLine line("A program.", "program");
  line.require_command();
  const auto list = line.command("list", "what there is");
  auto show = line.command("show", "one of them");
  std::string hash;
  show.option("hash", hash, "which").required();
  EXPECT_EQ(read(line, {"show", "0123"}).code, std::nullopt);
  EXPECT_TRUE(show.chosen());
  EXPECT_FALSE(list.chosen());
  EXPECT_EQ(hash, "0123");
  EXPECT_EQ(read(line, {}).code, kWrongUsage);
}

TEST(CommandLine, SaysWhatMayHaveBeenMeant) {
  const auto told = [](std::vector<const char*> arguments) {
    CommandLine line("Describes recordings.", "galilean log");
    line.require_command();
    line.share_options();
    int port = 0;
    line.option("-p,--port", port, "a port");
    auto info = line.command("info", "describe a recording");
    line.command("check", "check a recording");
    std::string file;
    info.option("file", file, "a recording").required();
    info.flag("--json", "as JSON");
    return read(line, std::move(arguments)).errors;
  };
  EXPECT_EQ(told({"inof", "a.mcap"}),
            "galilean log: there is no command 'inof'; did you mean 'info'?\n"
            "'galilean log --help' lists what there is.\n");
  EXPECT_EQ(told({"info", "--josn", "a.mcap"}),
            "galilean log info: there is no option '--josn'; did you mean '--json'?\n"
            "'galilean log info --help' lists what there is.\n");
  EXPECT_THAT(told({"info", "--josn"}), HasSubstr("did you mean '--json'?"));
  EXPECT_THAT(told({"info", "a.mcap", "--prot=80"}), HasSubstr("'--prot'; did you mean '--port'?"));
  EXPECT_THAT(told({"--prot", "80", "chekc"}), HasSubstr("'--prot'; did you mean '--port'?"));
  EXPECT_THAT(told({"info", "a.mcap", "--hepl"}), HasSubstr("did you mean '--help'?"));
  EXPECT_THAT(told({"che"}), HasSubstr("did you mean 'check'?"));
  EXPECT_THAT(told({"xyzzy"}), HasSubstr("there is no command 'xyzzy'\n"));
  EXPECT_THAT(told({"info", "a", "-x"}), HasSubstr("there is no option '-x'\n"));
  EXPECT_THAT(told({"info", "a", "b"}), HasSubstr("'b' is one word too many\n"));
  EXPECT_THAT(told({"info"}), HasSubstr("file is required"));
}

TEST(CommandLine, ADomainIsOneThatPortsAllow) {
  CommandLine line("A program.", "program");
  int domain = -1;
  add_domain_option(line, domain);
  EXPECT_EQ(read(line, {}).code, std::nullopt);
  EXPECT_EQ(domain, -1);
  EXPECT_EQ(read(line, {"--domain", "232"}).code, std::nullopt);
  EXPECT_EQ(domain, 232);
  EXPECT_THAT(read(line, {"--domain", "233"}).errors, HasSubstr("--domain"));
}

TEST(CommandLine, KeysOfDdsSecurityAreNamedForThisProcessAndThoseThatItStarts) {
  CommandLine line("A program.", "program");
  int domain = -1;
  add_domain_option(line, domain);
  unsetenv(kSecureVariable);
  EXPECT_EQ(read(line, {}).code, std::nullopt);
  EXPECT_EQ(std::getenv(kSecureVariable), nullptr);
  EXPECT_EQ(read(line, {"--secure", "."}).code, std::nullopt);
  const char* folder = std::getenv(kSecureVariable);
  ASSERT_NE(folder, nullptr);
  EXPECT_EQ(folder[0], '/');
  unsetenv(kSecureVariable);
  EXPECT_THAT(read(line, {"--secure", "none/at/all"}).errors, HasSubstr("is no folder"));
  EXPECT_EQ(std::getenv(kSecureVariable), nullptr);
}

TEST(CommandLine, TellsWhetherAnOptionWasGiven) {
  CommandLine line("A program.", "program");
  std::string file;
  const auto watch = line.option("--watch", file, "a file").takes(0, 1);
  EXPECT_EQ(read(line, {}).code, std::nullopt);
  EXPECT_FALSE(watch.given());
  EXPECT_EQ(read(line, {"--watch"}).code, std::nullopt);
  EXPECT_TRUE(watch.given());
}

}  // namespace
}  // namespace galilean
