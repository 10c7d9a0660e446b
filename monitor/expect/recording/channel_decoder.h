// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <tuple>
#include <unordered_map>

#include "monitor/expect/judge/samples.h"
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
  /// Returns a sentence on each channel that the sink wants and whose type cannot be decoded.
  [[nodiscard]] std::vector<std::string> notes() const { return notes_; }

 private:
  using Decode = bool (ChannelDecoders::*)(std::int64_t, const mcap::Message&);
  struct Channel {
    std::string topic;
    bool counted = false;  ///< the sink wants to know of each message
    Decode decode = nullptr;
    std::optional<monitor::MessageDecoder> fields;
  };

  void add(const mcap::Channel& channel, const std::string& type, bool known);
  template <class Message>
  bool decode_as(std::int64_t at_ns, const mcap::Message& message);
  bool decode_fields(Channel& channel, std::int64_t at_ns, const mcap::Message& message);

  SampleSink& sink_;
  std::unordered_map<std::uint16_t, Channel> channels_;
  std::vector<std::string> notes_;
  /// Kept, because to allocate their memory takes longer than to decode them.
  std::tuple<msg::RobotState, msg::Transition, msg::Variables, msg::Score, msg::Program> scratch_;
};

}  // namespace galilean::expect
