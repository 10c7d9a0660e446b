// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "core/clock.h"
#include "core/result.h"
#include "core/wire/participant.h"
#include "core/wire/reader.h"
#include "core/wire/writer.h"
#include "monitor/record/control/recorders.h"

namespace galilean::monitor {

/// A short-lived command's talk with a recorder. For use by one thread.
class RecorderClient {
 public:
  /// Errors: throws std::runtime_error if DDS refuses a topic.
  explicit RecorderClient(wire::Participant& participant);

  /// Returns how the recorder of this name is, or the only one if `name` is empty. Waits for it, at
  /// most `patience`. Errors: those of Recorders::find.
  [[nodiscard]] Result<RecorderStatus> find(const std::string& name, Duration patience);
  /// Sends the command to the recorder of this name, again and again until it has obeyed. Returns
  /// how it is then. Errors: it has not obeyed in time.
  [[nodiscard]] Result<RecorderStatus> send(msg::Command command, const std::string& name,
                                            Duration patience);

 private:
  bool wait(Duration most, const std::function<bool()>& enough);
  void listen();

  SteadyClock clock_;
  Recorders recorders_;
  wire::Reader statuses_;
  wire::Writer<msg::Command> commands_;
};

}  // namespace galilean::monitor
