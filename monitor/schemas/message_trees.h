// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <variant>

#include "monitor/mcap/mcap_reader.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::monitor {

/// Returns the type that a schema of a recording defines: this release's own, or what its text
/// says, in the encodings "ros2idl" and "ros2msg". Errors: it cannot be read; the error is a clause
/// that the type's name can stand before.
[[nodiscard]] Result<wire::Type> type_of_schema(const mcap::Schema& schema);

/// Decodes the messages of a recording by the schemas that it holds.
class MessageTrees {
 public:
  explicit MessageTrees(const mcap::Summary& summary);

  /// Returns the message's fields. Errors: its type is not known, or the bytes are no whole message
  /// of it. The error is a sentence without a full stop.
  [[nodiscard]] Result<MessageTree> decode(const mcap::Message& message) const;
  /// Returns why no message of the channel can be decoded; empty if they can.
  [[nodiscard]] std::string problem_of(std::uint16_t channel) const;

 private:
  struct Json {};
  struct Problem {
    std::string sentence;
  };
  using Decoder = std::variant<MessageDecoder, Json, Problem>;

  [[nodiscard]] static Decoder decoder_of(const mcap::Channel& channel,
                                          const mcap::Summary& summary);

  std::map<std::uint16_t, Decoder> decoders_;
};

}  // namespace galilean::monitor
