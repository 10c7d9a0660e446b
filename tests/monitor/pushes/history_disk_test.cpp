// SPDX-License-Identifier: BSD-3-Clause
// A disk that is full: the history goes on with its reserve, and says so.
#include <gmock/gmock.h>

#include "core/wire/ros_time.h"
#include "monitor/pushes/history/history.h"
#include "monitor/pushes/history/push_messages.h"
#include "tests/monitor/pushes/faulty_disk.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using Fate = FaultyDisk::Fate;

msg::ProgramPush small_push(const std::string& id) {
  msg::ProgramPush push;
  push.id = id;
  push.stamp = wire::ros_time(1);
  push.files = {{"main.bhdl", "text"}};
  push.hash = hash_of_files(push);
  return push;
}

class HistoryDiskTest : public testing::Test {
 protected:
  static constexpr std::uintmax_t kReserve = 64 << 10;

  [[nodiscard]] bool has_reserve() const {
    return std::filesystem::exists(folder / "history.reserve");
  }
  /// From now on the disk is full, but for the room of the reserve once that was given up.
  void fill_disk() {
    disk.decide_by(
        [this](std::int64_t /*write*/) { return has_reserve() ? Fate::kFull : Fate::kWritten; });
  }
  void break_disk() {
    disk.decide_by([](std::int64_t /*write*/) { return Fate::kFull; });
  }
  void mend_disk() {
    disk.decide_by([](std::int64_t /*write*/) { return Fate::kWritten; });
  }

  const TemporaryFolder folder;
  FaultyDisk disk{[](std::int64_t /*write*/) { return Fate::kWritten; }};
  const std::unique_ptr<History> history =
      History::open(folder / "history.sqlite", {.reserve_bytes = kReserve}).value();
};

TEST_F(HistoryDiskTest, KeepsRoomBackAndSaysThatAllIsWell) {
  EXPECT_EQ(std::filesystem::file_size(folder / "history.reserve"), kReserve);
  const auto found = history->check_disk();
  EXPECT_EQ(found.problem, "");
  EXPECT_TRUE(found.has_reserve);
  EXPECT_GT(found.available_bytes, 0U);
}

TEST_F(HistoryDiskTest, GoesOnWithItsReserveWhenTheDiskIsFull) {
  fill_disk();
  ASSERT_TRUE(history->add(small_push("1")));
  EXPECT_FALSE(has_reserve());
  EXPECT_TRUE(history->push("1").value());
  EXPECT_FALSE(history->verify().value().broken);
  ASSERT_TRUE(history->add(small_push("2")));
}

TEST_F(HistoryDiskTest, TellsThatNothingCanBeKeptAndGoesOnOnceItCan) {
  ASSERT_TRUE(history->add(small_push("1")));
  break_disk();
  const auto refused = history->add(small_push("2"));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("the history of pushes: "));
  EXPECT_THAT(history->check_disk().problem, HasSubstr("nothing can be kept"));
  EXPECT_TRUE(history->push("1").value()) << "it can still be read";
  mend_disk();
  const auto found = history->check_disk();
  EXPECT_EQ(found.problem, "");
  EXPECT_TRUE(found.has_reserve) << "the room is kept back again";
  EXPECT_TRUE(history->add(small_push("2")));
  EXPECT_FALSE(history->verify().value().broken) << "nothing of what was refused is half there";
}

TEST_F(HistoryDiskTest, WhatHasHappenedWaitsInItsOrderUntilTheDiskTakesIt) {
  ASSERT_TRUE(history->add(small_push("1")));
  ASSERT_EQ(history->not_kept(), "");
  break_disk();
  EXPECT_FALSE(history->add_reply("1", {.robot = "io", .status = ReplyStatus::kReceived}));
  EXPECT_FALSE(history->add_reply("1", {.robot = "io", .status = ReplyStatus::kRunning}));
  EXPECT_FALSE(history->set_progress("1", {.state = PushState::kDone}));
  EXPECT_FALSE(history->add_order({.id = "hold",
                                   .ordered_ns = 5,
                                   .author = "balch",
                                   .kind = "hold",
                                   .targets = {},
                                   .detail = {},
                                   .outcomes = {}}));
  EXPECT_FALSE(history->add_outcome("hold", {.of = "io", .outcome = "is held", .told_ns = 0}));
  EXPECT_FALSE(history->add(small_push("2"))) << "a push is refused meanwhile";
  EXPECT_NE(history->not_kept(), "");
  const auto failing = history->check_disk();
  EXPECT_EQ(failing.owed, 4U) << "the newer of two replies of a robot counts";
  EXPECT_THAT(failing.problem, HasSubstr("4 changes in memory wait for it"));
  EXPECT_EQ(history->push("1").value()->progress.state, PushState::kRunning);

  mend_disk();
  const auto mended = history->check_disk();
  EXPECT_EQ(mended.owed, 0U);
  EXPECT_EQ(mended.problem, "");
  EXPECT_EQ(history->not_kept(), "");
  const auto push = history->push("1").value();
  EXPECT_EQ(push->progress.state, PushState::kDone);
  ASSERT_EQ(push->replies.size(), 1U);
  EXPECT_EQ(push->replies[0].status, ReplyStatus::kRunning);
  const auto orders = history->orders(10).value();
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].outcomes.size(), 1U);
  EXPECT_FALSE(history->push("2").value()) << "it was refused, and is not pushed later";
  EXPECT_FALSE(history->verify().value().broken);
}

TEST_F(HistoryDiskTest, APushThatWasRefusedLeavesNothingBehind) {
  break_disk();
  ASSERT_FALSE(history->add(small_push("1")));
  EXPECT_TRUE(history->set_progress("1", {.state = PushState::kFailed}));
  EXPECT_NE(history->check_disk().problem, "") << "what changes nothing does not tell of the disk";
  mend_disk();
  EXPECT_EQ(history->check_disk().owed, 0U);
  EXPECT_FALSE(history->push("1").value());
  const auto verified = history->verify().value();
  EXPECT_FALSE(verified.broken) << in_words(verified);
  EXPECT_EQ(verified.rows, 0);
}

TEST_F(HistoryDiskTest, OfMoreChangesThanMayWaitTheOldestIsLostAndThatIsTold) {
  break_disk();
  for (std::size_t number = 0; number <= OwedChanges::kMost; ++number)
    EXPECT_FALSE(history->add_order({.id = std::to_string(number),
                                     .ordered_ns = 5,
                                     .author = "balch",
                                     .kind = "hold",
                                     .targets = {},
                                     .detail = {},
                                     .outcomes = {}}));
  EXPECT_THAT(history->check_disk().problem, HasSubstr("1 earlier change was lost"));
  mend_disk();
  const auto mended = history->check_disk();
  EXPECT_EQ(mended.owed, 0U);
  EXPECT_EQ(mended.lost, 1U);
  EXPECT_THAT(mended.problem, HasSubstr("1 earlier change was lost")) << "it is told for good";
  EXPECT_EQ(history->orders(2000).value().size(), OwedChanges::kMost);
}

TEST_F(HistoryDiskTest, ADiskThatFailsIsNoticedThoughNobodyPushes) {
  EXPECT_EQ(history->check_disk().problem, "");
  // A folder in its place can be written by nobody.
  std::filesystem::remove(folder / "history.probe");
  DiskProbe well(folder / "history.probe");
  EXPECT_TRUE(well.write());
  EXPECT_TRUE(well.write());
  EXPECT_EQ(std::filesystem::file_size(folder / "history.probe"), 512U) << "it does not grow";
  std::filesystem::create_directory(folder / "broken");
  DiskProbe broken(folder / "broken");
  const auto written = broken.write();
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("broken cannot be written"));
  DiskProbe full("/dev/full");
  EXPECT_FALSE(full.write());
}

TEST_F(HistoryDiskTest, ASecondMonitorDoesNotTakeTheHistoryOfTheFirst) {
  ASSERT_TRUE(history->add(small_push("1")));
  const auto second = History::open(folder / "history.sqlite", {.reserve_bytes = 0});
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("another monitor keeps its history in"));
  EXPECT_THAT(second.error().message, HasSubstr("--data DIR"));
  EXPECT_EQ(history->push("1").value()->progress.state, PushState::kRunning)
      << "it is not taken for an interrupted one";
}

TEST_F(HistoryDiskTest, AReserveForWhichThereIsNoRoomIsNoReserve) {
  DiskReserve none(folder / "no folder" / "reserve", kReserve);
  EXPECT_FALSE(none.take());
  EXPECT_FALSE(none.release());
  DiskReserve empty(folder / "empty", 0);
  EXPECT_TRUE(empty.take());
  EXPECT_FALSE(empty.release());
  EXPECT_FALSE(std::filesystem::exists(folder / "empty"));
}

}  // namespace
}  // namespace galilean::monitor
