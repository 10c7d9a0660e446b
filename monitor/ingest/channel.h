// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/wire/delivery.h"
#include "core/wire/schemas.h"

namespace galilean::monitor {

/// One topic of the team. Made once, by Ingest, and kept for as long as that lives, whether or not
/// anybody still writes it.
struct Channel {
  std::uint32_t id = 0;  ///< 1, 2, 3 … in the order of discovery
  std::string topic;     ///< as on DDS: "rt/io/state"
  const wire::Schema* schema = nullptr;
  wire::Delivery delivery = wire::Delivery::kStream;

  /// "/io/state": what ROS 2 and Foxglove call it.
  [[nodiscard]] std::string ros_name() const { return topic.substr(2); }
};

using Payload = std::shared_ptr<const std::vector<std::uint8_t>>;

/// One message as it came. Whoever passes it on shares the bytes.
struct Message {
  const Channel& channel;
  std::int64_t received_ns;  ///< by this machine's clock, since the Unix epoch
  std::int64_t sent_ns;      ///< by its writer's clock, since the Unix epoch
  Payload cdr;               ///< with its four-byte header
};

}  // namespace galilean::monitor
