// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <tuple>

#include "monitor/expect/judge/samples.h"

namespace galilean::expect {

/// Decodes messages of the types that a judge knows, and gives them to it.
class TypedDecoder {
 public:
  /// Returns false if the bytes are no whole message.
  using Decode = bool (TypedDecoder::*)(std::int64_t at_ns, std::span<const std::uint8_t> cdr);

  /// Requires: `sink` outlives this.
  explicit TypedDecoder(SampleSink& sink) : sink_(sink) {}

  /// Returns the function for messages of this type; nullptr if no judge knows the type.
  [[nodiscard]] static Decode function_for(std::string_view ros_type);

 private:
  template <class Message>
  bool decode_as(std::int64_t at_ns, std::span<const std::uint8_t> cdr);

  SampleSink& sink_;
  /// Kept, because to allocate their memory takes longer than to decode them.
  std::tuple<msg::RobotState, msg::Transition, msg::Variables, msg::Score, msg::Program> scratch_;
};

}  // namespace galilean::expect
