// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/logs/comparing/diff.h"

#include <gmock/gmock.h>

#include "core/json_text.h"
#include "monitor/logs/comparing/verify.h"
#include "tests/monitor/logs/logged_team.h"

namespace galilean::logs {
namespace {

using testing::HasSubstr;

/// Three states of io; the second has this x, unless it is left out.
mcap::Bytes three_states(std::optional<double> second_x_m) {
  expect::RecordedTeam team;
  for (int i = 0; i < 3; ++i) {
    if (i == 1 && !second_x_m) continue;
    msg::RobotState state;
    state.robot = "io";
    state.x_m = i == 1 ? *second_x_m : 0;
    team.send(i, "/io/state", state);
  }
  return team.end();
}

class DiffTest : public LoggedTeam {
 protected:
  Answer diff(bool json = false) {
    return answer_of([&] { return print_difference({path("a.mcap"), path("b.mcap"), {}, json}); });
  }
};

TEST_F(DiffTest, EqualRecordingsDoNotDiffer) {
  write("a.mcap", three_states(1));
  write("b.mcap", three_states(1));
  EXPECT_EQ(diff().code, 0);
  EXPECT_EQ(diff().out, "no difference\n");
}

TEST_F(DiffTest, TellsTheFirstFieldThatDiffers) {
  write("a.mcap", three_states(1.5));
  write("b.mcap", three_states(2));
  const auto answer = diff();
  EXPECT_EQ(answer.code, 1);
  EXPECT_THAT(answer.out, HasSubstr("/io/state: 2 equal, 1 changed, 0 only in "));
  EXPECT_THAT(answer.out,
              HasSubstr("at 1.000 s (2023-11-14T22:13:21.000Z), /io/state: x_m is 1.5 in " +
                        path("a.mcap") + " and 2.0 in " + path("b.mcap") + "\n"));
}

TEST_F(DiffTest, TellsWhatIsMissing) {
  write("a.mcap", six_seconds());
  write("b.mcap", three_states({}));
  const auto json = read_json(diff(true).out).value();
  EXPECT_EQ(json["differ"], true);
  EXPECT_THAT(json["channels"].dump(), HasSubstr("/io/variables is in "));
  EXPECT_EQ(json["topics"]["/io/variables"]["only_first"], 60);
  EXPECT_EQ(json["messages"].size(), 10U);
}

TEST_F(DiffTest, WhatCannotBeComparedIsToldApart) {
  write("a.mcap", three_states(1));
  EXPECT_EQ(diff().code, 2);
  auto bytes = three_states(1);
  expect::damage_chunk_at(1, bytes);
  write("a.mcap", bytes);
  write("b.mcap", bytes);
  EXPECT_EQ(diff().code, 3);
}

class VerifyTest : public LoggedTeam {
 protected:
  Answer verify(const std::vector<std::string>& names, bool json = false) {
    VerifyOptions options{{}, json};
    for (const auto& name : names) options.files.push_back(path(name));
    return answer_of([&] { return verify_recordings(options); });
  }
};

TEST_F(VerifyTest, AWholeRecordingIsWhole) {
  write("a.mcap", six_seconds());
  const auto answer = verify({"a.mcap"});
  EXPECT_EQ(answer.code, 0) << answer.out;
  EXPECT_EQ(answer.out,
            path("a.mcap") + ": whole, 120 messages of 2 channels, every checksum compared\n");
}

TEST_F(VerifyTest, NoByteOfAChunkMayChangeUnseen) {
  const auto whole = six_seconds();
  const auto summary = mcap::summarize(mcap::MemorySource(whole));
  const auto& block = summary.value().blocks[2];
  for (std::uint64_t at = block.offset; at < block.offset + block.bytes; at += 7) {
    auto bytes = whole;
    bytes[at] ^= 1;
    write("a.mcap", bytes);
    EXPECT_EQ(verify({"a.mcap"}).code, 3) << at - block.offset;
  }
}

TEST_F(VerifyTest, TellsOfMessagesThatAreNotWholeAndOfFilesThatAreNone) {
  expect::RecordedTeam team;
  team.send(0, "/io/state", msg::RobotState{});
  team.send(1, "/io/state", msg::Variables{});  // which is too short for a state
  write("a.mcap", team.end());
  write("b.mcap", six_seconds());
  EXPECT_EQ(verify({"a.mcap", "b.mcap"}).code, 3);
  EXPECT_THAT(verify({"a.mcap"}).out, HasSubstr("DAMAGED"));
  const auto answer = verify({"none.mcap", "b.mcap"}, true);
  EXPECT_EQ(answer.code, 1);
  const auto json = read_json(answer.out).value();
  EXPECT_TRUE(json[0]["whole"].is_null());
  EXPECT_EQ(json[1]["whole"], true);
}

}  // namespace
}  // namespace galilean::logs
