// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/pushes/history/words.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

// Pages, scripts and files on disks have these words: none may change.

template <class Enum, class Read>
void expect_word(Enum value, const std::string& word, Read read) {
  EXPECT_EQ(to_text(value), word);
  EXPECT_EQ(read(word), value) << word;
}

TEST(Words, OfSteps) {
  expect_word(StepKind::kCheck, "check", step_kind_of);
  expect_word(StepKind::kTry, "try", step_kind_of);
  expect_word(StepKind::kCanary, "canary", step_kind_of);
  expect_word(StepKind::kRest, "rest", step_kind_of);
  expect_word(StepState::kWaiting, "waiting", step_state_of);
  expect_word(StepState::kRunning, "running", step_state_of);
  expect_word(StepState::kDone, "done", step_state_of);
  expect_word(StepState::kFailed, "failed", step_state_of);
  expect_word(StepState::kCancelled, "cancelled", step_state_of);
  expect_word(StepState::kLeftOut, "left_out", step_state_of);
}

TEST(Words, OfPushes) {
  expect_word(PushState::kRunning, "running", push_state_of);
  expect_word(PushState::kDone, "done", push_state_of);
  expect_word(PushState::kFailed, "failed", push_state_of);
  expect_word(PushState::kCancelled, "cancelled", push_state_of);
  expect_word(PushState::kInterrupted, "interrupted", push_state_of);
  expect_word(PushState::kToldLater, "told_later", push_state_of);
  expect_word(PushState::kForeign, "", push_state_of);
}

TEST(Words, OfReplies) {
  expect_word(ReplyStatus::kNoAnswer, "no_answer", reply_status_of);
  expect_word(ReplyStatus::kReceived, "received", reply_status_of);
  expect_word(ReplyStatus::kRejected, "rejected", reply_status_of);
  expect_word(ReplyStatus::kRunning, "running", reply_status_of);
  expect_word(ReplyStatus::kConfirmed, "confirmed", reply_status_of);
  expect_word(ReplyStatus::kRolledBack, "rolled_back", reply_status_of);
  expect_word(ReplyStatus::kUnknown, "unknown", reply_status_of);
}

TEST(Words, ThatAreNoneMeanNothing) {
  EXPECT_FALSE(step_kind_of("dance"));
  EXPECT_FALSE(step_state_of(""));
  EXPECT_FALSE(push_state_of("Done"));
  EXPECT_FALSE(reply_status_of("9"));
}

TEST(Words, NumbersOfRepliesAreTheMessages) {
  namespace status = msg::ProgramReply_Constants;
  EXPECT_EQ(reply_status(0), ReplyStatus::kNoAnswer);
  EXPECT_EQ(reply_status(status::RECEIVED), ReplyStatus::kReceived);
  EXPECT_EQ(reply_status(status::REJECTED), ReplyStatus::kRejected);
  EXPECT_EQ(reply_status(status::RUNNING), ReplyStatus::kRunning);
  EXPECT_EQ(reply_status(status::CONFIRMED), ReplyStatus::kConfirmed);
  EXPECT_EQ(reply_status(status::ROLLED_BACK), ReplyStatus::kRolledBack);
  EXPECT_EQ(reply_status(status::ROLLED_BACK + 1), ReplyStatus::kUnknown);
}

}  // namespace
}  // namespace galilean::monitor
