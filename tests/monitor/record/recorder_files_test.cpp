// SPDX-License-Identifier: BSD-3-Clause
// How a recording goes on in other files, and what it does while the disk is nearly full.
#include <gmock/gmock.h>

#include <algorithm>

#include "monitor/record/recorder.h"
#include "monitor/record/told_losses.h"
#include "tests/monitor/record/recorder_fixture.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using wire::Delivery;
using wire::Foreign;

class RecorderFilesTest : public RecorderTest {
 protected:
  [[nodiscard]] std::uint64_t messages_in(const std::string& name) const {
    const auto summary = summary_of(name);
    EXPECT_FALSE(summary.recovered()) << name;
    return summary.statistics.messages;
  }
  static FilePlan split_each_second() {
    FilePlan plan;
    plan.split_span = kLookEach;
    return plan;
  }
};

TEST_F(RecorderFilesTest, GoesOnInAnotherFileThatCanBeReadAlone) {
  auto state = talk(Foreign::kCells, "rt/state");
  auto flow = talk(Foreign::kLarge, "rt/flow", Delivery::kFlow);
  ASSERT_TRUE(state.write());
  start({}, split_each_second());
  ASSERT_TRUE(comes_to_be_heard(flow));
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(2));
  look();
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(4));
  ASSERT_TRUE(recorder->conclude());
  EXPECT_EQ(messages_in("run_0.mcap"), 2U);
  EXPECT_EQ(messages_in("run_1.mcap"), 2U);  // of which the first is the state again
  EXPECT_EQ(summary_of("run_1.mcap").channels.at(1).topic, "/state");
  EXPECT_EQ(summary_of("run_1.mcap").schemas.size(), 2U);
}

TEST_F(RecorderFilesTest, WhatAWriterKeptThatHasLeftIsNotTakenOver) {
  std::optional<wire::ForeignTalk> state = talk(Foreign::kCells, "rt/state");
  ASSERT_TRUE(state->write());
  start({}, split_each_second());
  ASSERT_TRUE(comes_to_record(1));
  state.reset();
  wire::Endpoints endpoints(*own);
  ASSERT_TRUE(wire::wait_until([&] {
    return std::ranges::none_of(
        endpoints.known(), [](const auto& end) { return end.writes && end.topic == "rt/state"; });
  }));
  look();
  EXPECT_EQ(files->totals().files, 2U);
  EXPECT_EQ(files->writer().statistics().messages, 0U);
}

TEST_F(RecorderFilesTest, StandsStillWhileTheDiskIsNearlyFullAndGoesOn) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start();
  ASSERT_TRUE(comes_to_be_heard(flow));
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(1));

  free = kLeastRoom - 1;
  look();
  EXPECT_THAT(warnings, HasSubstr("nothing is recorded until there is room again"));
  EXPECT_FALSE(files->is_open());
  EXPECT_EQ(messages_in("run.mcap"), 1U);
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(wire::wait_until(
      [&] { return pump(), total_missing(recorder->recordings().losses()) == 1; }));

  free = 2 * kLeastRoom;
  look();
  EXPECT_THAT(warnings, HasSubstr("the recording goes on"));
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(2));
  ASSERT_TRUE(recorder->conclude());
  EXPECT_EQ(messages_in("run_1.mcap"), 1U);
  const auto source = mcap::FileSource::open(folder / "run_1.mcap");
  const auto told = told_losses(source.value(), summary_of("run_1.mcap"));
  ASSERT_TRUE(told.has_value());
  ASSERT_EQ(told->writers.size(), 1U);
  EXPECT_EQ(told->writers.front().unwritten, 1U);
  EXPECT_EQ(told->writers.front().recorded, 1U);  // the other stands in the file before
}

TEST_F(RecorderFilesTest, AFileThatNoOtherFollowsTellsWhatWasNotWrittenSince) {
  auto flow = talk(Foreign::kCells, "rt/flow", Delivery::kFlow);
  start();
  ASSERT_TRUE(comes_to_be_heard(flow));
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(comes_to_record(1));
  free = kLeastRoom - 1;
  look();
  ASSERT_TRUE(flow.write());
  ASSERT_TRUE(wire::wait_until(
      [&] { return pump(), total_missing(recorder->recordings().losses()) == 1; }));
  ASSERT_TRUE(recorder->conclude());
  EXPECT_EQ(messages_in("run.mcap"), 1U);
  const auto source = mcap::FileSource::open(folder / "run.mcap");
  const auto told = told_losses(source.value(), summary_of("run.mcap"));
  ASSERT_TRUE(told.has_value());
  ASSERT_EQ(told->writers.size(), 1U);
  EXPECT_EQ(told->writers.front().unwritten, 1U);
  EXPECT_EQ(told->writers.front().recorded, 1U);
}

TEST_F(RecorderFilesTest, NoticesWithinASecondThatItsFileWasDeleted) {
  start();
  pump();
  std::filesystem::remove(folder / "run.mcap");
  clock.advance(kLookEach);
  const auto done = recorder->pump();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("run.mcap was deleted"));
  EXPECT_TRUE(files->is_lost());
}

TEST_F(RecorderFilesTest, NoticesAtItsEndThatItsFileWasEmptied) {
  start();
  pump();
  std::filesystem::resize_file(folder / "run.mcap", 0);
  const auto done = recorder->conclude();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("run.mcap was emptied"));
}

TEST_F(RecorderFilesTest, GoesOnInAFileThatIsCalledOtherwiseAndSaysSo) {
  start();
  pump();
  std::filesystem::rename(folder / "run.mcap", folder / "kept.mcap");
  look();
  EXPECT_THAT(warnings, HasSubstr("run.mcap is no longer there"));
  ASSERT_TRUE(recorder->conclude());
  EXPECT_FALSE(summary_of("kept.mcap").recovered());
}

TEST_F(RecorderFilesTest, EndsAnEmptyFileThatNobodySentAnythingFor) {
  start();
  pump();
  EXPECT_EQ(recorded().statistics.messages, 0U);
  EXPECT_EQ(recorder->recordings().topics(), 0U);
}

}  // namespace
}  // namespace galilean::monitor
