// SPDX-License-Identifier: BSD-3-Clause
// `galilean log check` as a user or a CI server calls it.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/monitor/expect/recording/recorded_team.h"
#include "tests/temporary_folder.h"

namespace galilean::expect {
namespace {

using testing::HasSubstr;

struct Answer {
  int code = -1;
  std::string text;  ///< of both outputs
};

class LogCheckTest : public testing::Test {
 protected:
  LogCheckTest() {
    RecordedTeam team;
    msg::RobotState state;
    state.robot = "io";
    for (int i = 0; i < 60; ++i) {
      ++state.tick;
      state.state = i < 30 ? "wander" : "stuck";
      team.send(0.1 * i, "/io/state", state);
    }
    const auto& bytes = team.end();
    write("run.mcap", {bytes.begin(), bytes.end()});
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) {
    std::ifstream file(folder_.path() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Judges run.mcap by the text.
  Answer check(const std::string& text, const std::string& options = "") {
    write("a.expect", text);
    return run("run.mcap --expect a.expect " + options);
  }
  Answer run(const std::string& arguments) {
    const std::string command =
        "cd '" + folder_.path().string() + "' && '" GALILEAN_LOG_CHECK "' 2>&1 " + arguments;
    Answer answer;
    FILE* output = popen(command.c_str(), "r");
    for (int letter; (letter = std::fgetc(output)) != EOF;)
      answer.text += static_cast<char>(letter);
    answer.code = WEXITSTATUS(pclose(output));
    return answer;
  }

  TemporaryFolder folder_;
};

TEST_F(LogCheckTest, EndsWithZeroIfAllHolds) {
  const auto answer = check("io: never state is \"stuck\" for 10 s\n");
  EXPECT_EQ(answer.code, 0) << answer.text;
  EXPECT_THAT(answer.text,
              HasSubstr("ok     io: never state is \"stuck\" for 10 s (7.1 s to spare)"));
}

TEST_F(LogCheckTest, EndsWithOneIfSomethingFails) {
  const auto answer = check("io: never state is \"stuck\" for 2 s\neuropa: always it is healthy\n",
                            "--junit o.xml");
  EXPECT_EQ(answer.code, 1) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("galilean replay run.mcap --from 3.000"));
  EXPECT_THAT(read("o.xml"), HasSubstr("tests=\"2\" failures=\"1\" errors=\"1\""));
}

TEST_F(LogCheckTest, EndsWithThreeIfTheRecordingCannotTell) {
  const auto answer = check("europa: always it is healthy\n", "--format json");
  EXPECT_EQ(answer.code, 3) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("\"reason\": \"europa was never heard\""));
}

TEST_F(LogCheckTest, AReportNeverGoesOverWhatIsRead) {
  const std::string text = "io: always it is healthy\n";
  const auto recording = read("run.mcap");
  std::filesystem::create_symlink("run.mcap", folder_.path() / "link.xml");
  std::filesystem::create_hard_link(folder_.path() / "run.mcap", folder_.path() / "twin.xml");
  for (const char* junit : {"run.mcap", "./run.mcap", "link.xml", "twin.xml", "a.expect"}) {
    const auto answer = check(text, "--junit " + std::string(junit));
    EXPECT_EQ(answer.code, 1) << junit;
    EXPECT_THAT(answer.text, HasSubstr(std::string(junit) + " is read here and cannot be written"));
  }
  EXPECT_EQ(read("run.mcap"), recording);
  EXPECT_EQ(read("a.expect"), text);
}

TEST_F(LogCheckTest, AReportOfARunThatIsKilledIsNoOlderOne) {
  write("a.expect", "io: always it is healthy\n");
  write("o.xml", "an older report");
  const std::string script =
      "cd '" + folder_.path().string() +
      "' && { '" GALILEAN_LOG_CHECK
      "' --live --for 900s --expect a.expect --junit o.xml >/dev/null 2>&1 & p=$!;"
      " for i in $(seq 600); do grep -q 'come to its end' o.xml && break; sleep 0.1; done;"
      " kill -9 $p; wait $p; } 2>/dev/null";
  (void)std::system(script.c_str());
  EXPECT_THAT(read("o.xml"), HasSubstr("<error message=\"the run has not come to its end\""));
}

TEST_F(LogCheckTest, AReportThatTheDiskDoesNotTakeIsNotLeftThere) {
  write("a.expect", "io: always it is healthy\n");
  const std::string script = "cd '" + folder_.path().string() +
                             "' && ulimit -f 0 && '" GALILEAN_LOG_CHECK
                             "' run.mcap --expect a.expect --junit o.xml >/dev/null 2>&1";
  EXPECT_EQ(WEXITSTATUS(std::system(script.c_str())), 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "o.xml"));
}

TEST_F(LogCheckTest, EveryFormatIsPrinted) {
  const std::string text = "io: never state is \"stuck\" for 2 s\n";
  EXPECT_THAT(check(text, "--format tap").text,
              testing::StartsWith("TAP version 13\n1..1\nnot ok"));
  EXPECT_THAT(check(text, "--format github").text, testing::StartsWith("::error file=a.expect,"));
  EXPECT_THAT(check(text, "--format junit").text, testing::StartsWith("<?xml"));
}

TEST_F(LogCheckTest, MistakesAreToldWithTheirPlaces) {
  const auto answer = check("io: nevr state is \"a\"\nio: always x < 3 s\n");
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.text, HasSubstr("a.expect:1:5: error: expected a claim, not 'nevr'"));
  EXPECT_THAT(answer.text, HasSubstr("a.expect:2:18: error: 's' is a unit of time"));
}

TEST_F(LogCheckTest, EveryFormatTellsMistakesWithTheirPlaces) {
  const std::string text = "io: always it is healthy\nio: nevr it is held\n";
  const auto said = [&](const std::string& format) {
    const auto answer = check(text, "--junit o.xml --format " + format + " 2>errors");
    EXPECT_EQ(answer.code, 1) << format;
    EXPECT_THAT(read("errors"), HasSubstr("a.expect:2:5: error: expected a claim, not 'nevr'"));
    const auto xml = read("o.xml");
    EXPECT_THAT(xml, HasSubstr("tests=\"1\" failures=\"0\" errors=\"1\""));
    EXPECT_THAT(xml, HasSubstr("file=\"a.expect\" line=\"2\""));
    EXPECT_THAT(xml, HasSubstr(">a.expect:2:5: expected a claim, not 'nevr'; did you mean"));
    std::filesystem::remove(folder_.path() / "o.xml");
    return answer.text;
  };
  EXPECT_THAT(said("github"),
              testing::StartsWith("::error file=a.expect,line=2,col=5::expected a claim, not"));
  EXPECT_THAT(said("tap"),
              testing::StartsWith("TAP version 13\n1..1\nnot ok 1 - a.expect:2:5: expected"));
  EXPECT_THAT(said("junit"), HasSubstr("<error message=\"expected a claim, not 'nevr'"));
  EXPECT_THAT(said("json"), testing::AllOf(HasSubstr("\"line\": 2"), HasSubstr("\"column\": 5"),
                                           HasSubstr("\"file\": \"a.expect\"")));
  EXPECT_EQ(said("text"), "");
}

TEST_F(LogCheckTest, EveryFormatTellsThatNothingCouldBeJudged) {
  write("a.expect", "io: always it is healthy\n");
  const auto said = [&](const std::string& format) {
    const auto answer =
        run("none.mcap --expect a.expect --junit o.xml --format " + format + " 2>/dev/null");
    EXPECT_EQ(answer.code, 1) << format;
    EXPECT_THAT(read("o.xml"), HasSubstr("<error message=\"none.mcap"));
    std::filesystem::remove(folder_.path() / "o.xml");
    return answer.text;
  };
  EXPECT_THAT(said("github"), testing::StartsWith("::error::none.mcap"));
  EXPECT_THAT(said("tap"), HasSubstr("not ok 1 - nothing was judged: none.mcap"));
  EXPECT_THAT(said("junit"), HasSubstr("errors=\"1\""));
  EXPECT_THAT(said("json"), HasSubstr("\"error\": \"none.mcap"));
}

TEST_F(LogCheckTest, WhatWentWrongInTheRunIsReportedBesideTheExpectations) {
  const std::string text = "io: never state is \"stuck\" for 10 s\n";
  const auto said = [&](const std::string& format) {
    const auto answer = check(text, "--problem 'europa ended' --junit o.xml --format " + format);
    EXPECT_EQ(answer.code, 1) << format;
    return answer.text;
  };
  EXPECT_THAT(said("text"), HasSubstr("ERROR  the run: europa ended\n"));
  EXPECT_THAT(said("tap"), testing::AllOf(HasSubstr("1..2\nok 1 - io: never"),
                                          HasSubstr("\nnot ok 2 - the run: europa ended\n")));
  EXPECT_THAT(said("github"), HasSubstr("::error::europa ended\n"));
  EXPECT_THAT(said("json"), HasSubstr("\"europa ended\""));
  EXPECT_THAT(said("junit"), HasSubstr("tests=\"2\" failures=\"0\" errors=\"1\""));
  EXPECT_THAT(read("o.xml"), HasSubstr("name=\"the run\">\n      <error message=\"europa ended\""));
}

TEST_F(LogCheckTest, FilesThatAreNoneGetASentence) {
  write("a.expect", "io: always it is healthy\n");
  write("empty.mcap", "");
  EXPECT_THAT(run("empty.mcap --expect a.expect").text, HasSubstr("empty.mcap is empty"));
  EXPECT_EQ(run("empty.mcap --expect a.expect").code, 1);
  EXPECT_EQ(run("none.mcap --expect a.expect").code, 1);
  EXPECT_EQ(run("run.mcap --expect none.expect").code, 1);
  EXPECT_EQ(run("run.mcap --expect .").code, 1);
  EXPECT_EQ(run("run.mcap --expect a.expect --junit none/o.xml").code, 1);
  EXPECT_EQ(run("run.mcap --expect a.expect --silence nan").code, 2);
  EXPECT_EQ(run("run.mcap").code, 2);
  EXPECT_EQ(run("--expect a.expect").code, 2);
  EXPECT_EQ(run("run.mcap --live --expect a.expect").code, 2);
  EXPECT_EQ(run("run.mcap --for 5s --expect a.expect").code, 2);
  EXPECT_EQ(run("--live --for 5x --expect a.expect").code, 2);
}

TEST_F(LogCheckTest, ADamagedRecordingIsNotCountedAsHolding) {
  const auto text = read("run.mcap");
  mcap::Bytes bytes(text.begin(), text.end());
  damage_chunk_at(2.5, bytes);
  write("run.mcap", {bytes.begin(), bytes.end()});
  const auto answer = check("io: never state is \"grab\"\n");
  EXPECT_EQ(answer.code, 3) << answer.text;
  EXPECT_THAT(answer.text, HasSubstr("cannot tell: messages of that time are missing"));
  EXPECT_THAT(answer.text, HasSubstr("note:  damaged: the chunk at byte "));
}

}  // namespace
}  // namespace galilean::expect
