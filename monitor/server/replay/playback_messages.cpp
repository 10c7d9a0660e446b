// SPDX-License-Identifier: BSD-3-Clause
#include "monitor/server/replay/playback_messages.h"

#include <bit>
#include <utility>
#include <vector>

namespace galilean::monitor {
namespace {

constexpr std::uint8_t kPlaybackControlRequest = 3, kPlaybackState = 5;
constexpr std::uint8_t kPlay = 0, kPause = 1;
/// Behind the opcode: command, speed, whether there is a seek, its time, and the length of the id.
constexpr std::size_t kRequestFields = 1 + 4 + 1 + 8 + 4;
constexpr std::size_t kLongestId = 1024;

template <class Number>
Number little_endian_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  Number number = 0;
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    number |= static_cast<Number>(static_cast<Number>(bytes[at + i]) << (8 * i));
  return number;
}

template <class Number>
void append_little_endian(std::vector<std::uint8_t>& to, Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    to.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

}  // namespace

Result<PlaybackRequest> read_playback_request(std::span<const std::uint8_t> bytes) {
  if (bytes.empty() || bytes[0] != kPlaybackControlRequest)
    return Error{"A binary message to a replay must be a playback control request."};
  const auto fields = bytes.subspan(1);
  if (fields.size() < kRequestFields) return Error{"A playback control request is cut short."};
  if (fields[0] != kPlay && fields[0] != kPause)
    return Error{"A playback control request must be to play (0) or to pause (1)."};
  const auto id_bytes = little_endian_at<std::uint32_t>(fields, kRequestFields - 4);
  if (id_bytes > fields.size() - kRequestFields)
    return Error{"A playback control request is cut short."};
  if (id_bytes > kLongestId)
    return Error{"The id of a playback control request is longer than 1024 bytes."};
  PlaybackRequest request;
  request.pause = fields[0] == kPause;
  request.speed = std::bit_cast<float>(little_endian_at<std::uint32_t>(fields, 1));
  if (fields[5] != 0) request.seek_ns = little_endian_at<std::uint64_t>(fields, 6);
  const auto id = fields.subspan(kRequestFields, id_bytes);
  request.id.assign(id.begin(), id.end());
  return request;
}

Frame playback_state_frame(const PlaybackState& state) {
  std::vector<std::uint8_t> message{kPlaybackState, static_cast<std::uint8_t>(state.status)};
  append_little_endian(message, state.now_ns);
  append_little_endian(message, std::bit_cast<std::uint32_t>(state.speed));
  message.push_back(state.did_seek ? 1 : 0);
  append_little_endian(message, static_cast<std::uint32_t>(state.request_id.size()));
  message.insert(message.end(), state.request_id.begin(), state.request_id.end());
  return binary_frame(std::move(message));
}

}  // namespace galilean::monitor
