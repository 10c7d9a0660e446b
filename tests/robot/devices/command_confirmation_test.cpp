// SPDX-License-Identifier: BSD-3-Clause
#include "robot/devices/command_confirmation.h"

#include <gtest/gtest.h>

namespace galilean::robot {
namespace {

using std::chrono::milliseconds;

Time at(int time_ms) {
  return Time{milliseconds(time_ms)};
}

TEST(CommandConfirmation, IsMissingUntilTheBoardTellsTheCommandOrALaterOne) {
  CommandConfirmation confirmation;
  confirmation.note_written(std::nullopt, at(0));
  EXPECT_FALSE(confirmation.missing());
  confirmation.note_written(5, at(10));
  confirmation.note_written(8, at(60));
  EXPECT_TRUE(confirmation.missing_for(milliseconds(60), at(71)));
  EXPECT_FALSE(confirmation.missing_for(milliseconds(60), at(70)));
  confirmation.note_accepted(4);
  confirmation.note_accepted(9);
  EXPECT_TRUE(confirmation.missing()) << "neither is one that was written since";
  confirmation.note_accepted(6);
  EXPECT_FALSE(confirmation.missing());
  confirmation.note_written(8, at(80));
  EXPECT_TRUE(confirmation.missing()) << "the newest is not confirmed yet";
  confirmation.note_accepted(8);
  confirmation.note_written(8, at(200));
  EXPECT_FALSE(confirmation.missing()) << "the same one again is confirmed already";
}

TEST(CommandConfirmation, HoldsWhereSequencesWrapAround) {
  CommandConfirmation confirmation;
  confirmation.note_written(65534, at(0));
  confirmation.note_written(1, at(10));
  confirmation.note_accepted(65533);
  EXPECT_TRUE(confirmation.missing());
  confirmation.note_accepted(0);
  EXPECT_FALSE(confirmation.missing());
}

TEST(CommandConfirmation, ANewSessionAwaitsNothing) {
  CommandConfirmation confirmation;
  confirmation.note_written(3, at(0));
  confirmation.reset();
  EXPECT_FALSE(confirmation.missing());
  confirmation.note_accepted(3);
  confirmation.note_written(3, at(10));
  EXPECT_TRUE(confirmation.missing()) << "another session confirmed it";
}

}  // namespace
}  // namespace galilean::robot
