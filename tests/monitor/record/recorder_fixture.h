// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/record/recorder.h"
#include "tests/core/wire/types/foreign_talk.h"
#include "tests/core/wire/wait_until.h"
#include "tests/free_domain.h"
#include "tests/temporary_folder.h"

namespace galilean::monitor {

/// A recorder on a disk whose room the test decides, and a process of somebody else that talks.
class RecorderTest : public testing::Test {
 protected:
  static constexpr std::uint64_t kLeastRoom = 1000;
  static constexpr Duration kLookEach = std::chrono::seconds(1);

  wire::ForeignTalk talk(wire::Foreign message, const std::string& topic,
                         wire::Delivery delivery = wire::Delivery::kState) const {
    return {process.participant(), message, topic, wire::Cdr::kFirst, "", delivery};
  }
  void start(Selection selection = {}, FilePlan plan = {}) {
    plan.out = folder / "run.mcap";
    files.emplace(std::move(plan));
    recorder.emplace(Recorder::Setup{.participant = *own,
                                     .clock = clock,
                                     .files = *files,
                                     .room = {kLeastRoom, [this] { return std::optional(free); }},
                                     .about = {{"version", "1"}},
                                     .selection = std::move(selection),
                                     .snapshots = snapshots,
                                     .warn = [this](const auto& what) { warnings += what + "\n"; },
                                     .ended = [] { return false; }});
    ASSERT_TRUE(recorder->begin());
  }
  void pump() { EXPECT_TRUE(recorder->pump()); }
  /// Lets a second pass, after which the recorder looks after its files.
  void look() {
    clock.advance(kLookEach);
    pump();
  }
  [[nodiscard]] bool comes_to_be_heard(const wire::ForeignTalk& writer) {
    return wire::wait_until([&] { return pump(), writer.readers() > 0; });
  }
  [[nodiscard]] bool comes_to_record(std::uint64_t messages) {
    return wire::wait_until([&] { return pump(), files->totals().messages >= messages; });
  }
  [[nodiscard]] mcap::Summary summary_of(const std::string& name) const {
    const auto source = mcap::FileSource::open(folder / name);
    if (!source) return ADD_FAILURE() << source.error().message, mcap::Summary();
    return mcap::summarize(source.value()).value();
  }
  [[nodiscard]] mcap::Summary recorded() {
    EXPECT_TRUE(recorder->conclude());
    return summary_of("run.mcap");
  }

  const TemporaryFolder folder;
  const int domain = free_domain();
  const std::unique_ptr<wire::Participant> own = wire::Participant::join("record", domain).value();
  wire::ForeignProcess process{"talker", domain};
  SteppedClock clock;
  std::uint64_t free = 1'000'000;  ///< bytes
  std::string warnings;
  Snapshots snapshots;  ///< without a trigger unless a test sets one before `start`
  std::optional<RecordingFiles> files;
  std::optional<Recorder> recorder;
};

}  // namespace galilean::monitor
