// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/printing/cat.h"

#include <gmock/gmock.h>

#include <sstream>

#include "core/json_text.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

class LogCatTest : public LoggedTeam {
 protected:
  LogCatTest() { write("run.mcap", six_seconds()); }
  Answer cat(CatOptions options) {
    options.file = path("run.mcap");
    return answer_of([&] { return print_messages(options); });
  }
};

TEST_F(LogCatTest, PrintsMessagesAsText) {
  const auto answer = cat({.selection = {.topics = {"/io/state"}, .from_s = 3}, .count = 2});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  EXPECT_THAT(answer.out,
              testing::StartsWith("3.000 2023-11-14T22:13:23.000Z /io/state\nstamp:\n"));
  EXPECT_THAT(answer.out, HasSubstr("\nstate: \"stuck\"\n"));
  EXPECT_THAT(answer.out, HasSubstr("\n---\n3.100 2023-"));
  EXPECT_TRUE(answer.out.ends_with("---\n"));
}

TEST_F(LogCatTest, PrintsOneFieldALine) {
  const auto answer =
      cat({.selection = {.topics = {"io/state"}, .from_s = 0.25, .to_s = 0.45}, .field = "x_m"});
  EXPECT_THAT(answer.out, testing::MatchesRegex("0.300 [^ ]* /io/state 0.3[0-9]*\n"
                                                "0.400 [^ ]* /io/state 0.4\n"));
}

TEST_F(LogCatTest, PrintsJsonLines) {
  const auto answer = cat({.selection = {.from_s = 5.85}, .json = true});
  std::istringstream lines(answer.out);
  std::vector<nlohmann::json> messages;
  for (std::string line; std::getline(lines, line);)
    messages.push_back(read_untrusted_json(line).value());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0]["topic"], "/io/state");
  EXPECT_EQ(messages[0]["log_ns"], "1700000005900000000");
  EXPECT_EQ(messages[0]["sequence"], 60);
  EXPECT_EQ(messages[0]["message"]["tick"], 59);
  EXPECT_EQ(messages[1]["message"]["items"][1]["name"], "v,1");
}

TEST_F(LogCatTest, SaysWhichFieldsThereAre) {
  const auto answer = cat({.selection = {.topics = {"io/state"}}, .field = "x"});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("in messages of /io/state the message has no field 'x'"));
}

TEST_F(LogCatTest, CountsWhatCannotBeDecoded) {
  expect::RecordedTeam team;
  msg::RobotState state;
  state.robot = "io";
  team.send(0, "/io/state", state);
  team.send(0.1, "/io/state", msg::Variables{});
  write("run.mcap", team.end());
  const auto answer = cat({.json = true});
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.out, HasSubstr("\"message\":null"));
  EXPECT_THAT(answer.errors, HasSubstr("1 message of /io/state could not be decoded: a message is "
                                       "not a whole"));
}

}  // namespace
}  // namespace galilean::logs
