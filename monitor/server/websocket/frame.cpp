// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/websocket/frame.h"

#include <limits>

namespace galilean::monitor {
namespace {

enum WebSocketOpcode : std::uint8_t { kText = 0x81, kBinary = 0x82 };  // both have the FIN bit
enum ServerOpcode : std::uint8_t { kMessageData = 1, kTime = 2, kServiceResponse = 3 };
constexpr std::uint8_t kServiceRequest = 2;

void put_byte(Frame& frame, std::uint8_t byte) {
  frame.head[frame.head_size++] = byte;
}

template <class T>
void put_little_endian(Frame& frame, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    put_byte(frame, static_cast<std::uint8_t>(value >> (8 * i)));
}

Frame begin_frame(WebSocketOpcode opcode, std::size_t size) {
  Frame frame;
  put_byte(frame, opcode);
  const int length_bytes = size < 126                                          ? 0
                           : size <= std::numeric_limits<std::uint16_t>::max() ? 2
                                                                               : 8;
  put_byte(frame, length_bytes == 0   ? static_cast<std::uint8_t>(size)
                  : length_bytes == 2 ? std::uint8_t{126}
                                      : std::uint8_t{127});
  for (int i = length_bytes - 1; i >= 0; --i)
    put_byte(frame, static_cast<std::uint8_t>(std::uint64_t{size} >> (8 * i)));
  return frame;
}

std::uint32_t little_endian(const std::uint8_t* bytes) {
  return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::uint32_t{bytes[3]} << 24;
}

}  // namespace

Frame text_frame(std::string_view text) {
  Frame frame = begin_frame(kText, text.size());
  frame.payload = std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end());
  return frame;
}

Frame binary_frame(std::vector<std::uint8_t> message) {
  Frame frame = begin_frame(kBinary, message.size());
  frame.payload = std::make_shared<const std::vector<std::uint8_t>>(std::move(message));
  return frame;
}

Frame message_frame(std::uint32_t subscription_id, const Message& message) {
  return message_frame(subscription_id, static_cast<std::uint64_t>(message.received_ns),
                       message.cdr);
}

Frame message_frame(std::uint32_t subscription_id, std::uint64_t log_ns, Payload message) {
  Frame frame = begin_frame(kBinary, 13 + message->size());
  put_byte(frame, kMessageData);
  put_little_endian(frame, subscription_id);
  put_little_endian(frame, log_ns);
  frame.payload = std::move(message);
  return frame;
}

Frame time_frame(std::int64_t since_epoch_ns) {
  Frame frame = begin_frame(kBinary, 9);
  put_byte(frame, kTime);
  put_little_endian(frame, static_cast<std::uint64_t>(since_epoch_ns));
  return frame;
}

Frame service_response_frame(std::uint32_t service_id, std::uint32_t call_id,
                             std::string_view encoding, std::string_view answer) {
  Frame frame = begin_frame(kBinary, 13 + encoding.size() + answer.size());
  put_byte(frame, kServiceResponse);
  put_little_endian(frame, service_id);
  put_little_endian(frame, call_id);
  put_little_endian(frame, static_cast<std::uint32_t>(encoding.size()));
  std::vector<std::uint8_t> rest(encoding.begin(), encoding.end());
  rest.insert(rest.end(), answer.begin(), answer.end());
  frame.payload = std::make_shared<const std::vector<std::uint8_t>>(std::move(rest));
  return frame;
}

bool read_service_call(std::span<const std::uint8_t> bytes, ServiceCall& call) {
  constexpr std::size_t kFixed = 13;
  if (bytes.size() < kFixed || bytes[0] != kServiceRequest) return false;
  call.service_id = little_endian(&bytes[1]);
  call.call_id = little_endian(&bytes[5]);
  const std::size_t encoding_size = little_endian(&bytes[9]);
  if (encoding_size > bytes.size() - kFixed) return false;
  const auto* text = reinterpret_cast<const char*>(bytes.data()) + kFixed;
  call.encoding = {text, encoding_size};
  call.request = {text + encoding_size, bytes.size() - kFixed - encoding_size};
  return true;
}

}  // namespace galilean::monitor
