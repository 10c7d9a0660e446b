// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "core/wire/entity.h"

struct ddsi_serdata;

namespace galilean::wire {

class Participant;

/// A topic that is read as bytes, so that this program need not know its type. Writers match its
/// readers by the name of the type, whatever its definition.
struct UntypedTopic {
  std::string name;      ///< as on DDS: "rt/io/state"
  std::string dds_type;  ///< "galilean_msgs::msg::dds_::RobotState_"
  bool keyed = false;    ///< as EndpointInfo::keyed of its writers
};

/// Returns the topic's entity, for readers only. They keep the messages of all keys in one history.
/// Errors: throws std::runtime_error if Cyclone refuses the topic.
[[nodiscard]] Entity make_untyped_topic(const Participant& participant, const UntypedTopic& topic);

/// Returns the number that its writer gave to a message (DDSI-RTPS 2.2, 8.3.5.4), or 0 if it is
/// none of an untyped topic, or came from a writer of this process.
[[nodiscard]] std::uint64_t sequence_of(const ddsi_serdata& message) noexcept;

}  // namespace galilean::wire
