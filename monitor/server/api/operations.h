// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "core/orders/signed_writer.h"
#include "monitor/access/operator_id.h"
#include "monitor/lease/lease_desk.h"
#include "monitor/programs/library.h"
#include "monitor/pushes/order_log.h"
#include "monitor/pushes/push_desk.h"
#include "monitor/server/api/outcome.h"
#include "monitor/server/foxglove/foxglove_hub.h"
#include "monitor/server/limits/limit_counts.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// An operator's operations, the same over HTTP and as Foxglove services. Requests and answers are
/// JSON, as docs/openapi.yaml describes them. A request that is wrong finishes with 400 or 404. One
/// that steers robots whose leases others hold finishes with 409. For use on the io_context's
/// thread, where `finish` is called, too.
class Operations {
 public:
  struct Parts {
    Worker& commands;  ///< sends what moves robots, and does nothing else, so that a command never
                       ///< waits for a check, a push, a file, a map or the disk
    Worker& checks;    ///< checks programs
    const Team& team;
    const ProgramLibrary& library;
    PushDesk& desk;
    LeaseDesk& leases;
    OrderLog& orders;
    LimitCounts& limit_counts;
  };

  /// `signer` signs the orders; null: nobody does.
  Operations(const Parts& parts, wire::Participant& participant,
             const std::shared_ptr<OrderSigner>& signer = nullptr);

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
  /// Gives the message its id and stamp, and sends it; then has it kept, and finishes. An order
  /// that cannot be kept is sent all the same, and the answer says so. Finishes with 404 if it is
  /// for a robot that nobody has heard, with 409 if `who` may not give it, which is found out
  /// before it is signed and is kept, too, and with 503 if DDS does not take messages as fast as
  /// they are ordered.
  template <class M>
  void send(SignedWriter<M>& writer, M message, OrderKind kind, const OperatorId& who,
            Finish finish);

  /// Has an order kept that was sent, and finishes.
  template <class M>
  void keep(const M& message, const Finish& finish);
  /// Returns the robots of the team that are there and no recording.
  [[nodiscard]] std::vector<std::string> team_now() const;

  Parts parts_;
  SignedWriter<msg::Command> commands_;
  SignedWriter<msg::BreakOrder> break_orders_;
};

}  // namespace galilean::monitor
