// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/playbacks.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

#include "monitor/server/websocket/outbox.h"

namespace galilean::monitor {
namespace {

std::shared_ptr<PlaybackLine> silent_line() {
  return std::make_shared<PlaybackLine>([](const ForViewer&) {});
}

void play_until_left(PlaybackLine& line) {
  while (line.wait(std::chrono::hours(1))) {
  }
}

TEST(Playbacks, AreLimitedInNumberAndALeavingViewerMakesRoom) {
  Playbacks playbacks;
  std::vector<std::shared_ptr<PlaybackLine>> lines;
  for (std::size_t i = 0; i < Playbacks::kMost; ++i) {
    lines.push_back(silent_line());
    EXPECT_TRUE(playbacks.begin(lines.back(), play_until_left));
  }
  EXPECT_FALSE(playbacks.begin(silent_line(), play_until_left));
  lines.front()->leave();
  bool begun = false;
  for (int tries = 0; tries < 100'000 && !begun; ++tries) {
    begun = playbacks.begin(silent_line(), play_until_left);
    std::this_thread::yield();
  }
  EXPECT_TRUE(begun);
}

TEST(Playbacks, CountThoseThatRun) {
  Playbacks playbacks;
  EXPECT_EQ(playbacks.running(), 0U);
  const auto first = silent_line(), second = silent_line();
  ASSERT_TRUE(playbacks.begin(first, play_until_left));
  ASSERT_TRUE(playbacks.begin(second, play_until_left));
  EXPECT_EQ(playbacks.running(), 2U);
  first->leave();
  for (int tries = 0; tries < 100'000 && playbacks.running() > 1; ++tries)
    std::this_thread::yield();
  EXPECT_EQ(playbacks.running(), 1U);
  playbacks.finish();
  EXPECT_EQ(playbacks.running(), 0U);
}

TEST(Playbacks, OneThatFailsTellsItsViewer) {
  std::promise<std::string> told;
  auto line = std::make_shared<PlaybackLine>(
      [&](const ForViewer& what) { told.set_value(what.end_reason); });
  Playbacks playbacks;
  EXPECT_TRUE(playbacks.begin(line, [](PlaybackLine&) { throw std::runtime_error("no disk"); }));
  EXPECT_EQ(told.get_future().get(), "The replay failed: no disk.");
}

TEST(PlaybackLine, KeepsABoundedNumberOfOrders) {
  const auto line = silent_line();
  for (std::size_t i = 0; i < PlaybackLine::kMostOrders; ++i)
    ASSERT_TRUE(line->order(Unsubscribe{1}));
  EXPECT_FALSE(line->order(Unsubscribe{1}));
  EXPECT_EQ(line->take_orders().size(), PlaybackLine::kMostOrders);
  EXPECT_TRUE(line->order(Unsubscribe{1}));
}

TEST(PlaybackLine, HasRoomAgainWhenWhatWaitsHasGone) {
  const auto line = silent_line();
  ForViewer much;
  much.frames.push_back(binary_frame(std::vector<std::uint8_t>(PlaybackLine::kMostWaitingBytes)));
  const auto bytes = much.frames[0].size();
  EXPECT_TRUE(line->has_room());
  line->send(std::move(much));
  EXPECT_FALSE(line->has_room());
  line->taken(bytes);
  EXPECT_TRUE(line->has_room());
}

TEST(Outbox, TellsHowMuchOfItsQueueWasTaken) {
  Outbox outbox;
  std::vector<std::size_t> told;
  outbox.on_taken([&](std::size_t bytes) { told.push_back(bytes); });
  const auto frame = binary_frame(std::vector<std::uint8_t>(100));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(outbox.push(frame));
  outbox.offer(1, frame, 1);
  (void)outbox.take(2);
  (void)outbox.take(5);
  (void)outbox.take(5);
  EXPECT_EQ(told, (std::vector<std::size_t>{2 * frame.size(), frame.size()}));
}

}  // namespace
}  // namespace galilean::monitor
