// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "monitor/programs/library.h"
#include "monitor/pushes/push_desk.h"
#include "monitor/server/api/outcome.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/limits/limit_counts.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// An operator's operations, the same over HTTP and as Foxglove services. Requests and answers are
/// JSON, as docs/openapi.yaml describes them. A request that is wrong finishes with 400 or 404. For
/// use on the io_context's thread, where `finish` is called, too.
class Operations {
 public:
  /// Commands and orders about break points go to DDS on `commands`, which does nothing else, so
  /// that a command never waits for a check, a push, a file or a map. Programs are checked on
  /// `checks`.
  Operations(Worker& commands, Worker& checks, const Team& team, const ProgramLibrary& library,
             PushDesk& desk, LimitCounts& limit_counts, wire::Participant& participant);

  void check(const nlohmann::json& request, Finish finish);
  void push(const nlohmann::json& request, Finish finish);
  /// Finishes with 404 if no such push is under way, or with 409 if it is too late. `request` is
  /// {id, author}.
  void cancel_push(const nlohmann::json& request, Finish finish);
  void command(const nlohmann::json& request, Finish finish);
  void order_breaks(const nlohmann::json& request, Finish finish);
  /// Adds push, cancel_push, breaks and every kind of command to the hub as services.
  void offer(foxglove::Hub& hub);

 private:
  /// Gives the message its id and stamp, and sends it. Finishes with 404 if it is for a robot that
  /// nobody has heard, and with 503 if DDS does not take messages as fast as they are ordered.
  template <class M>
  void send(wire::Writer<M>& writer, M message, Finish finish);

  Worker& command_worker_;
  Worker& checks_;
  const Team& team_;
  const ProgramLibrary& library_;
  PushDesk& desk_;
  LimitCounts& limit_counts_;
  wire::Writer<msg::Command> commands_;
  wire::Writer<msg::BreakOrder> break_orders_;
};

}  // namespace galilean::monitor
