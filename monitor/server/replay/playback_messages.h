// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/result.h"
#include "monitor/server/websocket/frame.h"

namespace galilean::monitor {

// The messages of Foxglove's protocol for servers with the capability "playbackControl".

enum class PlaybackStatus : std::uint8_t { kPlaying = 0, kPaused = 1, kBuffering = 2, kEnded = 3 };

/// What a viewer asks of its playback.
struct PlaybackRequest {
  bool pause = false;  ///< else to play
  float speed = 1;
  std::optional<std::uint64_t> seek_ns;  ///< log time [ns since the Unix epoch]
  std::string id;                        ///< the answer carries it
};
/// Reads a client's binary message.
/// Errors: it is no such request, or cut short. The error is a sentence.
[[nodiscard]] Result<PlaybackRequest> read_playback_request(std::span<const std::uint8_t> bytes);

/// How a playback stands.
struct PlaybackState {
  PlaybackStatus status = PlaybackStatus::kPlaying;
  std::uint64_t now_ns = 0;  ///< log time [ns since the Unix epoch]
  float speed = 1;
  bool did_seek = false;
  std::string request_id;  ///< of the request that it answers; else empty
};
[[nodiscard]] Frame playback_state_frame(const PlaybackState& state);

}  // namespace galilean::monitor
