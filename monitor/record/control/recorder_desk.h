// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"
#include "monitor/record/control/recorder_status.h"

namespace galilean::monitor {

/// Takes commands to one recorder off the wire, and tells how it is. For use by one thread.
class RecorderDesk {
 public:
  /// How often a recorder tells how it is, though nothing has changed.
  static constexpr Duration kTellEach = std::chrono::seconds(1);

  /// Takes the commands to recorders of this name, and those to all recorders.
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  RecorderDesk(wire::Participant& participant, std::string name);

  /// Returns the commands that came since the last call, in the order in which they came. One that
  /// is sent again, under the same id, is taken once.
  [[nodiscard]] std::vector<msg::Command> take();
  /// Publishes how the recorder is. Sets the name.
  void show(RecorderStatus status);

 private:
  [[nodiscard]] bool is_meant(const msg::Command& command) const;
  [[nodiscard]] bool is_new(const std::string& id);

  std::string name_;
  wire::Reader commands_;
  wire::Writer<msg::DiagnosticArray> statuses_;
  std::deque<std::string> known_ids_;  ///< of the newest commands
};

}  // namespace galilean::monitor
