// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::monitor {

/// One topic of a recording, as a viewer of it sees it. A recording has a channel for each writer
/// of a topic; those that are alike are one topic here.
struct RecordedTopic {
  std::uint32_t id = 0;  ///< 1, 2, 3 … in the order of the names
  std::string topic;     ///< "/io/state"
  std::string encoding;  ///< of the messages: "cdr"
  std::string schema_name, schema_encoding, schema;
  wire::Delivery delivery = wire::Delivery::kStream;
  std::vector<std::uint16_t> channels;  ///< the recording's, in rising order
};

/// Returns the topics of a recording. Where a type is one that this release knows, its schema is
/// that of a live team, in ros2idl with constants; any other stands as in the file.
[[nodiscard]] std::vector<RecordedTopic> recorded_topics(const mcap::Summary& summary);

/// Returns the names of the robots whose states are among the channels, sorted.
[[nodiscard]] std::vector<std::string> recorded_robots(
    const std::map<std::uint16_t, mcap::Schema>& schemas,
    const std::map<std::uint16_t, mcap::Channel>& channels);

}  // namespace galilean::monitor
