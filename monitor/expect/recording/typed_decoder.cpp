// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/expect/recording/typed_decoder.h"

namespace galilean::expect {

TypedDecoder::Decode TypedDecoder::function_for(std::string_view ros_type) {
  Decode found = nullptr;
  const auto choose = [&]<class Message>(const Message&) {
    if (ros_type == Message::kRosType) found = &TypedDecoder::decode_as<Message>;
  };
  choose(msg::RobotState{});
  choose(msg::Transition{});
  choose(msg::Variables{});
  choose(msg::Score{});
  choose(msg::Program{});
  return found;
}

template <class Message>
bool TypedDecoder::decode_as(std::int64_t at_ns, std::span<const std::uint8_t> cdr) {
  auto& decoded = std::get<Message>(scratch_);
  if (!msg::decode_cdr(cdr, decoded)) return false;
  sink_.sample(at_ns, decoded);
  return true;
}

}  // namespace galilean::expect
