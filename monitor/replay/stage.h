// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>

#include "core/wire/byte_writer.h"
#include "core/wire/graph.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// The writers of a recording's topics. While a monitor is in the domain, the topics that a monitor
/// makes are left to it.
class Stage {
 public:
  /// Throws std::runtime_error if Cyclone refuses a topic.
  Stage(wire::Participant& participant, const std::map<std::uint16_t, Track>& tracks);

  /// Sends one message, unless its topic is left to the monitor.
  void send(std::uint16_t channel, std::span<const std::uint8_t> cdr);
  /// Opens or closes writers if a monitor came or went. Call it regularly. Throws
  /// std::runtime_error if Cyclone refuses a topic.
  void look();
  /// Returns the number of messages that were damaged or that DDS did not take in time.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  /// A topic, its type, and whose messages they are.
  using WriterKey = std::tuple<std::string, std::string, std::string>;
  [[nodiscard]] static WriterKey key_of(const Track& track) {
    return {track.topic, track.ros_type, track.sender};
  }

  wire::Participant& participant_;
  const std::map<std::uint16_t, Track>& tracks_;
  wire::Graph graph_;
  bool has_monitor_ = false;
  std::map<WriterKey, wire::ByteWriter> writers_;
  std::uint64_t lost_ = 0;
};

}  // namespace galilean::monitor
