// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/coverage/recorded_coverage.h"

#include <gmock/gmock.h>

#include "monitor/mcap/message_reader.h"
#include "tests/monitor/coverage/fetch_program.h"

namespace galilean::monitor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

RecordedCoverage coverage_of(const mcap::Bytes& bytes) {
  const mcap::MemorySource source(bytes);
  const auto summary = mcap::summarize(source);
  RecordedCoverage coverage;
  coverage.begin(summary.value());
  mcap::MessageReader reader(source, summary.value().blocks);
  while (const auto* message = reader.next()) coverage.take(*message);
  return coverage;
}

TEST(RecordedCoverage, CountsWhatRobotsDidOfTheirPrograms) {
  const auto coverage = coverage_of(recording_of_fetch());
  EXPECT_THAT(coverage.uncounted(), IsEmpty());
  ASSERT_EQ(coverage.programs().size(), 1U);
  const auto& fetched = coverage.programs().at("3f2a");
  EXPECT_NEAR(fetched.share_of_states(), 2.0 / 3, 1e-9);
  EXPECT_NEAR(fetched.share_of_conditions(), 2.0 / 3, 1e-9);
}

TEST(RecordedCoverage, SaysWhichTypesAreOfAnotherRelease) {
  expect::MemorySink sink;
  mcap::Writer writer(sink, {});
  (void)writer.begin();
  const auto schema =
      writer.add_schema("galilean_msgs/msg/RobotState", "ros2msg", "string robot_then");
  const auto channel =
      writer.add_channel({.schema_id = schema, .topic = "/io/state", .message_encoding = "cdr"});
  const mcap::Bytes bytes{0, 1, 0, 0};
  (void)writer.write({channel, 1, 1, 1, mcap::ByteView(bytes)});
  (void)writer.end();
  EXPECT_THAT(coverage_of(sink.bytes_).uncounted(),
              ElementsAre("what is on /io/state is not counted: its type is of another release"));
}

/// A robot that is in another state in each message, with names so long that few fit.
TEST(RecordedCoverage, StopsWhereNoRealTeamWouldGo) {
  constexpr std::size_t kName_bytes = std::size_t{1} << 20;
  expect::RecordedTeam team;
  for (int i = 0; i < 40; ++i) {
    msg::RobotState state;
    state.robot = "io";
    state.program_hash = "3f2a";
    state.state = std::to_string(i) + std::string(kName_bytes, 'x');
    team.send(i, "/io/state", state);
  }
  const auto coverage = coverage_of(team.end());
  EXPECT_LT(coverage.programs().at("3f2a").kept_bytes(),
            RecordedCoverage::kMostKeptBytes + 2 * kName_bytes);
  EXPECT_THAT(coverage.uncounted(), ElementsAre(HasSubstr("beyond the first 16 MiB")));
}

}  // namespace
}  // namespace galilean::monitor
