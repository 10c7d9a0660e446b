// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/gap_watch.h"

#include <gtest/gtest.h>

namespace galilean::monitor {
namespace {

using namespace std::chrono_literals;

wire::EndpointInfo typed_writer(const std::string& topic, const std::string& type) {
  wire::EndpointInfo info;
  info.writes = true;
  info.topic = topic;
  info.dds_type = "galilean_msgs::msg::dds_::" + type + "_";
  return info;
}

const wire::EndpointInfo kIoState = typed_writer("rt/io/state", "RobotState");
const wire::EndpointInfo kIoTransition = typed_writer("rt/io/transition", "Transition");
const wire::EndpointInfo kIoReply = typed_writer("rt/io/program_reply", "ProgramReply");

class RecordersGapWatchTest : public testing::Test {
 protected:
  bool note(const wire::EndpointInfo& writer, std::int64_t sent_ns) {
    return watch.note(writer, {{}, sent_ns, 0}, clock.now());
  }
  [[nodiscard]] std::int64_t now_ns() const { return clock.now().time_since_epoch().count(); }
  /// io is heard, and then it is not heard for a minute. Returns the middle of that.
  std::int64_t cut_off() {
    clock.advance(10s);
    EXPECT_FALSE(note(kIoState, now_ns()));
    clock.advance(60s);
    return now_ns() - 30'000'000'000;
  }

  SteppedClock clock;
  GapWatch watch;
};

TEST_F(RecordersGapWatchTest, TellsTheEventsOfARobotThatWasNotHeard) {
  const auto then_ns = cut_off();
  EXPECT_TRUE(note(kIoTransition, then_ns));
  EXPECT_FALSE(note(kIoState, now_ns()));
  EXPECT_TRUE(note(kIoReply, then_ns));
  EXPECT_FALSE(note(kIoTransition, now_ns()));
}

TEST_F(RecordersGapWatchTest, GoesByTheStatesOfTheSameRobot) {
  const auto then_ns = cut_off();
  EXPECT_FALSE(note(typed_writer("rt/ganymede/transition", "Transition"), then_ns));
}

TEST_F(RecordersGapWatchTest, OtherMessagesFillNothing) {
  const auto then_ns = cut_off();
  EXPECT_FALSE(note(typed_writer("rt/io/sightings", "Sightings"), then_ns));
  EXPECT_FALSE(note(typed_writer("rt/io/transition", "Strange"), then_ns));
  EXPECT_FALSE(note(typed_writer("state", "RobotState"), then_ns));
}

TEST_F(RecordersGapWatchTest, KnowsWhichChangesOfStateGoWithAState) {
  EXPECT_TRUE(GapWatch::is_state(kIoState));
  EXPECT_FALSE(GapWatch::is_state(kIoTransition));
  const auto transitions = GapWatch::transitions_of(kIoState);
  EXPECT_EQ(transitions.topic, kIoTransition.topic);
  EXPECT_EQ(transitions.dds_type, kIoTransition.dds_type);
  EXPECT_TRUE(is_robot_event(transitions));
}

}  // namespace
}  // namespace galilean::monitor
