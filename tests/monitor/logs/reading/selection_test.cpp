// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/reading/selection.h"

#include <gmock/gmock.h>

#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

class SelectionTest : public LoggedTeam {
 protected:
  /// Returns how many messages of run.mcap are selected.
  std::size_t count(const Selection& selection) {
    const auto recording = Recording::open(path("run.mcap"));
    auto messages = SelectedMessages::of(recording.value(), selection);
    std::size_t count = 0;
    while (messages.value().next() != nullptr) ++count;
    return count;
  }
};

TEST_F(SelectionTest, TakesTopicsWithAndWithoutASlashAndTimesWithBothEnds) {
  write("run.mcap", six_seconds());
  EXPECT_EQ(count({}), 120U);
  EXPECT_EQ(count({.topics = {"io/state"}}), 60U);
  EXPECT_EQ(count({.topics = {"/io/state", "io/variables"}}), 120U);
  EXPECT_EQ(count({.topics = {"/io/state"}, .from_s = 0.95, .to_s = 2.05}), 11U);
  EXPECT_EQ(count({.from_s = 7}), 0U);
}

TEST_F(SelectionTest, SaysWhichTopicMayHaveBeenMeant) {
  write("run.mcap", six_seconds());
  const auto recording = Recording::open(path("run.mcap"));
  EXPECT_THAT(SelectedMessages::of(recording.value(), {.topics = {"io/stat"}}).error().message,
              HasSubstr("has no topic 'io/stat'; did you mean '/io/state'?"));
  EXPECT_THAT(SelectedMessages::of(recording.value(), {.topics = {"\x1b[2J"}}).error().message,
              HasSubstr("has no topic 'U+001B[2J'; it has /io/state, /io/variables"));
  EXPECT_THAT(recording.value().only_topic().error().message, HasSubstr("has several topics"));
}

TEST_F(SelectionTest, TellsWhatIsLeftOut) {
  auto bytes = six_seconds();
  expect::damage_chunk_at(2.5, bytes);
  write("run.mcap", bytes);
  const auto answer = answer_of([&] {
    const auto recording = Recording::open(path("run.mcap"));
    auto messages = SelectedMessages::of(recording.value(), {});
    while (messages.value().next() != nullptr) {
    }
    return tell_damage("galilean log x", messages.value());
  });
  EXPECT_EQ(answer.code, 3);
  EXPECT_THAT(answer.errors,
              HasSubstr("galilean log x: " + path("run.mcap") + ": damaged: the chunk"));
  EXPECT_THAT(answer.errors, HasSubstr("(/io/state 10, /io/variables 10)"));
}

TEST_F(SelectionTest, FilesThatAreNoneAreNamed) {
  write("empty.mcap", {});
  EXPECT_THAT(Recording::open(path("empty.mcap")).error().message,
              HasSubstr("empty.mcap is empty"));
  EXPECT_THAT(Recording::open(path("none.mcap")).error().message, HasSubstr("none.mcap"));
}

TEST_F(SelectionTest, WhatHoldsNothingIsSaid) {
  write("run.mcap", six_seconds());
  const auto said = [&](const Selection& selection) {
    const auto recording = Recording::open(path("run.mcap"));
    auto messages = SelectedMessages::of(recording.value(), selection);
    while (messages.value().next()) {
    }
    return answer_of([&] { return tell_nothing("cat", selection, messages.value()), 0; }).errors;
  };
  EXPECT_EQ(said({.from_s = 60}),
            "cat: there is no message from 60 s on; " + path("run.mcap") + " ends at 5.9 s\n");
  EXPECT_EQ(said({.topics = {"io/state"}, .from_s = 1.01, .to_s = 1.02}),
            "cat: there is no message of io/state from 1.01 s on up to 1.02 s\n");
  EXPECT_EQ(said({.from_s = 5}), "");
  EXPECT_EQ(said({}), "");
}

}  // namespace
}  // namespace galilean::logs
