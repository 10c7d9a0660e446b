// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/boot_record.h"

#include <gtest/gtest.h>

namespace galilean::robot {
namespace {

constexpr BootRecord::Name kIo{'i', 'o'};
constexpr BootRecord::Name kEuropa{'e', 'u', 'r', 'o', 'p', 'a'};

/// A record of a board that was heard `uptime_ms` after its seventh start.
BootRecord known(std::uint32_t uptime_ms) {
  BootRecord record;
  record.note_greeting(kIo, 7, uptime_ms);
  return record;
}

TEST(BootRecord, TheFirstBoardIsNoReset) {
  EXPECT_EQ(known(5000).epoch(), 0U);
}

TEST(BootRecord, ALineThatWasLostForHoursIsNoReset) {
  BootRecord record = known(5000);
  record.note_greeting(kIo, 7, 5000 + 3 * BootRecord::kLongestSilence_ms);
  EXPECT_EQ(record.epoch(), 0U);
}

TEST(BootRecord, LessUptimeIsAReset) {
  BootRecord record = known(5000);
  EXPECT_TRUE(record.differs(7, 4999));
  record.note_greeting(kIo, 7, 4999);
  EXPECT_EQ(record.epoch(), 1U);
}

TEST(BootRecord, AnotherBootCountIsAResetAlsoWhereTheCountBeginsAnew) {
  BootRecord record;
  record.note_greeting(kIo, 65535, 5000);
  EXPECT_TRUE(record.differs(0, 6000));
  record.note_greeting(kIo, 0, 6000);
  EXPECT_EQ(record.epoch(), 1U);
}

TEST(BootRecord, AnUptimeThatBeginsAnewAfterSevenWeeksIsNoReset) {
  constexpr std::uint32_t kLast_ms = 0xFFFFFFFF;
  BootRecord record = known(kLast_ms - 5);
  EXPECT_FALSE(record.differs(7, 14));
  record.note(7, 14);
  EXPECT_EQ(record.epoch(), 0U);
  EXPECT_TRUE(record.differs(8, 15)) << "its boot count still tells of one";
  BootRecord silent = known(kLast_ms - BootRecord::kLongestSilence_ms);
  EXPECT_TRUE(silent.differs(7, 14)) << "nobody knows what it did for an hour";
}

TEST(BootRecord, AnotherBoardCountsOnceHoweverItLooks) {
  for (const std::uint16_t boots : {std::uint16_t{7}, std::uint16_t{8}})
    for (const std::uint32_t uptime_ms : {4000U, 6000U}) {
      BootRecord record = known(5000);
      record.note_greeting(kEuropa, boots, uptime_ms);
      EXPECT_EQ(record.epoch(), 1U) << boots << ", " << uptime_ms;
      record.note_greeting(kEuropa, boots, uptime_ms + 1);
      EXPECT_EQ(record.epoch(), 1U) << "it is the same one again";
    }
}

}  // namespace
}  // namespace galilean::robot
