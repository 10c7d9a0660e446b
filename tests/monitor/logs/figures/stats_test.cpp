// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/figures/stats.h"

#include <gmock/gmock.h>

#include "core/json_text.h"
#include "monitor/logs/figures/number_statistics.h"
#include "monitor/logs/figures/topic_statistics.h"
#include "monitor/record/losses.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

class StatsTest : public LoggedTeam {
 protected:
  StatsTest() { write("run.mcap", six_seconds()); }
  Answer stats(StatsOptions options) {
    options.file = path("run.mcap");
    return answer_of([&] { return print_statistics(options); });
  }
};

TEST_F(StatsTest, TellsHowATopicsMessagesCome) {
  const auto answer = stats({.json = true});
  EXPECT_EQ(answer.code, 0) << answer.errors;
  const auto json = read_json(answer.out).value();
  const auto& state = json["topics"]["/io/state"];
  EXPECT_EQ(state["messages"], 60);
  EXPECT_NEAR(state["rate_hz"].get<double>(), 10, 1e-6);
  EXPECT_NEAR(state["gap_s"]["most"].get<double>(), 0.1, 1e-6);
  EXPECT_EQ(state["missing"], 0);
  EXPECT_EQ(state["delay_s"]["most"], 0.0);
}

TEST_F(StatsTest, WhatIsLostByDamageIsMissing) {
  for (const bool was_counted : {false, true}) {
    expect::RecordedTeam team;
    for (int i = 0; i < 60; ++i) team.send(0.1 * i, "/io/state", msg::RobotState{});
    if (was_counted) {
      ASSERT_TRUE(monitor::LossLog(team.writer())
                      .conclude({{.topic = "/io/state", .writer = "a", .unwritten = 2}}));
    }
    auto bytes = team.end();
    expect::damage_chunk_at(2.5, bytes);
    write("run.mcap", bytes);
    const auto answer = stats({.json = true});
    EXPECT_EQ(answer.code, 3);
    EXPECT_EQ(read_json(answer.out).value()["topics"]["/io/state"]["missing"],
              was_counted ? 12 : 10);
  }
}

TEST_F(StatsTest, TellsWhatFieldsWere) {
  const auto answer =
      stats({.selection = {.topics = {"io/state"}}, .fields = {"x_m", "state"}, .json = true});
  const auto json = read_json(answer.out).value();
  const auto& x = json["fields"]["x_m"];
  EXPECT_EQ(x["numbers"], 60);
  EXPECT_NEAR(x["mean"].get<double>(), 2.95, 1e-9);
  EXPECT_NEAR(x["most"].get<double>(), 5.9, 1e-9);
  EXPECT_NEAR(x["most_at_s"].get<double>(), 5.9, 1e-9);
  EXPECT_EQ(json["fields"]["state"]["texts"]["wander"], 30);
}

TEST(NumberStatistics, TakeTheLargestNumbers) {
  NumberStatistics statistics;
  for (const double number : {-1e308, 1e308}) statistics.add(number);
  EXPECT_EQ(statistics.mean(), 0);
  EXPECT_NEAR(statistics.deviation() / 1e308, 1, 1e-9);
}

TEST_F(StatsTest, PrintsATable) {
  const auto answer = stats({});
  EXPECT_THAT(answer.out, testing::StartsWith("topic          messages  Hz  "));
  EXPECT_THAT(answer.out, HasSubstr("\n/io/state            60  10  "));
}

TEST_F(StatsTest, FieldsNeedATopic) {
  const auto answer = stats({.fields = {"x_m"}});
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.errors, HasSubstr("has several topics"));
}

TEST(TopicStatistics, CountsNumbersThatAreMissing) {
  TopicStatistics statistics;
  const std::uint8_t byte = 0;
  for (const std::uint32_t number : {5, 6, 9, 10})
    statistics.add({.channel_id = 1,
                    .sequence = number,
                    .log_ns = 3000,
                    .publish_ns = 1000,
                    .data = {&byte, 1}},
                   0.1 * number);
  const auto figures = statistics.figures();
  EXPECT_EQ(figures["missing"], 2);
  EXPECT_EQ(figures["bytes"], 4);
  EXPECT_NEAR(figures["delay_s"]["mean"].get<double>(), 2e-6, 1e-12);
}

TEST(TopicStatistics, CountWhatIsMissingOfEachWriterByItsOwnNumbers) {
  TopicStatistics of_two_channels, of_one;
  for (const std::uint32_t number : {1, 2, 4}) {
    of_two_channels.add({.channel_id = 1, .sequence = number}, number);
    of_two_channels.add({.channel_id = 2, .sequence = number + 100}, number);
    of_one.add({.channel_id = 1, .sequence = number}, number);
    of_one.add({.channel_id = 1, .sequence = number + 100}, number);
  }
  EXPECT_EQ(of_two_channels.figures()["missing"], 2);
  EXPECT_TRUE(of_one.figures()["missing"].is_null());
}

TEST(TopicStatistics, DoNotTellFromNumbersThatSkipWithoutALoss) {
  TopicStatistics statistics;
  for (const std::uint32_t number : {1, 9})
    statistics.add({.channel_id = 1, .sequence = number}, number, false);
  EXPECT_TRUE(statistics.figures()["missing"].is_null());
  statistics.set_missing(3);
  EXPECT_EQ(statistics.figures()["missing"], 3);
}

TEST(TopicStatistics, DoNotTellWhatOneMessageCannotTell) {
  TopicStatistics statistics;
  statistics.add({.channel_id = 1}, 3);
  const auto figures = statistics.figures();
  EXPECT_TRUE(figures["rate_hz"].is_null());
  EXPECT_TRUE(figures["gap_s"].is_null());
  EXPECT_TRUE(figures["missing"].is_null());
}

TEST(FieldStatistics, KeepBoundedMemoryForTexts) {
  FieldStatistics statistics;
  for (int i = 0; i < 1000; ++i) statistics.add(i, std::to_string(i));
  EXPECT_EQ(statistics.figures()["texts"].size(), 100U);
  EXPECT_EQ(statistics.figures()["other_texts"], 900);
}

}  // namespace
}  // namespace galilean::logs
