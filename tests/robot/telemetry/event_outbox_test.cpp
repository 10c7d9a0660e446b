// SPDX-License-Identifier: BSD-3-Clause
#include "robot/telemetry/event_outbox.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace galilean::robot {
namespace {

/// DDS takes what is sent, or does not.
class EventOutboxTest : public testing::Test {
 protected:
  void send(int first, int last) {
    for (int event = first; event <= last; ++event) outbox.send(event);
  }
  [[nodiscard]] static std::vector<int> numbers(int first, int last) {
    std::vector<int> list(static_cast<std::size_t>(last - first + 1));
    std::iota(list.begin(), list.end(), first);
    return list;
  }

  bool takes = true;
  int asked = 0;
  std::vector<int> sent;
  EventOutbox<int> outbox{[this](const int& event) {
    ++asked;
    if (takes) sent.push_back(event);
    return takes;
  }};
};

TEST_F(EventOutboxTest, SendsAtOnceWhatIsTaken) {
  send(1, 2);
  EXPECT_EQ(sent, numbers(1, 2));
}

TEST_F(EventOutboxTest, WhatIsNotTakenIsSentLaterAndInOrder) {
  takes = false;
  send(1, 3);
  outbox.send_waiting();
  EXPECT_TRUE(sent.empty());
  EXPECT_EQ(outbox.waiting(), 3U);
  EXPECT_EQ(asked, 2) << "once for the first event, and once in the round after it";
  takes = true;
  send(4, 4);
  EXPECT_TRUE(sent.empty());
  outbox.send_waiting();
  EXPECT_EQ(sent, numbers(1, 4));
  send(5, 5);
  EXPECT_EQ(sent, numbers(1, 5));
  EXPECT_EQ(outbox.dropped(), 0U);
}

TEST_F(EventOutboxTest, KeepsTheNewestOfTooManyAndCountsTheOthers) {
  constexpr int kMost = EventOutbox<int>::kMost;
  takes = false;
  send(1, kMost + 5);
  takes = true;
  outbox.send_waiting();
  EXPECT_EQ(sent, numbers(6, kMost + 5));
  EXPECT_EQ(outbox.dropped(), 5U);
}

}  // namespace
}  // namespace galilean::robot
