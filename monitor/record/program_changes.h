// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/wire/endpoints.h"
#include "core/wire/reader.h"
#include "monitor/mcap/mcap_records.h"

namespace galilean::monitor {

/// The metadata that tells which program a robot runs: one record for the first that is heard in a
/// file, and one for each that follows.
inline constexpr const char* kProgramMetadata = "program";

/// Finds out which programs robots run, by their hashes, and when that changes. Whoever writes to
/// DDS can invent robots, so it follows the first kMostRobots of them.
class ProgramChanges {
 public:
  static constexpr std::size_t kMostRobots = 1024;

  /// Takes a message, which was received at `log_ns`, since the Unix epoch. Returns the metadata of
  /// a robot's program that is another one than before: its `robot`, `hash` and `name`, since when
  /// the robot runs it by its own clock (`since`), and when that was received (`received`); nothing
  /// for other messages.
  [[nodiscard]] std::optional<mcap::Metadata> note(const wire::EndpointInfo& writer,
                                                   const wire::Received& received,
                                                   std::int64_t log_ns);

 private:
  std::map<std::string, std::string> hashes_;  ///< of the newest programs, by robot
};

}  // namespace galilean::monitor
