// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"

namespace galilean::robot {

/// Listens for robots of one name in the DDS domain: those that tell their state on its topic. A
/// robot that died stays known to DDS for ten seconds, but tells nothing, and does not count. Nor
/// does a replay. One thread at a time may call it.
class NamesakeWatch {
 public:
  /// A robot tells its state ten times a second. It counts for so long after it was heard last.
  static constexpr Duration kHeardFor = std::chrono::milliseconds(2500);
  /// The time for DDS' discovery in both directions.
  static constexpr Duration kAcquaintance = std::chrono::seconds(1);

  /// Errors: throws std::runtime_error if DDS refuses the topic.
  NamesakeWatch(wire::Participant& participant, const std::string& robot);

  /// Returns how many robots of this name are heard; one of them is this process's own if that
  /// tells its state already.
  [[nodiscard]] int count(Time now);
  /// Listens for kAcquaintance, or until `is_over`, and longer if it hears somebody late, so that
  /// the other one knows of this one. Requires: this process does not tell the robot's state yet.
  /// Errors: a robot of this name is there.
  [[nodiscard]] Result<void> expect_none(const Clock& clock, const std::function<bool()>& is_over);

 private:
  struct Writer {
    bool is_replay = false;
    Time heard{};
  };

  wire::Participant& participant_;
  std::string robot_;
  wire::Reader states_;
  std::map<std::uint64_t, Writer> writers_;  ///< by Received::writer
};

}  // namespace galilean::robot
