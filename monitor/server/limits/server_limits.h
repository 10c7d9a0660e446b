// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "core/json_text.h"

namespace galilean::monitor {

/// What clients may ask of the monitor, all together and each of them. docs/MONITOR.md has the
/// same as a table.
struct ServerLimits {
  // Connections.
  std::size_t connections = 2048;              ///< open at once, WebSockets included
  std::size_t connections_of_address = 256;    ///< open at once from one address
  std::size_t connections_of_loopback = 2000;  ///< the same, where all clients have one address
  /// Further connections, on which only requests with the operator's token are answered.
  std::size_t reserved_connections = 64;

  // HTTP.
  std::size_t header_bytes = std::size_t{16} << 10;
  std::size_t header_fields = 100;
  std::size_t bodies_bytes = std::size_t{64} << 20;  ///< of all bodies that are being read

  // WebSockets.
  std::size_t pings_per_s = 50;        ///< of one WebSocket
  std::size_t subscriptions = 10'000;  ///< of one WebSocket
  /// Of one WebSocket to one channel: each message of it is sent so often.
  std::size_t subscriptions_of_channel = 4;
  /// Of the events and answers that wait for all slow clients.
  std::size_t waiting_events_bytes = std::size_t{256} << 20;
  std::size_t waiting_calls = 64;  ///< service calls of one WebSocket without an answer
  std::size_t messages_bytes = std::size_t{64} << 20;  ///< of all messages that are being read
  JsonLimits message = {.bytes = std::size_t{512} << 10, .values = 20'000};  ///< a text message

  // Jobs that wait for a thread.
  std::size_t check_threads = 2;
  std::size_t waiting_checks = 32;      ///< programs to read or to check, and maps to draw
  std::size_t waiting_coverages = 16;   ///< recordings to count
  std::size_t waiting_recordings = 64;  ///< jobs on the folder of recordings: lists and openings
  std::size_t waiting_commands = 1000;

  // Requests' bodies, by their kinds.
  JsonLimits command = {.bytes = std::size_t{4} << 10, .values = 500};
  JsonLimits breaks = {.bytes = std::size_t{64} << 10, .values = 5000};
  JsonLimits program = {.bytes = std::size_t{8} << 20, .values = 5000};
};

}  // namespace galilean::monitor
