// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/record/recorder.h"

#include <gmock/gmock.h>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/mcap/mcap_scan.h"
#include "tests/core/wire/types/foreign_talk.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"
#include "tests/monitor/record/faulty_disk.h"

namespace galilean::monitor {
namespace {

using testing::HasSubstr;
using wire::Cdr;
using wire::Foreign;
using wire::ForeignTalk;
using wire::wait_until;

class RecorderTest : public testing::Test {
 protected:
  RecorderTest() { EXPECT_TRUE(file.begin()); }

  ForeignTalk talk(Foreign message, const std::string& topic) const {
    return {process.participant(), message, topic, Cdr::kFirst};
  }
  void start(Recorder::Selection selection = {}) {
    recorder.emplace(Recorder::Setup{.participant = *own,
                                     .writer = file,
                                     .selection = std::move(selection),
                                     .warn = [this](const auto& what) { warnings += what + "\n"; },
                                     .ended = [] { return false; }});
  }
  [[nodiscard]] bool comes_to_record(std::uint64_t messages) {
    return wait_until([&] {
      EXPECT_TRUE(recorder->pump());
      return file.statistics().messages >= messages;
    });
  }
  mcap::Summary recorded() {
    EXPECT_TRUE(recorder->conclude());
    EXPECT_TRUE(file.end());
    return mcap::summarize(mcap::MemorySource(disk.bytes())).value();
  }

  const int domain = free_domain();
  std::unique_ptr<wire::Participant> own = wire::Participant::join("record", domain).value();
  wire::ForeignProcess process{"talker", domain};
  mcap::FaultyDisk disk;
  mcap::Writer file{disk};
  std::string warnings;
  std::optional<Recorder> recorder;
};

TEST_F(RecorderTest, ATypeOfSomebodyElseIsRecordedWithItsDefinition) {
  auto cells = talk(Foreign::kCells, "rt/cells");
  ASSERT_TRUE(cells.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.begin()->second.encoding, "ros2msg");
  EXPECT_EQ(summary.schemas.begin()->second.data, "int8 cost\nint8[] costs\nint8[4] corners\n");
  EXPECT_EQ(summary.channels.begin()->second.topic, "/cells");
  EXPECT_EQ(warnings, "");
}

TEST_F(RecorderTest, WhatNoMsgFileCanSayIsDefinedInIdl) {
  auto plain = talk(Foreign::kPlain, "rt/plain");
  ASSERT_TRUE(plain.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  EXPECT_EQ(summary.schemas.begin()->second.encoding, "omgidl");
  EXPECT_THAT(summary.schemas.begin()->second.data, HasSubstr("struct Plain {"));
}

TEST_F(RecorderTest, WithoutTypeInformationTheBytesAreRecordedAndThatIsSaid) {
  auto bare = talk(Foreign::kBare, "rt/bare");
  ASSERT_TRUE(bare.write());
  start();
  ASSERT_TRUE(comes_to_record(1));
  const auto summary = recorded();
  EXPECT_EQ(summary.channels.begin()->second.schema_id, 0);
  EXPECT_EQ(summary.channels.begin()->second.metadata.at("type"), "bare::Message");
  EXPECT_THAT(warnings, HasSubstr("'/bare' is recorded as bytes that no reader can decode"));
}

TEST_F(RecorderTest, TwoTypesOnOneTopicHaveAChannelEach) {
  auto cells = talk(Foreign::kCells, "rt/mixed");
  auto large = talk(Foreign::kLarge, "rt/mixed");
  ASSERT_TRUE(cells.write());
  ASSERT_TRUE(large.write());
  start();
  ASSERT_TRUE(comes_to_record(2));
  EXPECT_EQ(recorder->topics(), 1U);
  EXPECT_EQ(recorded().channels.size(), 2U);
}

TEST_F(RecorderTest, KnowsThatASelectionLeftAllOut) {
  const auto cells = talk(Foreign::kCells, "rt/cells");
  Recorder::Selection selection;
  selection.topics.emplace("^/io/");
  start(std::move(selection));
  EXPECT_TRUE(
      wait_until([&] { return static_cast<void>(recorder->pump()), recorder->left_out_topics(); }));
  EXPECT_EQ(recorder->topics(), 0U);
}

TEST_F(RecorderTest, WhatWasLostStandsInTheFile) {
  auto cells = talk(Foreign::kCells, "rt/cells");
  start();
  ASSERT_TRUE(
      wait_until([&] { return static_cast<void>(recorder->pump()), cells.readers() == 1; }));
  ASSERT_TRUE(cells.write());
  ASSERT_TRUE(comes_to_record(1));
  for (int i = 0; i < 700; ++i) ASSERT_TRUE(cells.write());  // 600 wait at most
  ASSERT_TRUE(comes_to_record(601));
  EXPECT_EQ(total_lost(recorder->losses()), 100U);
  EXPECT_TRUE(recorder->conclude());
  EXPECT_TRUE(file.end());
  std::map<std::string, mcap::Metadata> metadata;
  mcap::Visitor visitor;
  visitor.metadata = [&](const mcap::Metadata& each) { metadata[each.name] = each; };
  static_cast<void>(mcap::scan(mcap::MemorySource(disk.bytes()), visitor));
  EXPECT_EQ(metadata["losses"].entries["missing"], "100");
  EXPECT_THAT(metadata["losses"].entries["/cells of talker"], HasSubstr("\"recorded\":601"));
}

}  // namespace
}  // namespace galilean::monitor
