// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/wire/messages.h"
#include "monitor/expect/judge/number_gaps.h"
#include "monitor/expect/judge/span_list.h"
#include "monitor/wire/message_decoder.h"

namespace galilean::expect {

/// Takes the decoded messages of a recording, or of the wire, one at a time and in the order of
/// their times. Times are nanoseconds since the Unix epoch, by one clock. Topics have their ROS
/// names: /io/state.
///
/// It stands between whoever reads and whoever judges, so that neither knows the other.
class SampleSink {
 public:
  virtual ~SampleSink() = default;

  /// Returns whether `message` must be called for the topic's messages.
  [[nodiscard]] virtual bool wants_messages(std::string_view topic) const = 0;
  /// Returns whether `fields` must be called for them.
  [[nodiscard]] virtual bool wants_fields(std::string_view topic) const = 0;
  /// Returns whether the messages of this type must be given to the function of that type.
  [[nodiscard]] virtual bool wants_type(std::string_view ros_type) const = 0;

  /// Takes that there was a message.
  virtual void message(std::int64_t at_ns, std::string_view topic, const Numbered& number) = 0;
  virtual void fields(std::int64_t at_ns, std::string_view topic,
                      const monitor::MessageTree& message) = 0;
  virtual void sample(std::int64_t at_ns, const msg::RobotState& state) = 0;
  virtual void sample(std::int64_t at_ns, const msg::Transition& transition) = 0;
  virtual void sample(std::int64_t at_ns, const msg::Variables& variables) = 0;
  virtual void sample(std::int64_t at_ns, const msg::Score& score) = 0;
  virtual void sample(std::int64_t at_ns, const msg::Program& program) = 0;
  /// Takes how many of a topic's messages its recorder counted as missing; nothing: it could not
  /// count them. Call it after the topic's messages, once at most.
  virtual void missed(std::string_view topic, std::optional<std::uint64_t> messages) = 0;
  /// Takes that messages of this time may be missing, and a sentence on why, or an empty text if it
  /// was told before. It may be called at any time.
  virtual void damage(const Span& span, const std::string& why) = 0;
};

}  // namespace galilean::expect
