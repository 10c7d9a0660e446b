// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/wire/byte_writer.h"
#include "core/wire/discovery.h"
#include "core/wire/graph.h"
#include "monitor/replay/tracks.h"

namespace galilean::monitor {

/// Where a recording's topics are written again. What a monitor makes of what it hears is left to
/// the monitor that is here, whenever there is one.
class Stage {
 public:
  /// Throws std::runtime_error if Cyclone refuses a topic.
  Stage(wire::Participant& participant, const std::map<std::uint16_t, Track>& tracks);

  /// Sends one message, unless that is left to the monitor.
  void send(std::uint16_t channel, std::span<const std::uint8_t> cdr);
  /// Sees whether a monitor came or went. To be called now and then.
  void look();
  /// Messages that could not be sent: damaged, or not taken in time.
  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }

 private:
  wire::Participant& participant_;
  const std::map<std::uint16_t, Track>& tracks_;
  wire::Graph graph_;
  bool has_monitor_ = false;
  std::map<std::uint16_t, wire::ByteWriter> writers_;
  std::uint64_t lost_ = 0;
};

/// Robots, and the referee, that are live in the domain and in the recording, too: with both, two
/// would talk at once under one name. Sorted. To be asked before there is a Stage.
[[nodiscard]] std::vector<std::string> live_namesakes(
    const std::vector<wire::Publication>& publications,
    const std::map<std::uint16_t, Track>& tracks);

}  // namespace galilean::monitor
