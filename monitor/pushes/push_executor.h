// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "core/orders/signed_writer.h"
#include "core/result.h"
#include "core/wire/messages.h"
#include "core/wire/participant.h"
#include "core/wire/writer.h"
#include "monitor/background/worker.h"
#include "monitor/pushes/history/history.h"
#include "monitor/pushes/push_requests.h"
#include "monitor/pushes/trial_room.h"
#include "monitor/team/team.h"

namespace galilean::monitor {

/// Carries out the requests of pushes: checks, trials, DDS writes, and records in the history.
///
/// Lives on the io_context's thread. The disk and DDS writes happen on the worker's thread, one
/// after another, in the order of the requests. Checks take long, and happen on threads of their
/// own.
class PushExecutor {
 public:
  struct Parts {
    boost::asio::io_context& io;
    Worker& worker;
    Worker& checks;  ///< checks programs; may refuse one because too many wait
    Team& team;
    const ProgramLibrary& library;
    History& history;  ///< only the worker's thread uses it
    const TrialRoom& trials;
    std::shared_ptr<OrderSigner> signer = nullptr;  ///< signs the programs; null: nobody does
  };
  /// Reports the result of a request. It is called on the io_context's thread, and never from
  /// within `carry_out`.
  using Report = std::function<void(const std::string& push_id, const PushResult& result)>;

  PushExecutor(const Parts& parts, wire::Participant& participant, Report report);

  /// Begins a request of a push, whose result is then reported. Errors: it could not be begun.
  [[nodiscard]] Result<void> carry_out(const std::string& push_id, PushRequest request);
  /// Publishes how far a push is that the history holds.
  void publish(const PushRecord& push);
  /// Returns the push's trial; null if none is under way.
  [[nodiscard]] const Trial* trial(const std::string& push_id) const;

 private:
  Result<void> carry_out(const std::string& push_id, CheckProgram request);
  Result<void> carry_out(const std::string& push_id, RecordPush request);
  Result<void> carry_out(const std::string& push_id, TryProgram request);
  Result<void> carry_out(const std::string& push_id, EndTrial request);
  Result<void> carry_out(const std::string& push_id, SendProgram request);
  Result<void> carry_out(const std::string& push_id, RollBack request);
  Result<void> carry_out(const std::string& push_id, RecordReply request);
  Result<void> carry_out(const std::string& push_id, TellProgress request);
  void finish_trial(const std::string& push_id, const Result<TrialFigures>& figures);

  Parts parts_;
  Report report_;
  SignedWriter<msg::ProgramPush> pushes_;
  SignedWriter<msg::ProgramRollback> rollbacks_;
  wire::Writer<msg::PushProgress> progress_;
  std::map<std::string, std::unique_ptr<Trial>> trials_;  ///< under way, by their pushes' ids
};

}  // namespace galilean::monitor
