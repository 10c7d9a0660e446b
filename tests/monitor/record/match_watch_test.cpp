// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/match_watch.h"

#include <gtest/gtest.h>

#include "core/wire/participant.h"
#include "tests/free_domain.h"

namespace galilean::monitor {
namespace {

/// A writer that no reader is ever connected with, because it is not there.
wire::EndpointInfo unreachable_writer() {
  wire::EndpointInfo end;
  end.writes = true;
  end.topic = "rt/io/state";
  end.dds_type = "galilean_msgs::msg::dds_::RobotState_";
  end.process = "io";
  end.qos.reliable = true;
  end.handle = 42;
  end.guid = "0a1b";
  return end;
}

TEST(MatchWatch, AWriterThatIsNotHeardIsToldOnceWithWhatBothSidesWant) {
  const auto own = wire::Participant::join("record", free_domain()).value();
  const auto writer = unreachable_writer();
  TopicRecording recording({.participant = *own,
                            .kind = TopicRecording::kind_of(writer),
                            .find = [](std::uint64_t) { return std::nullopt; },
                            .on_data = [] {}});
  recording.follow(writer);
  MatchWatch watch;
  std::string told;
  for (int look = 0; look < 20; ++look) told += watch.look(writer, recording).value_or("");
  EXPECT_EQ(told,
            "'/io/state' of io is not recorded: DDS does not connect its writer (reliable, "
            "volatile, keep last 1) with the recorder's reader (reliable, volatile, keep last 1)");
}

}  // namespace
}  // namespace galilean::monitor
