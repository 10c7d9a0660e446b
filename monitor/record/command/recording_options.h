// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "monitor/record/channels.h"
#include "monitor/record/recording_files.h"
#include "monitor/record/selection.h"
#include "monitor/record/snapshots.h"

namespace galilean::monitor {

/// What a user asks of a recording.
struct RecordingOptions {
  FilePlan plan;
  Selection selection;
  SchemaLanguage language = SchemaLanguage::kMessage;
  /// 0: without a limit. With the default, three robots make less than a gigabyte an hour.
  std::uint64_t picture_bytes_per_s = 200'000;
  std::uint64_t min_free_bytes = 500'000'000;
  std::string on;  ///< the event around which is recorded; empty: all is
  /// What is kept before and after it; without a trigger.
  Snapshots snapshots{nullptr, std::chrono::seconds(30), std::chrono::seconds(10)};
  double duration_s = 0;  ///< 0: until termination is asked for
  int domain = -1;        ///< -1: as ROS_DOMAIN_ID says
  std::string name;       ///< by which commands call the recorder
  mcap::Text about;       ///< what a user wants each file to tell, such as a seed
};

/// Reads the options of `galilean record`. Returns nothing if the program is to go on, and the exit
/// code otherwise.
[[nodiscard]] std::optional<int> read_options(int count, const char* const* arguments,
                                              RecordingOptions& options);

}  // namespace galilean::monitor
