// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "core/wire/schemas.h"

namespace galilean::monitor {

/// One topic of the team. Ingest makes it once and keeps it as long as itself, even if the topic
/// has no writer any more.
struct Channel {
  std::uint32_t id = 0;  ///< 1, 2, 3 … in the order of discovery
  std::string topic;     ///< DDS' name of it: "rt/io/state"
  const wire::Schema* schema = nullptr;
  wire::Delivery delivery = wire::Delivery::kStream;

  /// Returns the topic's name in ROS 2 and Foxglove: "/io/state".
  [[nodiscard]] std::string ros_name() const { return topic.substr(2); }
};

using Payload = std::shared_ptr<const std::vector<std::uint8_t>>;

/// One message as it was received. Copies share the bytes.
struct Message {
  const Channel& channel;
  std::int64_t received_ns;  ///< time since the Unix epoch, of this machine's clock
  std::int64_t sent_ns;      ///< time since the Unix epoch, of the writer's clock
  Payload cdr;               ///< the message in CDR, with the four-byte header
  bool replayed = false;     ///< a replay sent it: it comes from a recording, and nobody is there
  bool filled = false;       ///< it is an event that fills a gap: see wire::CutOffWatch
};

}  // namespace galilean::monitor
