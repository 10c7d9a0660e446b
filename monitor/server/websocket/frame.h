// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "monitor/ingest/channel.h"

namespace galilean::monitor {

/// One WebSocket frame from the server. All clients share the payload. The subscription's id
/// differs from client to client, so it stands in the head.
struct Frame {
  std::array<std::uint8_t, 10 + 13> head{};  ///< WebSocket's at most 10 bytes, then Foxglove's 13
  std::uint8_t head_size = 0;
  Payload payload;
  bool is_kept_anyway = false;  ///< the payload; it costs nothing to keep it for this client, too

  [[nodiscard]] std::span<const std::uint8_t> head_bytes() const {
    return std::span(head).first(head_size);
  }
  [[nodiscard]] std::size_t size() const { return head_size + (payload ? payload->size() : 0); }
  /// Returns how many bytes it takes to keep it for a client.
  [[nodiscard]] std::size_t kept_size() const { return is_kept_anyway ? head_size : size(); }
};

// The server's messages of Foxglove's protocol (ws-protocol, "Binary messages") as WebSocket frames
// (RFC 6455, 5.2).
[[nodiscard]] Frame text_frame(std::string_view text);
[[nodiscard]] Frame message_frame(std::uint32_t subscription_id, const Message& message);
[[nodiscard]] Frame message_frame(std::uint32_t subscription_id, std::uint64_t log_ns,
                                  Payload message);
[[nodiscard]] Frame binary_frame(std::vector<std::uint8_t> message);
[[nodiscard]] Frame time_frame(std::int64_t since_epoch_ns);
[[nodiscard]] Frame service_response_frame(std::uint32_t service_id, std::uint32_t call_id,
                                           std::string_view encoding, std::string_view answer);

/// A client's call of a service. `encoding` and `request` point into the bytes that they were read
/// from.
struct ServiceCall {
  std::uint32_t service_id = 0;
  std::uint32_t call_id = 0;
  std::string_view encoding;
  std::string_view request;
};
/// Reads a service call from a client's binary message into `call`.
/// Returns false if the bytes are no service call or are cut short; `call` may then be half filled.
[[nodiscard]] bool read_service_call(std::span<const std::uint8_t> bytes, ServiceCall& call);

}  // namespace galilean::monitor
