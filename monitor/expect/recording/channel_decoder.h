// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <unordered_map>

#include "monitor/expect/judge/samples.h"
#include "monitor/expect/recording/typed_decoder.h"
#include "monitor/mcap/mcap_reader.h"

namespace galilean::expect {

/// Decodes messages of a recording's channels, as far as the sink wants them.
class ChannelDecoders {
 public:
  /// Requires: both outlive this.
  ChannelDecoders(const mcap::Summary& summary, SampleSink& sink);

  /// Gives the message to the sink. Returns false if it cannot be decoded, or is of a
  /// channel that the summary lacks.
  [[nodiscard]] bool take(std::int64_t at_ns, const mcap::Message& message);
  [[nodiscard]] std::string topic(std::uint16_t channel) const;
  /// Returns a sentence on each topic that the sink wants and whose type cannot be decoded.
  [[nodiscard]] std::vector<std::string> notes() const { return notes_; }

 private:
  struct Channel {
    std::string topic;
    bool counted = false;   ///< the sink wants to know of each message
    bool numbered = false;  ///< gaps in the numbers of its messages are missing messages
    TypedDecoder::Decode decode = nullptr;
    std::optional<monitor::MessageDecoder> fields;
  };

  /// `known`: whether this release defines the schema in the same way.
  void add(const mcap::Channel& channel, const mcap::Schema& schema, bool known);
  void add_fields(const mcap::Channel& channel, const mcap::Schema& schema, Channel& to);
  void note(std::string sentence);
  bool decode_fields(Channel& channel, std::int64_t at_ns, const mcap::Message& message);

  SampleSink& sink_;
  TypedDecoder typed_;
  std::unordered_map<std::uint16_t, Channel> channels_;
  std::vector<std::string> notes_;
};

}  // namespace galilean::expect
