// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "monitor/access/operator_id.h"
#include "monitor/lease/lease_desk.h"
#include "monitor/programs/library.h"
#include "monitor/pushes/push_desk.h"
#include "monitor/server/api/outcome.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// An operator's operations, the same over HTTP and as Foxglove services. Requests and answers are
/// JSON, as docs/openapi.yaml describes them. A request that is wrong finishes with 400 or 404. One
/// that steers robots whose leases others hold finishes with 409. For use on the io_context's
/// thread, where `finish` is called, too.
class Operations {
 public:
  Operations(Worker& worker, const Team& team, const ProgramLibrary& library, PushDesk& desk,
             LeaseDesk& leases, wire::Participant& participant);

  void check(const nlohmann::json& request, Finish finish);
  void push(const nlohmann::json& request, const OperatorId& who, Finish finish);
  /// Finishes with 404 if no such push is under way, or with 409 if it is too late. `request` is
  /// {id, author}. Everybody may stop a push.
  void cancel_push(const nlohmann::json& request, const OperatorId& who, Finish finish);
  void command(const nlohmann::json& request, const OperatorId& who, Finish finish);
  void order_breaks(const nlohmann::json& request, const OperatorId& who, Finish finish);
  /// Asks for leases, answers who asks, takes leases over or ends them. `request` is {do, robots,
  /// reason}.
  void change_lease(const nlohmann::json& request, const OperatorId& who, Finish finish);
  /// Returns whether `who` may give this order, and gives them the leases that it needs. Without
  /// `targets` it is for the team. If they may not, `finish` is called with 409.
  [[nodiscard]] bool admits(OrderKind kind, const OperatorId& who,
                            const std::vector<std::string>& targets, const Finish& finish);
  /// Adds push, cancel_push, breaks, lease and every kind of command to the hub as services.
  void offer(foxglove::Hub& hub);

 private:
  /// Gives the message its id and stamp, and sends it. Finishes with 404 if it is for a robot that
  /// nobody has heard, and with 409 if `who` may not give it.
  template <class M>
  void send(wire::Writer<M>& writer, M message, OrderKind kind, const OperatorId& who,
            Finish finish);
  /// Returns the robots of the team that are there and no recording.
  [[nodiscard]] std::vector<std::string> team_now() const;

  Worker& worker_;
  const Team& team_;
  const ProgramLibrary& library_;
  PushDesk& desk_;
  LeaseDesk& leases_;
  wire::Writer<msg::Command> commands_;
  wire::Writer<msg::BreakOrder> break_orders_;
};

}  // namespace galilean::monitor
