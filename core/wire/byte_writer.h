// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/wire/participant.h"

namespace galilean::wire {

/// Writes messages that are already encoded as CDR bytes, the form in which Reader gives them, to
/// one topic.
class ByteWriter {
 public:
  /// Errors: throws std::runtime_error if Cyclone refuses the topic, or if `ros_type` is not one of
  /// the messages.
  ByteWriter(Participant& participant, const std::string& topic, const std::string& ros_type);
  /// Writes one message. Requires: `cdr` has its four-byte header. Returns false if that is no
  /// message of the type, or if Cyclone did not take it in time. It is then not sent.
  [[nodiscard]] bool write(std::span<const std::uint8_t> cdr) { return write_(cdr); }

 private:
  std::function<bool(std::span<const std::uint8_t>)> write_;
};

}  // namespace galilean::wire
