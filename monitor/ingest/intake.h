// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/wire/refusals.h"

namespace galilean::monitor {

/// How the messages of one channel come in.
struct ChannelIntake {
  std::string topic;                 ///< as on DDS: "rt/io/state"
  std::uint64_t messages = 0;        ///< taken since the start
  std::optional<double> age_s = {};  ///< since the newest came; nothing: none came yet
  // Of a robot's events, which its writers number; see EventIntake.
  std::uint64_t filled = 0;  ///< of `messages`: those that fill a gap
  std::uint64_t lost = 0;    ///< those that will not come any more
};

/// What a monitor takes in from DDS, and what it does not.
struct Intake {
  std::vector<ChannelIntake> channels;
  std::vector<wire::Refusals::Count> refused;
  std::size_t topics_not_read = 0;   ///< beyond the bounds of Ingest
  std::size_t robots_forgotten = 0;  ///< that gave their places to others; see RobotRoster
};

}  // namespace galilean::monitor
