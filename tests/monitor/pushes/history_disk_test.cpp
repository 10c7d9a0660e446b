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
